// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Viewport.h"

#include "viewport/ViewportPrivate.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kFitShare = 0.86;  // share of the view, filled by the whole model
// share of the view, filled by the goal of a flight: its surroundings show the position
constexpr double kFlyToShare = 0.38;
// A flight never magnifies more than this share of the model's diagonal to the height of the view.
constexpr double kNearestFlight = 0.02;

}  // namespace

Viewport::Private::Private(Viewport* widget)
    : q(widget),
      glWindow(scene.renderer()),
      flight([this](const CameraState& state) { moveTo(state); }),
      cube(new ViewCube(widget)) {
  camera.orientation = orientationOf(StandardView::Isometric);
  cube->setOrientation(camera.orientation);
  connectCube();
  rest.setSingleShot(true);
  rest.setInterval(200);
  QObject::connect(&rest, &QTimer::timeout, q, [this] { q->update(); });
}

void Viewport::Private::layerChanged(const ViewLayer& layer, LayerChange change) {
  if (change == LayerChange::OutOfMemory)
    return emit q->graphicsFailed(Viewport::tr("There is not enough memory to draw all of the model."));
  if (change == LayerChange::Search) return layBrush();
  if (change == LayerChange::Look && !layer.isVisible()) return;
  if (change == LayerChange::Model) isSeen = false;
  if (change != LayerChange::Look && hovered.layer == &layer) hover({});
  q->update();
}

void Viewport::Private::moveTo(const CameraState& state) {
  camera = state;
  cube->setOrientation(inViewFrame(camera.orientation));
  q->update();
  emit q->cameraChanged();
}

void Viewport::Private::flyTo(const CameraState& goal) {
  if (isSeen && q->isVisible()) return flight.start(camera, goal);
  flight.stop();
  moveTo(goal);
}

void Viewport::Private::fitFrom(const Eigen::Quaterniond& orientation) {
  CameraState from = goal();
  from.orientation = orientation;
  fitted = CameraNavigation(from, size()).fitted(scene.outline(), kFitShare, covered);
  fittedFor = covered;
  flyTo(*fitted);
}

Viewport::Viewport(QWidget* parent) : QOpenGLWidget(parent), d(std::make_unique<Private>(this)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::ClickFocus);
  // The right button drags; a menu that opens on its press would disturb that.
  setContextMenuPolicy(Qt::PreventContextMenu);
  setMinimumSize(200, 150);
  setObjectName(QStringLiteral("viewport"));
  setAccessibleName(tr("3D view"));
  // The mouse goes on while a frame is drawn: a line drawn with it is made of all its positions. (Qt's X11 plugin asks
  // for compression when the application starts.)
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

void Viewport::addLayer(std::shared_ptr<ViewLayer> layer) {
  d->scene.add(std::move(layer),
               [this](const ViewLayer& changed, LayerChange change) { d->layerChanged(changed, change); });
  update();
}

void Viewport::removeLayer(const ViewLayer& layer) {
  if (d->hovered.layer == &layer) d->hover({});
  d->scene.remove(layer);
  update();
}

void Viewport::setShading(Shading shading) {
  d->scene.setShading(shading);
  update();
}

Shading Viewport::shading() const {
  return d->scene.shading();
}

void Viewport::setDarkTheme(bool dark) {
  d->scene.setDark(dark);
  d->cube->setColours(d->scene.colours());
  update();
}

void Viewport::setViewFrame(const Eigen::Quaterniond& frame) {
  d->viewFrame = frame;
  d->cube->setOrientation(d->inViewFrame(d->camera.orientation));
}

void Viewport::setStandardView(StandardView view) {
  d->fitFrom(view == StandardView::Lathe ? orientationOf(view) : d->viewFrame * orientationOf(view));
}

void Viewport::fit() {
  d->fitFrom(d->goal().orientation);
}

void Viewport::setCovered(int pixels) {
  d->covered = pixels;
  // Only once: a card that grows later must not zoom the view.
  if (pixels > 0 && d->fittedFor == 0 && d->fitted == d->goal()) fit();
}

void Viewport::flyTo(const Box& box, const Vec3& outward) {
  if (box.isEmpty()) return;
  CameraState from = d->goal();
  from.orientation = turnedTowards(from.orientation, outward, d->viewFrame * Vec3::UnitZ());
  CameraState goal = CameraNavigation(from, d->size()).fitted(cornersOf(box), kFlyToShare, d->covered);
  const Box whole = d->scene.bounds();
  if (!whole.isEmpty()) goal.height = std::max(goal.height, kNearestFlight * whole.diagonal().norm());
  d->flyTo(goal);
}

CameraState Viewport::camera() const {
  return d->goal();
}

void Viewport::setCamera(const CameraState& camera) {
  d->flight.stop();
  d->moveTo(camera);
}

void Viewport::moveByHand(const Vec3& pivot, const Vec3& shift, const Vec3& turn) {
  d->flight.stop();
  d->moveTo(d->navigation().movedByHand(pivot, shift.head<2>(), turn));
  if (shift.z() != 0) d->zoomAbout(d->camera.centre, std::exp(shift.z()));
}

Pick Viewport::pickAlong(const Vec3& origin, const Vec3& direction) const {
  return handwheel::pickAlong(d->scene.pickable(), origin, direction);
}

Pick Viewport::pickAt(const QPointF& position) const {
  return d->pick({position.x(), position.y()});
}

bool Viewport::isPickingReady() const {
  return d->scene.isSearchable() && !d->scene.bounds().isEmpty();
}

QString Viewport::graphicsProblem() const {
  return d->problem;
}

int Viewport::blocksBuilt() const {
  return d->scene.builtCount();
}

int Viewport::framesDrawn() const {
  return d->framesDrawn;
}

CpuTimes Viewport::timeDrawing() const {
  return d->timeDrawing;
}

QSize Viewport::sizeHint() const {
  return {960, 640};
}

}  // namespace handwheel
