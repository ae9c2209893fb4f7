// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/Segment.h"

#include <algorithm>
#include <utility>

namespace handwheel {
Segment::Segment(const ValueRange& range, const std::array<int, 3>& size, std::vector<Brick> bricks)
    : m_range(range), m_count(bricksOf(size)), m_bricks(std::move(bricks)) {}

std::array<int, 3> Segment::bricksOf(const std::array<int, 3>& size) {
  std::array<int, 3> count;
  std::transform(size.begin(), size.end(), count.begin(), [](int n) { return (n + 15) >> 4; });
  return count;
}

bool Segment::contains(const ImageVolume& image, const VoxelIndex& sample) const {
  return readSegment(image, *this, [&](const auto& reader) { return reader.at(sample.x(), sample.y(), sample.z()); });
}

SegmentBrick Segment::filledBrick(const ImageVolume& image, const VoxelIndex& sample) const {
  if (const SegmentBrick* const brick = brickOf(sample.x(), sample.y(), sample.z())) return *brick;
  SegmentBrick filled;
  const std::array<int, 3>& size = image.grid().size;
  const VoxelIndex first = sample.unaryExpr([](int i) { return i & ~15; });
  readSegment(image, *this, [&](const auto& reader) {
    for (int z = first.z(); z < std::min(first.z() + SegmentBrick::kSide, size[2]); ++z)
      for (int y = first.y(); y < std::min(first.y() + SegmentBrick::kSide, size[1]); ++y)
        for (int x = first.x(); x < std::min(first.x() + SegmentBrick::kSide, size[0]); ++x)
          if (reader.at(x, y, z)) filled.set(x & 15, y & 15, z & 15, true);
  });
  return filled;
}

void Segment::setBrick(const std::array<int, 3>& size, const VoxelIndex& sample, Brick brick) {
  if (m_bricks.empty()) {
    m_count = bricksOf(size);
    m_bricks.resize(static_cast<std::size_t>(m_count[0]) * static_cast<std::size_t>(m_count[1]) *
                    static_cast<std::size_t>(m_count[2]));
  }
  m_bricks[brickAt(sample.x(), sample.y(), sample.z())] = std::move(brick);
}

bool Segment::operator==(const Segment& other) const {
  return m_range.least == other.m_range.least && m_range.largest == other.m_range.largest && m_bricks == other.m_bricks;
}

std::size_t Segment::bytesBeside(const Segment& other) const {
  std::size_t own = 0;
  for (std::size_t i = 0; i < m_bricks.size(); ++i)
    if (m_bricks[i] && (i >= other.m_bricks.size() || m_bricks[i] != other.m_bricks[i])) ++own;
  return m_bricks.size() * sizeof(Brick) + own * sizeof(SegmentBrick);
}

}  // namespace handwheel
