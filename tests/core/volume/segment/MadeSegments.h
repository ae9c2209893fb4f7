// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../image/MadeImages.h"
#include "volume/segment/Segment.h"

#include <random>

namespace handwheel::test {

// Returns the samples of a segment as plain flags, x fastest.
inline std::vector<char> flagsOf(const ImageVolume& image, const Segment& segment) {
  std::vector<char> flags;
  const std::array<int, 3> size = image.grid().size;
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x) flags.push_back(segment.contains(image, {x, y, z}) ? 1 : 0);
  return flags;
}

// Returns an image of random whole numbers from 0 to 99.
inline ImageVolume noise(const std::array<int, 3>& size, unsigned seed) {
  std::mt19937 random(seed);
  const ImageGrid grid{size, Vec3(3, -2, 1), Vec3(0.5, 0.8, 1.5).asDiagonal().toDenseMatrix()};
  return imageOf<std::int16_t>(grid, [&](const Vec3&) { return random() % 100; });
}

}  // namespace handwheel::test
