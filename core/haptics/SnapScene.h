// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/SnapField.h"

namespace handwheel {

// The rim of a hole, all the way round. As plain lists of equal length, so that no mesh is needed; the numbers are
// those by which a tool knows what the hand holds.
struct SnapRim {
  std::uint32_t number = kNone;             // of the loop
  std::span<const Vec3> points;             // mm
  std::span<const std::uint32_t> vertices;  // the number of each point,
  std::span<const std::uint32_t> edges;     // and of the edge from it to the next
};

// What the hand is offered of rims.
struct SnapOffer {
  bool vertices = true;  // SnapKind::Point
  bool edges = true;     // SnapKind::Segment: each pulls by itself, so that summed forces are larger at vertices
  bool rims = false;     // SnapKind::Curve: to slide along
};

// Features around the holes of a mesh, for tools that select, pull and stitch.
struct SnapScene {
  SnapField field;
  double spacing = 0.0;  // mm, the mean length of an edge

  // The snap distance (mm) that the setting snap.radius makes of it. 0, and thus no force, without an edge.
  double distance(const FidelityValues& values) const;
};

// On a worker. Empty once cancelled.
SnapScene snapSceneOf(std::span<const SnapRim> rims, SnapOffer offer, Progress progress = {});

}  // namespace handwheel
