// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <QColor>
#include <QPointF>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace handwheel {

// The ways to draw surfaces.
enum class Shading { Shaded, ShadedWithEdges, Wireframe };

// The standard view directions. x is to the right and z up when seen from the front.
enum class StandardView { Front, Back, Left, Right, Top, Bottom, Isometric };

// A boundary loop drawn on the model. The last point is connected to the first.
struct LoopMark {
  int id = -1;
  std::vector<Vec3> points;
  QColor colour;
  bool emphasised = false;
};

// A set of faces drawn in one colour over the model (flipped, degenerate, self-intersecting…).
struct FaceMark {
  std::vector<Face> faces;
  QColor colour;
};

// Dots of constant size on the screen (non-manifold or near-coincident vertices).
struct PointMark {
  std::vector<Vec3> points;
  QColor colour;
};

// Single segments (non-manifold edges).
struct LineMark {
  std::vector<std::pair<Vec3, Vec3>> segments;
  QColor colour;
};

// A line of a section through the model. When closed, the last point is connected to the first.
struct SectionMark {
  std::vector<Vec3> points;
  bool closed = true;
};

// The circle of a brush on the surface.
struct BrushCircle {
  Vec3 centre = Vec3::Zero();  // mm
  double radius = 0.0;         // mm

  bool operator==(const BrushCircle&) const = default;
};

// The object under the cursor: a loop, a face or a part. A loop within 8 pixels takes precedence over the surface it
// lies on.
struct Pick {
  int loop = -1;
  Face face = kNone;
  Vec3 point = Vec3::Zero();  // on the object; undefined when nothing was hit
  std::string part;           // its name, when one of the parts was hit

  bool isNothing() const { return loop < 0 && face == kNone && part.empty(); }
};

// The pick ray through a position of the view.
struct ViewRay {
  Vec3 origin = Vec3::Zero();  // the eye; under parallel projection a point in front of the whole model
  Vec3 direction = -Vec3::UnitZ();
  std::optional<Vec3> eye;  // none under parallel projection
  double pixel = 0.0;       // mm per logical pixel, at the focus of the view
};

// A mouse event of the view, for tools.
struct PointerInput {
  enum class Kind {
    Move,
    Press,
    Release,
    Click,  // pressed and released in one place, after the press was not accepted
    DoubleClick,
    Wheel,
    Leave,
  };
  Kind kind = Kind::Move;
  QPointF position;                       // logical pixels from the upper left corner
  Qt::MouseButton button = Qt::NoButton;  // that was pressed, released or clicked
  Qt::MouseButtons held;                  // held after the event
  Qt::KeyboardModifiers modifiers;
  double wheel = 0.0;  // degrees; positive away from the user
};

}  // namespace handwheel
