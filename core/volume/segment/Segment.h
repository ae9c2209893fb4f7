// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"
#include "volume/image/ImageVolume.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace handwheel {

// A brick of 16³ samples of an image, with one bit per sample. The sample (x, y, z) is bit x of row 16 z + y.
struct SegmentBrick {
  static constexpr int kSide = 16;
  std::array<std::uint16_t, kSide * kSide> rows{};

  static std::size_t rowOf(int y, int z) { return static_cast<std::size_t>(z * kSide + y); }
  bool at(int x, int y, int z) const { return (rows[rowOf(y, z)] >> x & 1) != 0; }
  void set(int x, int y, int z, bool isIn) {
    const auto bit = static_cast<std::uint16_t>(1 << x);
    std::uint16_t& row = rows[rowOf(y, z)];
    row = static_cast<std::uint16_t>(isIn ? row | bit : row & ~bit);
  }
};

// A part of an image, defined by a range of values and by bricks. In a brick that is present, the segment contains the
// samples whose bits are set; everywhere else it contains the samples with values in the range. So a range alone takes
// no memory, and painting takes only the memory of the bricks that it touches.
//
// Segment is a value type: copies share bricks. Reading different copies on different threads is safe.
class Segment {
 public:
  using Brick = std::shared_ptr<const SegmentBrick>;

  Segment() = default;
  explicit Segment(const ValueRange& range) : m_range(range) {}
  // bricks: the bricks of a whole image of this size, in the order of brickAt(). A null brick is defined by the range.
  Segment(const ValueRange& range, const std::array<int, 3>& size, std::vector<Brick> bricks);

  const ValueRange& range() const { return m_range; }
  bool isByRangeAlone() const { return m_bricks.empty(); }
  // Returns the bricks of the whole image, in the order of brickAt(). The result is empty if all bricks are defined by
  // the range.
  std::span<const Brick> bricks() const { return m_bricks; }
  bool hasValue(double value) const { return value >= m_range.least && value <= m_range.largest; }

  // Returns the brick that contains a sample, or null if that brick is defined by the range.
  const SegmentBrick* brickOf(int x, int y, int z) const {
    return m_bricks.empty() ? nullptr : m_bricks[brickAt(x, y, z)].get();
  }
  // Returns true if a sample is in the segment. O(1).
  bool contains(const ImageVolume& image, const VoxelIndex& sample) const;

  // Returns a copy of the brick that contains a sample, evaluated if it is defined by the range. O(samples of a brick).
  SegmentBrick filledBrick(const ImageVolume& image, const VoxelIndex& sample) const;
  // Replaces the brick that contains a sample, in an image of this size.
  void setBrick(const std::array<int, 3>& size, const VoxelIndex& sample, Brick brick);

  bool operator==(const Segment& other) const;  // compares pointers to bricks, not samples
  // Returns the memory of the bricks that are not shared with the other segment, bytes.
  std::size_t bytesBeside(const Segment& other) const;

  static std::array<int, 3> bricksOf(const std::array<int, 3>& size);

 private:
  std::size_t brickAt(int x, int y, int z) const {
    return (static_cast<std::size_t>(z >> 4) * static_cast<std::size_t>(m_count[1]) +
            static_cast<std::size_t>(y >> 4)) *
               static_cast<std::size_t>(m_count[0]) +
           static_cast<std::size_t>(x >> 4);
  }

  ValueRange m_range{0.0, 0.0};
  std::array<int, 3> m_count{0, 0, 0};  // number of bricks along each axis
  std::vector<Brick> m_bricks;          // empty: all bricks are defined by the range
};

// Reads the membership of an image's samples in a segment. The image and the segment must outlive the reader.
template <class Sample>
class SegmentReader {
 public:
  SegmentReader(const ImageVolume& image, std::span<const Sample> samples, const Segment& segment)
      : m_samples(samples), m_size(image.grid().size), m_segment(segment) {}

  std::size_t indexOf(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(m_size[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(m_size[0]) +
           static_cast<std::size_t>(x);
  }
  bool at(int x, int y, int z) const {
    const SegmentBrick* const brick = m_segment.brickOf(x, y, z);
    if (!brick) return m_segment.hasValue(static_cast<double>(m_samples[indexOf(x, y, z)]));
    return brick->at(x & 15, y & 15, z & 15);
  }
  // Reads a row along x: sets 1 for samples in the segment, and 0 for the others.
  void readRow(int y, int z, std::span<std::uint8_t> row) const {
    for (int x = 0; x < m_size[0]; ++x) row[static_cast<std::size_t>(x)] = at(x, y, z) ? 1 : 0;
  }

 private:
  std::span<const Sample> m_samples;
  std::array<int, 3> m_size;
  const Segment& m_segment;
};

// Calls visit with a SegmentReader for the sample type of the image, and returns its result.
template <class Visit>
auto readSegment(const ImageVolume& image, const Segment& segment, Visit visit) {
  return image.visitSamples([&]<class Sample>(std::span<const Sample> samples) {
    return visit(SegmentReader<Sample>(image, samples, segment));
  });
}

}  // namespace handwheel
