// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/search/SurfaceDistance.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// The squared distance of points to a triangle, if it is within a limit. Most points are beside the triangle or in
// front of it, where the planes through its edges tell.
class ReachOfTriangle {
 public:
  explicit ReachOfTriangle(const TrianglePoints& t);

  // Returns the squared distance, or any larger number than the limit if the point is farther.
  double squaredDistance(const Vec3& p, double limit) const;

 private:
  TrianglePoints m_corners;
  Box m_box;
  Vec3 m_normal;                   // unit vector
  std::array<Vec3, 3> m_outwards;  // unit vectors in the plane, away from the edge that begins at each corner
};

// Tracks the distance between a surface being simplified and the original. Points of the original, its vertices and
// some on each face, are assigned to faces of the current surface: when a face is replaced, each of its points is
// assigned to the nearest of the replacements.
class ErrorTracker {
 public:
  // Samples the original. The object is invalid if cancelled. error: the largest allowed distance, mm. density: the
  // density of the sample points relative to the original's vertices, above 0.
  ErrorTracker(const HalfEdgeMesh& original, double error, int density, Progress progress);

  void setError(double error) { m_error = error; }

  // Returns true if the faces "old" may be replaced by "replacements". Points on the replacements must be within the
  // error of the original, and the points assigned to the old faces within the error of the replacements. The first
  // corner of a replacement is the new one; the edge opposite to it existed before.
  bool allows(std::span<const Face> old, std::span<const TrianglePoints> replacements);

  // Reassigns points after a call of allows() with the same old faces: replacement i has become face by[i].
  void replace(std::span<const Face> old, std::span<const Face> by);

 private:
  void assign(Face f, const Vec3& p);
  void assignInner(Face f, const TrianglePoints& t);
  // A triangle of the original near the last point that was tested, and its distance from that point, mm.
  struct Near {
    std::optional<std::uint32_t> triangle;
    double distance = 0.0;
  };
  // Returns true if a point is within the error of the original. The triangle of the previous point is tested first.
  bool isNear(const Vec3& p, Near& near) const;
  // Returns true if points of an edge are within the error. `near` is that of its beginning, which is not tested again.
  // The points are one step apart, or as far as the distance of the last one allows.
  bool isEdgeNear(const Vec3& from, const Vec3& to, Near near) const;
  bool isInnerNear(const TrianglePoints& t, Near near) const;
  bool isAssignedNear(std::uint32_t point);

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
  std::vector<Assigned> m_moves;           // assignments by the last allows()
  std::vector<ReachOfTriangle> m_reaches;  // reaches of the replacements in the last allows()
};

}  // namespace handwheel
