// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace handwheel {

// The minimum and maximum of each cube of 8³ samples of an image. They identify regions that no surface passes, without
// reading the samples of these regions.
class ImageExtremes {
 public:
  explicit ImageExtremes(const ImageVolume& image);

  // Returns the range of all samples in the cubes that intersect the box [low, high] of indices, which is clipped to
  // the image. O(cubes).
  ValueRange within(const Vec3& low, const Vec3& high) const;

 private:
  static constexpr int kSide = 8;

  std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(m_cubes[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(m_cubes[0]) +
           static_cast<std::size_t>(x);
  }

  std::array<int, 3> m_size, m_cubes;
  std::vector<ValueRange> m_ranges;
};

}  // namespace handwheel
