// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <QPointF>
#include <cstdint>
#include <optional>

namespace handwheel {

// The drawing styles of surfaces.
enum class Shading { Shaded, ShadedWithEdges, Wireframe };

// The standard view directions. In the front view, x is to the right and z is up. Lathe is the view of the operator of
// a lathe, whose axis is z: the chuck is on the left, and the tool between work and viewer.
enum class StandardView { Front, Back, Left, Right, Top, Bottom, Isometric, Lathe };

// The circle of a brush on the surface.
struct BrushCircle {
  Vec3 centre = Vec3::Zero();  // mm
  double radius = 0.0;         // mm

  bool operator==(const BrushCircle&) const = default;
};

class ViewLayer;

// The element of a layer that is under the cursor or on a ray. The meaning of the element's number depends on the
// layer: see faceOf() and loopOf() of MeshLayer.h, partOf() of PartsLayer.h.
struct Pick {
  const ViewLayer* layer = nullptr;  // null: nothing was hit
  std::uint64_t element = 0;
  Vec3 point = Vec3::Zero();  // point on the element; undefined if nothing was hit
  double distance = 0.0;      // distance from the origin of the ray, mm, or from the cursor if isNear, pixels
  bool isNear = false;        // the element is near the cursor (a line, for example), not on the ray

  bool isNothing() const { return layer == nullptr; }
};

// The pick ray through a position of the view.
struct ViewRay {
  Vec3 origin = Vec3::Zero();  // the eye, or under parallel projection a point in front of the whole model
  Vec3 direction = -Vec3::UnitZ();
  std::optional<Vec3> eye;  // position of the eye; none under parallel projection
  double pixel = 0.0;       // mm per logical pixel, at the focus of the view
};

// A mouse event of the view, for tools.
struct PointerInput {
  enum class Kind {
    Move,
    Press,
    Release,
    Click,  // the button was pressed and released without a move, and the press was not accepted
    DoubleClick,
    Wheel,
    Leave,
  };
  Kind kind = Kind::Move;
  QPointF position;                       // logical pixels from the upper left corner
  Qt::MouseButton button = Qt::NoButton;  // the button that was pressed, released or clicked
  Qt::MouseButtons held;                  // buttons that are held after the event
  Qt::KeyboardModifiers modifiers;
  double wheel = 0.0;  // rotation of the wheel, degrees; positive away from the user
  // Time of the event by the clock of the window system, s; not the time when the window processed the event. It has no
  // value if it is unknown.
  std::optional<double> time = {};
  std::optional<double> pressure = {};  // pressure of a pen that reports it, 0 to 1; none for other pointers
};

}  // namespace handwheel
