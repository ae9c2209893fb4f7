// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/ViewportPrivate.h"
#include "viewport/overlay/Overlay.h"

#include <qopenglcontext_platform.h>
#include <QGuiApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLPaintDevice>
#include <QSurfaceFormat>
#include <algorithm>

namespace handwheel {

namespace {

constexpr double kUnevenFrameMs = 30.0;  // ms: for slower frames, edges are not smoothed while the camera moves
constexpr int kCubeMargin = 8;           // logical pixels to the corner of the view
// ms: for slower frames, the simplified version follows the mouse instead of the model
constexpr double kSlowFrameMs = 60.0;

bool isUsable(const QOpenGLContext& context) {
  const QSurfaceFormat format = context.format();
  return context.nativeInterface<QNativeInterface::QGLXContext>() != nullptr &&
         std::pair(format.majorVersion(), format.minorVersion()) >= std::pair(3, 2);
}

}  // namespace

void Viewport::prepareApplication() {
  if (!qEnvironmentVariableIsSet("QT_XCB_GL_INTEGRATION")) qputenv("QT_XCB_GL_INTEGRATION", "xcb_glx");
  // Under Wayland its X server is used; without one, graphicsFailed() reports it.
  const bool hasX = !qEnvironmentVariableIsEmpty("DISPLAY");
  if (hasX && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

QString Viewport::platformProblem() {
  if (QGuiApplication::platformName() == QLatin1String("xcb")) return {};
  return tr("The 3D view needs an X server, and this session runs on “%1”. Start the program in an X11 session, or in "
            "a Wayland session with Xwayland.")
      .arg(QGuiApplication::platformName());
}

Viewport::~Viewport() {
  if (!context()) return;
  disconnect(context(), nullptr, this, nullptr);
  makeCurrent();
  d->glWindow.detach();
  doneCurrent();
}

void Viewport::Private::report(const QString& what) {
  if (problem == what) return;
  problem = what;
  if (!problem.isEmpty()) emit q->graphicsFailed(problem);
}

void Viewport::Private::detachGl() {
  q->makeCurrent();
  glWindow.detach();
  q->doneCurrent();
}

// May run again, with another context, after the widget has moved to another window.
void Viewport::initializeGL() {
  if (!isUsable(*context())) {
    d->report(
        tr("The 3D view needs OpenGL 3.2 through an X server (GLX), which this session does not offer. Start the "
           "program in an X11 session, or in a Wayland session with Xwayland."));
    return;
  }
  d->report({});
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { d->detachGl(); });
  d->glWindow.attach(this);
  d->isStale = true;
}

void Viewport::showEvent(QShowEvent* event) {
  QOpenGLWidget::showEvent(event);
  // Without a context, initializeGL() is never called; by the next turn of the event loop it must have been.
  QTimer::singleShot(0, this, [this] {
    if (isVisible() && !isValid()) {
      d->report(
          tr("The 3D view could not start: the display offers no OpenGL. Check the graphics driver, or whether "
             "the X server provides GLX."));
    }
  });
}

void Viewport::resizeGL(int, int) {
  d->isStale = true;
}

void Viewport::update() {
  d->isStale = true;
  QOpenGLWidget::update();
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  d->cube->move(width() - d->cube->width() - kCubeMargin, kCubeMargin);
}

void Viewport::paintGL() {
  if (!d->glWindow.isAttached()) return;
  std::exchange(d->isStale, false) ? d->draw() : d->glWindow.drawAgain();
  d->paintOver();
}

// Paints on a paint device of its own, not on the widget: while a window takes a picture of itself, painting on its
// widgets goes elsewhere.
void Viewport::Private::paintOver() {
  const double ratio = q->devicePixelRatioF();
  QOpenGLPaintDevice device((QSizeF(q->size()) * ratio).toSize());
  device.setDevicePixelRatio(ratio);
  QPainter painter(&device);
  if (!polylines.empty()) paintLines(painter, navigation(), polylines, scene.colours());
  if (!brushLine.empty()) paintLines(painter, navigation(), {brushLine}, scene.colours());
  if (deviceCursor) paintCursor(painter, *deviceCursor, navigation(), scene.colours());
  paintOverlay(painter, q->size(), camera, unit, scene.colours());
  scene.paintOver(painter, q->size(), unit);
}

// While the camera moves, a slow display gives up first the smoothing of edges, then the fine triangles.
void Viewport::Private::draw() {
  const bool uploads = scene.uploadPendingGeometry();
  const bool owesMarks = scene.takeMarks();
  if (uploads || owesMarks) q->update();  // for the next block, or at last for an undisturbed frame
  const bool isReduced = isMoving() && fullFrameMs > kSlowFrameMs;
  scene.setCoarseShown(isReduced);
  const bool isSmooth = !isMoving() || fullFrameMs <= kUnevenFrameMs;
  scene.renderer()->SetUseFXAA(isSmooth);
  const double ratio = q->devicePixelRatioF();
  scene.prepare(camera, size(), ratio);

  const CpuTimes start = CpuTimes::now();
  glWindow.draw((QSizeF(q->size()) * ratio).toSize());
  // Software rendering continues after the call returns.
  q->context()->functions()->glFinish();
  isSeen = true;
  ++framesDrawn;
  const CpuTimes spent = CpuTimes::now() - start;
  timeDrawing = timeDrawing + spent;
  if (isReduced || uploads || owesMarks) return;
  fullFrameMs = isSmooth ? spent.clock : std::max(fullFrameMs, spent.clock);
}

QImage Viewport::grabImage() {
  d->scene.finish();
  return grabFramebuffer();
}

}  // namespace handwheel
