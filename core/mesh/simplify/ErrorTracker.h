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
// some on each face, are assigned to faces of the current surface: when a face is replaced, each of its points is
// assigned to the nearest of the replacements.
class ErrorTracker {
 public:
  // Samples the original. The object is invalid if cancelled. error: the largest allowed distance, mm. density: the
  // density of the sample points relative to the original's vertices, above 0.
  ErrorTracker(const HalfEdgeMesh& original, double error, int density, Progress progress);

  // Returns true if the faces "old" may be replaced by "replacements". Points on the replacements must be within the
  // error of the original, and the points assigned to the old faces within the error of the replacements. The first
  // corner of a replacement is the new one; the edge opposite to it existed before.
  bool allows(std::span<const Face> old, std::span<const TrianglePoints> replacements);

  // Reassigns points after a call of allows() with the same old faces: replacement i has become face by[i].
  void replace(std::span<const Face> old, std::span<const Face> by);

 private:
  void assign(Face f, const Vec3& p);
  void assignInner(Face f, const TrianglePoints& t);
  bool isNear(const TrianglePoints& t) const;
  bool isAssignedNear(std::uint32_t point, std::span<const TrianglePoints> replacements);

  SurfaceDistance m_original;
  double m_error;
  double m_spacing = 0.0;             // distance of sample points, mm
  std::vector<Vec3> m_points;         // points on the original's surface
  std::vector<std::uint32_t> m_head;  // first point assigned to each face
  std::vector<std::uint32_t> m_next;  // next point assigned to the same face, for each point

  struct Assigned {
    std::uint32_t point;
    std::uint32_t replacement;
  };
  std::vector<Assigned> m_moves;  // assignments by the last allows()
  std::vector<Box> m_boxes;       // boxes of the replacements in the last allows()
};

}  // namespace handwheel
