// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <span>
#include <vector>

namespace handwheel {

// Tracks the distance between a surface being simplified and the original. Points of the original, its vertices and
// some on each face, are assigned to the face of the present surface that they were found nearest to among those that
// replaced their last.
class ErrorTracker {
 public:
  // Invalid if cancelled. error: mm. density: of the sample points, in that of the original's vertices; above 0.
  ErrorTracker(const HalfEdgeMesh& original, double error, int density, Progress progress);

  // Whether the faces "old" may be replaced by "replacements": the latter lie, at points on them, within the error of
  // the original, and the points assigned to the former within it of the latter. The first corner of a replacement is
  // the new one; the edge opposite to it was there before.
  bool allows(std::span<const Face> old, std::span<const TrianglePoints> replacements);

  // After the same call of allows(): replacement i has become the face named.
  void replace(std::span<const Face> old, std::span<const Face> by);

 private:
  void assign(Face f, const Vec3& p);
  void assignInner(Face f, const TrianglePoints& t);
  bool isNear(const TrianglePoints& t) const;
  bool isAssignedNear(std::uint32_t point, std::span<const TrianglePoints> replacements);

  SurfaceDistance m_original;
  double m_error;
  double m_spacing = 0.0;             // of points, mm
  std::vector<Vec3> m_points;         // of the original's surface
  std::vector<std::uint32_t> m_head;  // per face: the first point assigned to it
  std::vector<std::uint32_t> m_next;  // per point

  struct Assigned {
    std::uint32_t point;
    std::uint32_t replacement;
  };
  std::vector<Assigned> m_moves;  // of the last allows()
  std::vector<Box> m_boxes;       // of its replacements
};

}  // namespace handwheel
