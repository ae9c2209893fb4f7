// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "proximity/TriangleIntersection.h"

#include <array>
#include <cstdint>

namespace handwheel {

// The boxes of a few triangles, told from a segment four at a time and without a branch: which of them it meets changes
// from sweep to sweep, and to guess it wrong costs a processor more than the sums. On the servo thread: fixed memory.
class FaceBoxes {
 public:
  static constexpr std::size_t kCapacity = 64;  // as bits in meeting()

  FaceBoxes();

  // What is added from now on counts as far as it lies in this region.
  void clear(const Box& region);
  // The i-th, which is to be below kCapacity.
  void set(std::size_t i, const TrianglePoints& corners);

  // Bit i is set when box i of the first count comes near the segment from p along a step within the region; at times
  // when it only nearly does.
  std::uint64_t meeting(const Vec3& p, const Vec3& step, double near, std::size_t count) const;

 private:
  using Four = Eigen::Array4f;
  struct FourBoxes {
    std::array<Four, 3> low, high;  // along each axis, in sides of the region from its middle
  };

  Vec3 inRegion(const Vec3& p) const { return m_scale * (p - m_middle); }

  Vec3 m_middle = Vec3::Zero();
  double m_scale = 0.0;  // 1/mm
  std::array<FourBoxes, kCapacity / 4> m_boxes;
};

}  // namespace handwheel
