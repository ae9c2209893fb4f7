// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <QColor>
#include <QPointF>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace handwheel {

enum class Shading { Shaded, ShadedWithEdges, Wireframe };

// Axis convention: x to the right and z up when seen from the front.
enum class StandardView { Front, Back, Left, Right, Top, Bottom, Isometric };

// One closed line on the model, and how it looks. The last point joins the first.
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

// A line along which the model is cut. Closed: the last point joins the first.
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

// What is under the cursor: a loop, a face of the mesh or a part. A loop within 8 pixels wins over what it lies on.
struct Pick {
  int loop = -1;
  Face face = kNone;
  Vec3 point = Vec3::Zero();  // on what was hit; meaningless when nothing was
  std::string part;           // its name, when one of the parts was hit

  bool isNothing() const { return loop < 0 && face == kNone && part.empty(); }
};

// The line of sight through a position of the view.
struct ViewRay {
  Vec3 origin = Vec3::Zero();  // the eye; under parallel projection a point before the whole model
  Vec3 direction = -Vec3::UnitZ();
  std::optional<Vec3> eye;  // none under parallel projection
  double pixel = 0.0;       // mm to a logical pixel, at the focus of the view
};

// What the mouse does over the view, as a tool may want it.
struct PointerInput {
  enum class Kind {
    Move,
    Press,
    Release,
    Click,  // pressed and released on one spot, the press having been left to the camera
    DoubleClick,
    Wheel,
    Leave,
  };
  Kind kind = Kind::Move;
  QPointF position;                       // logical pixels from the upper left corner
  Qt::MouseButton button = Qt::NoButton;  // the one that is pressed, released or clicked
  Qt::MouseButtons held;                  // those that are down afterwards
  Qt::KeyboardModifiers modifiers;
  double wheel = 0.0;  // degrees; positive away from the user
};

}  // namespace handwheel
