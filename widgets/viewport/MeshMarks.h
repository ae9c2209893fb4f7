// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <QColor>
#include <utility>
#include <vector>

namespace handwheel {

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

}  // namespace handwheel
