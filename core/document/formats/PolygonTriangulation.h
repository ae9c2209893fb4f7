// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace handwheel {

// Triangulates the polygons of a file by fans or ear clipping. Ear clipping is for polygons that are planar and not
// strictly convex, for which a fan may have triangles outside the polygon or without area. Reuses its buffers for the
// next polygon.
class PolygonTriangulation {
 public:
  // Result of cut().
  enum class Outcome {
    Done,
    TooComplex,  // too many corners for ear clipping; some triangles may lie outside the polygon
    Stopped,     // keepGoing returned false
  };

  // keepGoing is called every few milliseconds of ear clipping.
  explicit PolygonTriangulation(std::function<bool()> keepGoing) : m_keepGoing(std::move(keepGoing)) {}

  // Appends corners.size() - 2 triangles that use the polygon's corners only, with its orientation. Precondition: at
  // least three corners, each an index into points. O(corners); ear clipping is O(corners²), but all calls together
  // make no more than 100 tests per corner and 150 million.
  Outcome cut(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners,
              std::vector<Triangle>& triangles);

 private:
  using Vec2 = Eigen::Vector2d;

  bool flatten(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners);
  bool isStrictlyConvex() const;
  Outcome clipEars(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles);
  void linkRing();
  void unlink(std::uint32_t corner);
  bool isEar(std::uint32_t corner);
  bool isReflex(std::uint32_t corner) const;

  std::function<bool()> m_keepGoing;
  std::uint64_t m_allowedTests = 150'000'000;  // tests of a corner against an ear; about a second
  std::uint64_t m_tests = 0;                   // made so far
  std::uint64_t m_nextLook = 0;                // number of tests at which keepGoing is called next
  std::vector<Vec2> m_flat;                    // the corners in the polygon's plane, counter-clockwise
  std::vector<std::uint32_t> m_previous, m_next;
  std::vector<std::uint32_t> m_reflex;  // corners that may lie inside an ear; some may have become convex since
};

}  // namespace handwheel
