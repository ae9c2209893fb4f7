// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "proximity/TriangleIntersection.h"

#include <array>
#include <cstdint>

namespace handwheel {

// Bounding boxes of a few triangles, tested against a segment four at a time. The tests have no branches: their results
// change from sweep to sweep, and a misprediction costs more than the arithmetic. The boxes are used on the servo
// thread, and take a fixed amount of memory.
class FaceBoxes {
 public:
  // Number of bits of the result of meeting(). If there are more triangles, each is tested individually, with the same
  // result.
  static constexpr std::size_t kCapacity = 64;

  FaceBoxes();

  // Sets the region to which boxes are clipped that are set after the call.
  void clear(const Box& region);
  // Sets box i, which must be below kCapacity.
  void set(std::size_t i, const TrianglePoints& corners);

  // Returns a bit mask of the first `count` boxes. Bit i is set if box i is within `near` (mm) of the bounding box of
  // the segment from p along `step`, inside the region. Bits of boxes slightly farther away may be set, too.
  std::uint64_t meeting(const Vec3& p, const Vec3& step, double near, std::size_t count) const;

 private:
  using Four = Eigen::Array4f;
  struct FourBoxes {
    std::array<Four, 3> low, high;  // along each axis, relative to the region's centre, in units of its side
  };

  Vec3 inRegion(const Vec3& p) const { return m_scale * (p - m_middle); }

  Vec3 m_middle = Vec3::Zero();
  double m_scale = 0.0;  // 1/mm
  std::array<FourBoxes, kCapacity / 4> m_boxes;
};

}  // namespace handwheel
