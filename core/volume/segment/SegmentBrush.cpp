// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SegmentBrush.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The points within a radius of a line segment; mm.
struct Capsule {
  Vec3 from, displacement;
  double radius;

  // Returns the squared distance of a point from the line segment.
  double squaredDistance(const Vec3& p) const {
    const double squares = displacement.squaredNorm();
    const double share = squares > 0.0 ? std::clamp((p - from).dot(displacement) / squares, 0.0, 1.0) : 0.0;
    return (p - from - share * displacement).squaredNorm();
  }
};

}  // namespace

void applyBrush(Segment& segment, const ImageVolume& image, const SegmentBrush& brush, const Vec3& from,
                const Vec3& to) {
  const ImageGrid& grid = image.grid();
  Vec3 start = from, end = to;
  if (brush.plane) start[*brush.plane] = end[*brush.plane] = std::round(to[*brush.plane]);
  const Capsule capsule{grid.position(start), grid.steps * (end - start), brush.radius};
  // The row of the inverse gives the extent of a ball along an axis of the index.
  const Vec3 reach = brush.radius * grid.steps.inverse().rowwise().norm();
  VoxelIndex low, high;
  for (int k = 0; k < 3; ++k) {
    const double last = grid.size[static_cast<std::size_t>(k)] - 1;
    const double span = brush.plane == k ? 0.0 : reach[k];
    const double least = std::ceil(std::min(start[k], end[k]) - span),
                 largest = std::floor(std::max(start[k], end[k]) + span);
    if (!(largest >= 0.0) || !(least <= last)) return;
    low[k] = static_cast<int>(std::max(least, 0.0));
    high[k] = static_cast<int>(std::min(largest, last));
  }
  // From the middle of a brick to its samples, at most.
  const double half = 0.5 * (SegmentBrick::kSide - 1) * grid.steps.colwise().norm().sum();
  const VoxelIndex firstBrick = low.unaryExpr([](int i) { return i & ~15; });
  for (int bz = firstBrick.z(); bz <= high.z(); bz += SegmentBrick::kSide)
    for (int by = firstBrick.y(); by <= high.y(); by += SegmentBrick::kSide)
      for (int bx = firstBrick.x(); bx <= high.x(); bx += SegmentBrick::kSide) {
        const VoxelIndex first(bx, by, bz);
        const double middle = std::sqrt(capsule.squaredDistance(
            grid.position(first.cast<double>() + Vec3::Constant(0.5 * (SegmentBrick::kSide - 1)))));
        if (middle > brush.radius + half) continue;
        const bool isWithin = middle < brush.radius - half;
        const VoxelIndex begin = first.cwiseMax(low), stop = (first.array() + 15).matrix().cwiseMin(high);
        const SegmentBrick before = segment.filledBrick(image, first);
        auto brick = std::make_shared<SegmentBrick>(before);
        for (int z = begin.z(); z <= stop.z(); ++z)
          for (int y = begin.y(); y <= stop.y(); ++y)
            for (int x = begin.x(); x <= stop.x(); ++x)
              if (isWithin || capsule.squaredDistance(grid.position(Vec3(x, y, z))) <= brush.radius * brush.radius)
                brick->set(x & 15, y & 15, z & 15, !brush.isErasing);
        if (brick->rows != before.rows) segment.setBrick(grid.size, first, std::move(brick));
      }
}

}  // namespace handwheel
