// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/snap/SnapField.h"

namespace handwheel {

// The closed boundary loop of a hole, without its mesh. The lists have equal length. The numbers are those by which a
// tool identifies the held feature.
struct SnapLoop {
  std::uint32_t number = kNone;             // number of the loop
  std::span<const Vec3> points;             // mm
  std::span<const std::uint32_t> vertices;  // the number of each point
  std::span<const std::uint32_t> edges;     // the number of the edge from each point to the next
};

// The kinds of features of a boundary loop to which the tip snaps.
struct SnapOffer {
  bool vertices = true;  // SnapKind::Point
  // SnapKind::Segment: edges pull individually, so that summed forces are larger at vertices.
  bool edges = true;
  bool curves = false;  // SnapKind::Curve, along which the tip slides
};

// Features around the holes of a mesh, for tools that select, pull and stitch.
struct LoopSnapField {
  SnapField field;
  double spacing = 0.0;  // mean length of an edge, mm

  // Returns the snap distance for the setting snap.radius, mm. Without edges it is 0, so that there is no force.
  double distance(const FidelityValues& values) const;
};

// Builds the snap field of boundary loops. It is called on a worker thread. The result is empty if cancelled.
LoopSnapField snapSceneOf(std::span<const SnapLoop> loops, SnapOffer offer, Progress progress = {});

}  // namespace handwheel
