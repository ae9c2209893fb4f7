// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace handwheel {

// The triangulation of the polygons of a file by fans or ear clipping. Ear clipping is used for planar polygons that
// are not strictly convex, because a fan of such a polygon may have triangles outside of it or without area. Corners
// within rounding of a line count as on it, so that no triangle reaches past them. Buffers are reused for the next
// polygon.
class PolygonTriangulation {
 public:
  // Result of cut().
  enum class Outcome {
    Done,
    TooComplex,  // too many corners for ear clipping; some triangles may lie outside the polygon
    Stopped,     // keepGoing returned false
  };

  // Prepares the triangulation of polygons. keepGoing: a function that is called every few milliseconds during ear
  // clipping; if it returns false, cut() stops.
  explicit PolygonTriangulation(std::function<bool()> keepGoing) : m_keepGoing(std::move(keepGoing)) {}

  // Appends corners.size() - 2 triangles with the polygon's corners and orientation. There must be at least three
  // corners, each an index into points. O(corners); ear clipping is O(corners²), but all calls together make at most
  // 150 million tests plus 100 for each corner.
  Outcome cut(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners,
              std::vector<Triangle>& triangles);

 private:
  using Vec2 = Eigen::Vector2d;

  bool flatten(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners);
  bool isStrictlyConvex();
  Outcome clipEars(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles);
  void linkRing();
  void listReflex(std::uint32_t first);
  void unlink(std::uint32_t corner);
  bool isEar(std::uint32_t corner);
  bool isReflex(std::uint32_t corner) const;

  std::function<bool()> m_keepGoing;
  std::uint64_t m_allowedTests = 150'000'000;  // tests of a corner against an ear; about a second
  double m_size = 0.0;                         // extent of the polygon
  double m_slack = 0.0;                        // a corner is on a line if it is at most so far from it
  std::uint64_t m_tests = 0;                   // number of tests so far
  std::uint64_t m_nextLook = 0;                // number of tests at which keepGoing is called next
  std::vector<Vec2> m_flat;                    // the corners in the polygon's plane, counter-clockwise
  std::vector<std::uint32_t> m_previous, m_next;
  std::vector<std::uint32_t> m_reflex;  // corners that may lie inside an ear; some may have become convex since
};

}  // namespace handwheel
