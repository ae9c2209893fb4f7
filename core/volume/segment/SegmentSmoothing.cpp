// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SegmentSmoothing.h"

#include <tbb/parallel_for.h>
#include <algorithm>

namespace handwheel {

// Counts the samples in the segment in 3² neighbourhoods of each slice; three of these counts add up to 3³.
Segment smoothed(const ImageVolume& image, const Segment& segment, const Progress& progress) {
  const std::array<int, 3> size = image.grid().size;
  const auto width = static_cast<std::size_t>(size[0]), height = static_cast<std::size_t>(size[1]);
  std::vector<std::uint8_t> sums(image.grid().count());
  const auto rowAt = [&](int y, int z) {
    return std::span(sums).subspan((static_cast<std::size_t>(z) * height + static_cast<std::size_t>(y)) * width, width);
  };
  readSegment(image, segment, [&](const auto& reader) {
    tbb::parallel_for(0, size[2], [&](int z) {
      if (progress.cancelled()) return;
      std::vector<std::uint8_t> slice(width * height), row(width);
      for (int y = 0; y < size[1]; ++y) {
        reader.readRow(y, z, row);
        for (std::size_t x = 0; x < width; ++x)
          slice[static_cast<std::size_t>(y) * width + x] =
              static_cast<std::uint8_t>(row[x > 0 ? x - 1 : x] + row[x] + row[std::min(x + 1, width - 1)]);
      }
      for (int y = 0; y < size[1]; ++y) {
        const std::span<std::uint8_t> sum = rowAt(y, z);
        for (const int from : {std::max(y - 1, 0), y, std::min(y + 1, size[1] - 1)})
          for (std::size_t x = 0; x < width; ++x)
            sum[x] = static_cast<std::uint8_t>(sum[x] + slice[static_cast<std::size_t>(from) * width + x]);
      }
    });
  });
  progress.set(0.5);
  constexpr int kMost = 14;  // majority of 27 samples
  const std::array<int, 3> count = Segment::bricksOf(size);
  std::vector<Segment::Brick> bricks(static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
                                     static_cast<std::size_t>(count[2]));
  tbb::parallel_for(0, count[2], [&](int layer) {
    if (progress.cancelled()) return;
    auto index =
        static_cast<std::size_t>(layer) * static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]);
    for (int line = 0; line < count[1]; ++line)
      for (int column = 0; column < count[0]; ++column, ++index) {
        auto brick = std::make_shared<SegmentBrick>();
        for (int z = 16 * layer; z < std::min(16 * (layer + 1), size[2]); ++z)
          for (int y = 16 * line; y < std::min(16 * (line + 1), size[1]); ++y) {
            const auto below = rowAt(y, std::max(z - 1, 0)), own = rowAt(y, z),
                       above = rowAt(y, std::min(z + 1, size[2] - 1));
            for (int x = 16 * column; x < std::min(16 * (column + 1), size[0]); ++x) {
              const auto i = static_cast<std::size_t>(x);
              if (below[i] + own[i] + above[i] >= kMost) brick->set(x & 15, y & 15, z & 15, true);
            }
          }
        bricks[index] = std::move(brick);
      }
  });
  return {segment.range(), size, std::move(bricks)};
}

}  // namespace handwheel
