// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

#include <vector>

namespace handwheel::test {

// Returns an image whose samples are a function of their positions, mm.
template <class Sample = float, class Function>
ImageVolume imageOf(const ImageGrid& grid, Function function) {
  std::vector<Sample> samples;
  for (int z = 0; z < grid.size[2]; ++z)
    for (int y = 0; y < grid.size[1]; ++y)
      for (int x = 0; x < grid.size[0]; ++x)
        samples.push_back(static_cast<Sample>(function(grid.position(Vec3(x, y, z)))));
  return {grid, std::move(samples)};
}

}  // namespace handwheel::test
