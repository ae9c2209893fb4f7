// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "proximity/BoxTree.h"

#include <span>
#include <vector>

namespace handwheel {

// The coordinate frame of single-precision boxes. The model is shifted to its middle and scaled into [-1, 1] by a power
// of two, so that the boxes keep their resolution far from the origin, in any unit, and around the model even if a
// stray vertex is far away.
class BoxFrame {
 public:
  BoxFrame() = default;
  explicit BoxFrame(std::span<const Vec3> points);

  // Converts a point to the frame. The conversion is monotonic: a coordinate of the result never decreases when that of
  // p increases, so boxes that overlap in the model overlap in the frame.
  Vec3 toFrame(const Vec3& p) const { return p * m_scale - m_shift; }
  double scale() const { return m_scale; }

  // Returns the box of a triangle, widened by at least 2^-23 of its coordinates in the frame.
  FloatBox around(const Vec3& a, const Vec3& b, const Vec3& c) const;

 private:
  double m_scale = 1.0;
  Vec3 m_shift = Vec3::Zero();
};

// The treatment of triangles without area.
enum class FlatTriangles { Keep, LeaveOut };

// Computes the boxes of all triangles with finite coordinates, in their order. The computation is parallel. Returns an
// empty list if cancelled.
std::vector<BoxedItem> boxedTriangles(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                      const BoxFrame& frame, FlatTriangles flat, Progress progress = {});

}  // namespace handwheel
