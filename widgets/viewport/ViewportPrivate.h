// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/CameraFlight.h"
#include "viewport/GlWindow.h"
#include "viewport/MeshPreparation.h"
#include "viewport/Scene.h"
#include "viewport/Viewport.h"

#include <QTimer>
#include <optional>

namespace handwheel {

// What a held mouse button does.
enum class Drag { None, Orbit, Pan };

// What the widget is made of; shared by the files that draw and that listen to the mouse.
class Viewport::Private {
 public:
  explicit Private(Viewport* widget);

  // Camera
  Vec2 size() const { return {q->width(), q->height()}; }
  CameraNavigation navigation() const { return {camera, size()}; }
  void moveTo(const CameraState& state);
  void flyTo(const CameraState& goal);
  void fitFrom(const Eigen::Quaterniond& orientation);
  const CameraState& goal() const { return flight.isUnderWay() ? flight.goal() : camera; }

  // Drawing
  void report(const QString& problem);
  void detachGl();
  void draw();
  bool isMoving() const { return drag != Drag::None || flight.isUnderWay() || rest.isActive(); }
  std::vector<std::size_t> blocksAround(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                        const std::vector<Face>& touched) const;

  // Mouse
  void press(const QMouseEvent& event);
  void dragTo(const Vec2& cursor);
  void endDrag();
  void hover(const Pick& pick);
  Pick pick(const Vec2& cursor) const;
  Vec3 orbitPivot(const Pick& underCursor) const;

  Viewport* q;
  Scene scene;
  GlWindow glWindow;
  CameraState camera;
  std::optional<CameraState> fitted;  // where the camera was last sent to see the whole model
  CameraFlight flight;
  MeshPreparation::Index index;
  MeshPreparation preparation;
  Shading shading = Shading::Shaded;
  QString problem;
  bool isSeen = false;       // a frame of this model was drawn; before, the camera leaps instead of flying
  int covered = 0;           // pixels at the lower edge
  double fullFrameMs = 0.0;  // what a frame in full detail took last
  QTimer rest;               // runs while the wheel turns

  Qt::MouseButton button = Qt::NoButton;  // held since the press that is being followed
  Drag intended = Drag::None;             // what the button does once the mouse has moved far enough
  Drag drag = Drag::None;
  Vec2 pressed = Vec2::Zero();
  Vec2 last = Vec2::Zero();
  Vec3 pivot = Vec3::Zero();
  Pick hovered;
  int listLoop = -1;
};

}  // namespace handwheel
