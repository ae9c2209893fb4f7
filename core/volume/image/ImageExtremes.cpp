// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageExtremes.h"

#include <tbb/parallel_for.h>
#include <cmath>

namespace handwheel {

ImageExtremes::ImageExtremes(const ImageVolume& image) : m_size(image.grid().size), m_cubes{} {
  for (std::size_t k = 0; k < 3; ++k) m_cubes[k] = (m_size[k] + kSide - 1) / kSide;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  m_ranges.assign(at(0, 0, m_cubes[2]), {kFar, -kFar});
  image.visitSamples([&](auto samples) {
    tbb::parallel_for(0, m_cubes[2], [&](int cube) {
      for (int z = kSide * cube; z < std::min(kSide * (cube + 1), m_size[2]); ++z)
        for (int y = 0; y < m_size[1]; ++y) {
          const auto row = samples.subspan(
              (static_cast<std::size_t>(z) * static_cast<std::size_t>(m_size[1]) + static_cast<std::size_t>(y)) *
                  static_cast<std::size_t>(m_size[0]),
              static_cast<std::size_t>(m_size[0]));
          for (int x = 0; x < m_cubes[0]; ++x) {
            const auto first = static_cast<std::size_t>(kSide * x);
            auto least = row[first], largest = row[first];
            for (std::size_t i = first + 1; i < std::min(first + kSide, row.size()); ++i) {
              least = std::min(least, row[i]);
              largest = std::max(largest, row[i]);
            }
            ValueRange& range = m_ranges[at(x, y / kSide, cube)];
            range.least = std::min(range.least, static_cast<double>(least));
            range.largest = std::max(range.largest, static_cast<double>(largest));
          }
        }
    });
  });
}

ValueRange ImageExtremes::within(const Vec3& low, const Vec3& high) const {
  std::array<int, 3> from, to;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double last = m_size[k] - 1;
    from[k] = static_cast<int>(std::clamp(std::floor(low[axis]), 0.0, last)) / kSide;
    to[k] = static_cast<int>(std::clamp(std::ceil(high[axis]), 0.0, last)) / kSide;
  }
  ValueRange range = m_ranges[at(from[0], from[1], from[2])];
  for (int z = from[2]; z <= to[2]; ++z)
    for (int y = from[1]; y <= to[1]; ++y)
      for (int x = from[0]; x <= to[0]; ++x) {
        range.least = std::min(range.least, m_ranges[at(x, y, z)].least);
        range.largest = std::max(range.largest, m_ranges[at(x, y, z)].largest);
      }
  return range;
}

}  // namespace handwheel
