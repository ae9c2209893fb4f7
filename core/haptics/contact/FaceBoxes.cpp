// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/FaceBoxes.h"

#include "proximity/SimdFloat4.h"

namespace handwheel {
namespace {

// Larger than the rounding of a coordinate of at most a side.
constexpr float kFloatRounding = 0x1p-20f;

}  // namespace

FaceBoxes::FaceBoxes() {
  for (FourBoxes& four : m_boxes) {
    four.low.fill(Four::Zero());
    four.high.fill(Four::Zero());
  }
}

void FaceBoxes::clear(const Box& region) {
  const double side = region.sizes().maxCoeff();
  m_middle = region.center();
  m_scale = side > 0.0 ? 1.0 / side : 0.0;
}

void FaceBoxes::set(std::size_t i, const TrianglePoints& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 low = inRegion(a.cwiseMin(b).cwiseMin(c)).cwiseMax(-1.0);
  const Vec3 high = inRegion(a.cwiseMax(b).cwiseMax(c)).cwiseMin(1.0);
  FourBoxes& four = m_boxes[i / 4];
  for (std::size_t k = 0; k < 3; ++k) {
    four.low[k][static_cast<int>(i % 4)] = static_cast<float>(low[static_cast<int>(k)]);
    four.high[k][static_cast<int>(i % 4)] = static_cast<float>(high[static_cast<int>(k)]);
  }
}

std::uint64_t FaceBoxes::meeting(const Vec3& p, const Vec3& step, double near, std::size_t count) const {
  const float margin = static_cast<float>(m_scale * near) + kFloatRounding;
  const Eigen::Array3f from = inRegion(p).cast<float>(), to = inRegion(p + step).cast<float>();
  const Eigen::Array3f low = from.min(to) - margin, high = from.max(to) + margin;
  std::uint64_t met = 0;
  for (std::size_t i = 0; i < count; i += 4) {
    const FourBoxes& four = m_boxes[i / 4];
    const Four x = (four.low[0] - high[0]).max(low[0] - four.high[0]);
    const Four y = (four.low[1] - high[1]).max(low[1] - four.high[1]);
    const Four z = (four.low[2] - high[2]).max(low[2] - four.high[2]);
    met |= std::uint64_t{atMost(x.max(y).max(z), Four::Zero())} << i;
  }
  return count < kCapacity ? met & ((std::uint64_t{1} << count) - 1) : met;
}

}  // namespace handwheel
