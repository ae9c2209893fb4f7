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
// of two, so that the boxes keep their resolution far from the origin, in any unit, and where the model is although a
// stray vertex is far out.
class BoxFrame {
 public:
  BoxFrame() = default;
  explicit BoxFrame(std::span<const Vec3> points);

  // Monotonic: it never decreases when p increases, so what overlaps in the model overlaps in the frame.
  Vec3 toFrame(const Vec3& p) const { return p * m_scale - m_shift; }
  double scale() const { return m_scale; }

  // The box of a triangle, wider by at least 2^-23 of its coordinates in the frame.
  FloatBox around(const Vec3& a, const Vec3& b, const Vec3& c) const;

 private:
  double m_scale = 1.0;
  Vec3 m_shift = Vec3::Zero();
};

// Whether triangles without area are kept.
enum class FlatTriangles { Keep, LeaveOut };

// Computes the boxes of all triangles with finite coordinates, in their order. Parallel. None when cancelled.
std::vector<BoxedItem> boxedTriangles(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                      const BoxFrame& frame, FlatTriangles flat, Progress progress = {});

}  // namespace handwheel
