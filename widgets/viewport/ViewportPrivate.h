// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/GlWindow.h"
#include "viewport/Scene.h"
#include "viewport/Viewport.h"
#include "viewport/camera/CameraFlight.h"
#include "viewport/overlay/ViewCube.h"

#include <QTimer>
#include <optional>

class QSinglePointEvent;

namespace handwheel {

// The private data of Viewport, shared by its source files. Some of these files draw, others handle the mouse.
class Viewport::Private {
 public:
  explicit Private(Viewport* widget);

  // Functions for the camera.
  Vec2 size() const { return {q->width(), q->height()}; }
  CameraNavigation navigation() const { return {camera, size()}; }
  void moveTo(const CameraState& state);
  void flyTo(const CameraState& goal);
  void fitFrom(const Eigen::Quaterniond& orientation);
  void lookFrom(const CubeRegion& region);
  Eigen::Quaterniond inViewFrame(const Eigen::Quaterniond& orientation) const {
    return viewFrame.conjugate() * orientation;
  }
  const CameraState& goal() const { return flight.isUnderWay() ? flight.goal() : camera; }

  // Functions for drawing.
  void report(const QString& problem);
  void detachGl();
  void draw();
  void paintOver();
  bool isMoving() const { return gesture != NavigationGesture::None || flight.isUnderWay() || rest.isActive(); }
  void layerChanged(const ViewLayer& layer, LayerChange change);

  // Functions for the mouse.
  bool offer(PointerInput::Kind kind, const QSinglePointEvent& event, double wheel = 0.0) const;
  void press(const QMouseEvent& event);
  void follow(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  void startGesture(NavigationGesture next);
  void dragTo(const Vec2& cursor);
  void zoomAbout(const Vec3& fixed, double factor);
  void hover(const Pick& pick);
  Pick pick(const Vec2& cursor) const;
  Vec3 orbitPivot(const Pick& underCursor) const;
  void connectCube();

  // Functions for tools.
  void layBrush();
  void cast(DeviceCursor& shown) const;  // computes the shadow of the cursor, and sets whether the model hides it

  Viewport* q;
  Scene scene;
  GlWindow glWindow;
  CameraState camera;
  Eigen::Quaterniond viewFrame = Eigen::Quaterniond::Identity();  // set by setViewFrame()
  int fittedFor = 0;                  // pixels at the lower edge that were covered when `fitted` was chosen
  std::optional<CameraState> fitted;  // camera of the last fit of the whole model
  CameraFlight flight;
  QString problem;
  bool isSeen = false;       // a frame of this model was drawn; camera moves are animated only after the first frame
  int covered = 0;           // number of covered pixels at the lower edge
  double fullFrameMs = 0.0;  // duration of the last frame in full detail
  bool isStale = true;       // the last frame is outdated
  int framesDrawn = 0;
  CpuTimes timeDrawing;
  QTimer rest;  // runs for a short time after each turn of the wheel

  NavigationPreset preset = NavigationPreset::Handwheel;
  std::function<bool(const PointerInput&)> sink;
  std::optional<double> pressure;  // last reported pressure of the pen
  Qt::MouseButtons taken;          // held buttons whose press the sink accepted
  Qt::MouseButtons followed;       // held buttons whose press the camera got
  bool isClick = false;            // the press may still become a click
  bool isOnBackground = false;
  NavigationGesture intended = NavigationGesture::None;  // gesture that starts when the mouse has moved far enough
  NavigationGesture gesture = NavigationGesture::None;
  Vec2 pressed = Vec2::Zero();
  Vec2 last = Vec2::Zero();
  Vec3 pivot = Vec3::Zero();
  Pick hovered;

  ViewCube* cube;
  LengthUnit unit = LengthUnit::Millimetre;
  std::vector<std::vector<Vec3>> polylines;
  std::optional<BrushCircle> brush;
  std::vector<Vec3> brushLine;
  std::optional<DeviceCursor> deviceCursor;
};

}  // namespace handwheel
