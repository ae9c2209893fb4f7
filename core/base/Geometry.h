// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace handwheel {

using Vec3 = Eigen::Vector3d;
using Box = Eigen::AlignedBox3d;
using Pose = Eigen::Isometry3d;  // rotation and translation, mm

// Three vertex indices, counter-clockwise when seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

// The invalid index, which means no vertex, face or half-edge.
inline constexpr std::uint32_t kNone = 0xffffffffu;

// The floating-point type in which a file stores coordinates. The file is one that was read, or one that will be
// written.
enum class NumberType { Float32, Float64 };

// Rounds a number or a point to the number type of a file. Negative zero becomes zero, so that equal positions have
// equal bits.
inline double rounded(double v, NumberType type) {
  // The variable is volatile because GCC 12 at -O2 otherwise dropped the rounding.
  volatile float single = static_cast<float>(v);
  const double r = type == NumberType::Float32 ? static_cast<double>(single) : v;
  return r == 0.0 ? 0.0 : r;
}

inline Vec3 rounded(const Vec3& p, NumberType type) {
  return {rounded(p.x(), type), rounded(p.y(), type), rounded(p.z(), type)};
}

}  // namespace handwheel
