// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <QColor>
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

// What is under the cursor. A loop within 8 pixels wins over the face; face is kNone then.
struct Pick {
  int loop = -1;
  Face face = kNone;
  Vec3 point = Vec3::Zero();  // on the loop or the face; meaningless when nothing was hit

  bool isNothing() const { return loop < 0 && face == kNone; }
};

}  // namespace handwheel
