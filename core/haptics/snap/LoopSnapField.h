// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/snap/SnapField.h"

namespace handwheel {

// The closed boundary loop of a hole, as lists of equal length. So no mesh is needed; the numbers are those by which a
// tool identifies the held feature.
struct SnapLoop {
  std::uint32_t number = kNone;             // number of the loop
  std::span<const Vec3> points;             // mm
  std::span<const std::uint32_t> vertices;  // the number of each point,
  std::span<const std::uint32_t> edges;     // and of the edge from it to the next
};

// The features of a boundary loop to snap to.
struct SnapOffer {
  bool vertices = true;  // SnapKind::Point
  bool edges = true;     // SnapKind::Segment: each pulls by itself, so that summed forces are larger at vertices
  bool curves = false;   // SnapKind::Curve: to slide along
};

// Features around the holes of a mesh, for tools that select, pull and stitch.
struct LoopSnapField {
  SnapField field;
  double spacing = 0.0;  // mm, the mean length of an edge

  // Returns the snap distance (mm) for the setting snap.radius. 0, and thus no force, without an edge.
  double distance(const FidelityValues& values) const;
};

// Builds the snap scene of boundary loops. On a worker. Empty if cancelled.
LoopSnapField snapSceneOf(std::span<const SnapLoop> loops, SnapOffer offer, Progress progress = {});

}  // namespace handwheel
