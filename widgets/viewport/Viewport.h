// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/ThreadClock.h"
#include "viewport/ClipPlane.h"
#include "viewport/DeviceCursor.h"
#include "viewport/ViewportTypes.h"
#include "viewport/camera/CameraState.h"
#include "viewport/camera/NavigationPreset.h"

#include <QImage>
#include <QOpenGLWidget>
#include <functional>
#include <memory>

namespace handwheel {

// A 3D view of layers. The mouse moves the camera; signals report the element under the cursor. All calls must be made
// on the window thread. Lengths and positions are in units of the model (mm).
class Viewport : public QOpenGLWidget {
  Q_OBJECT
 public:
  // Sets the surface format and selects GLX, the only window system interface that the renderer supports. To be called
  // once before QApplication is constructed.
  static void prepareApplication();

  // Returns a translated sentence that states why this application cannot show viewports. The result is empty if it
  // can. To be called before a viewport is constructed: on Qt's offscreen platform, a window with a QOpenGLWidget in it
  // crashes (seen with Qt 6.4).
  static QString platformProblem();

  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  // Shows a layer until it is removed. The view does not depend on the kinds of layers.
  void addLayer(std::shared_ptr<ViewLayer> layer);
  void removeLayer(const ViewLayer& layer);
  Box bounds() const;  // bounding box of the visible layers

  // Draws lines over everything, such as a lasso or a ruler.
  void setPolylines(std::vector<std::vector<Vec3>> lines);
  // Draws the circle of a brush, which follows the surface around its centre.
  void setBrush(const std::optional<BrushCircle>& brush);

  // Draws the cursor of a haptic device over everything. The view computes the shadow of the cursor and whether the
  // model hides it. cursor: nothing if there is no device. The model is not redrawn when the cursor moves.
  void setDeviceCursor(const std::optional<DeviceCursor>& cursor);

  void setShading(Shading shading);
  Shading shading() const;
  void setDarkTheme(bool dark);
  // Sets the clipping plane. Objects on the side of its normal are neither drawn nor picked. The range of offsets that
  // meet the model is clipOffsets(bounds(), normal).
  void setClipPlane(const ClipPlane& plane);
  const ClipPlane& clipPlane() const;
  // Sets the unit of the scale bar.
  void setDisplayUnit(LengthUnit unit);
  void setViewCubeVisible(bool visible);
  // Sets if the sides of the view cube are those of a patient (ViewCube::setPatient()).
  void setOfPatient(bool isPatient);

  // Sets the rotation of the standard views and the view cube relative to the coordinate axes. The initial rotation is
  // the identity.
  void setViewFrame(const Eigen::Quaterniond& frame);
  void setStandardView(StandardView view);  // shows the whole model from a side, animated
  void fit();                               // shows the whole model from the present side, animated
  // Sets the number of pixels at the lower edge that are covered, which fitting avoids. If the camera has not moved
  // since the last fit, the model is fitted again at once.
  void setCovered(int pixels);
  // Moves the camera, animated, so that it looks at a box from outside. outward: the direction from the box to the
  // viewer, not necessarily of unit length; zero: keep the present direction.
  void flyTo(const Box& box, const Vec3& outward);
  CameraState camera() const;  // the present camera, or the goal of its animation
  void setCamera(const CameraState& camera);
  // Moves the camera as if the model were carried. The model turns about pivot by the rotation vector `turn`, moves by
  // shift.x and shift.y times the height of the view, and is enlarged by exp(shift.z). Vectors are in the axes of the
  // view: x right, y up, z towards the viewer.
  void moveByHand(const Vec3& pivot, const Vec3& shift, const Vec3& turn);
  // Changes the projection and keeps the scale at the focus. The projection is part of the camera state: setCamera()
  // may change it, too.
  void setProjection(Projection projection);
  Projection projection() const { return camera().projection; }

  void setNavigationPreset(NavigationPreset preset);
  NavigationPreset navigationPreset() const;
  // Returns pairs of input and effect for the hint bar, translated.
  std::vector<std::pair<QString, QString>> navigationHints() const;
  // Sets a function that gets mouse events before the camera and returns whether it accepts them. After it has accepted
  // a press it gets all moves and the release, until that button is released. It gets no events of a drag that moves
  // the camera. Null: no function.
  void setPointerSink(std::function<bool(const PointerInput&)> sink);

  // Returns the view as an image, in device pixels. Waits until the whole model is uploaded.
  QImage grabImage();
  // Picks the element at this position of the widget. Elements that are not yet searchable are not picked.
  Pick pickAt(const QPointF& position) const;
  // Returns the first element along a ray, for tools. The direction must have unit length.
  Pick pickAlong(const Vec3& origin, const Vec3& direction) const;
  bool isPickingReady() const;
  ViewRay rayAt(const QPointF& position) const;

  // Returns a translated sentence that states why nothing can be drawn. The result is empty if there is no problem.
  QString graphicsProblem() const;
  // Return the numbers of geometry builds of the layers and of drawn frames since construction. They are for tests.
  int blocksBuilt() const;
  int framesDrawn() const;
  CpuTimes timeDrawing() const;  // total time in the renderer, for measurements

  QSize sizeHint() const override;

 signals:
  void hovered(const handwheel::Pick& pick);  // pick: the element under the cursor, if any
  void clicked(const handwheel::Pick& pick, Qt::KeyboardModifiers modifiers);
  void doubleClicked(const handwheel::Pick& pick);
  void cameraChanged();
  void clipPlaneChanged();
  void graphicsFailed(const QString& problem);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintGL() override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  // Requests that the model is drawn again. Other repaints show the last frame again.
  void update();

  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace handwheel
