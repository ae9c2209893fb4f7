// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/SurfaceTile.h"

#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace handwheel {

SurfaceTile::Corners::Corners(const Vec3& first, const Vec3& second, const Vec3& third)
    : a(first), b(second), c(third) {
  const Vec3 cross = (b - a).cross(c - a);
  const double length = cross.norm();
  normal = length > 0.0 ? Vec3(cross / length) : Vec3::Zero();
}

SurfaceTile::SurfaceTile(const VoxelIndex& first)
    : m_first(first), m_squared(static_cast<std::size_t>(kSide * kSide * kSide), kFar) {}

void SurfaceTile::add(const Corners& t) {
  const Vec3 lowest = t.low(), highest = t.high();
  const VoxelIndex low = (lowest.array() - kBand).ceil().cast<int>().max(m_first.array());
  const VoxelIndex high = (highest.array() + kBand).floor().cast<int>().min(m_first.array() + kSide - 1);
  const auto beside = [&](double v, Eigen::Index axis) { return std::max({0.0, lowest[axis] - v, v - highest[axis]}); };
  const double slope = t.normal.x();
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y) {
      const double offset = t.normal.dot(Vec3(0.0, y, z) - t.a);
      const double besideRow = beside(y, 1) * beside(y, 1) + beside(z, 2) * beside(z, 2);
      float* row = &m_squared[index(0, y - m_first.y(), z - m_first.z())];
      for (int x = low.x(); x <= high.x(); ++x) {
        float& least = row[x - m_first.x()];
        // No point of the triangle is nearer than its plane, or than its box.
        const double fromPlane = offset + slope * x, besideBox = beside(x, 0);
        if (std::max(fromPlane * fromPlane, besideRow + besideBox * besideBox) >= static_cast<double>(least)) continue;
        const Vec3 p(x, y, z);
        least = std::min(least, static_cast<float>((closestOnTriangle(p, t.a, t.b, t.c) - p).squaredNorm()));
      }
    }
}

SparseVolume::Block SurfaceTile::signedBlock(const VoxelIndex& inTile, const ScanlineCrossings& rows) const {
  constexpr int n = VolumeBlock::kSize;
  bool isNear = false;
  for (int i = 0; i < n * n * n && !isNear; ++i)
    isNear = squared(inTile + VoxelIndex(i % n, i / n % n, i / n / n)) < kFar;
  if (!isNear) return nullptr;
  auto block = std::make_shared<VolumeBlock>();
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const VoxelIndex at = inTile + VoxelIndex(x, y, z);
        block->depths[VolumeBlock::at(x, y, z)] = sampleAt(squared(at), rows.isInside(m_first + at));
      }
  return block;
}

std::int16_t SurfaceTile::sampleAt(float squared, bool isInside) {
  if (squared >= kFar) return isInside ? VolumeBlock::kFull : VolumeBlock::kEmpty;
  const std::int16_t depth = depthSample(std::sqrt(static_cast<double>(squared)));
  return isInside ? depth : static_cast<std::int16_t>(-depth);
}

}  // namespace handwheel
