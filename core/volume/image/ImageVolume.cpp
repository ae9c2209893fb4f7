// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageVolume.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace handwheel {

Status checkGrid(const ImageGrid& grid) {
  const auto malformed = [](const char* what, const char* why) {
    return Error{ErrorCode::ElementMalformed, {what, why}, {}, {}};
  };
  double samples = 1.0;
  for (const int n : grid.size) {
    if (n < 1) return malformed("size", "it has no samples");
    if (n > ImageGrid::kMostAlong)
      return Error{ErrorCode::FileTooLarge,
                   {"samples along an axis", std::to_string(n), std::to_string(ImageGrid::kMostAlong)},
                   {},
                   {}};
    samples *= n;
  }
  if (samples > static_cast<double>(ImageGrid::kMostSamples))
    return Error{ErrorCode::FileTooLarge,
                 {"samples", std::to_string(grid.count()), std::to_string(ImageGrid::kMostSamples)},
                 {},
                 {}};
  if (!grid.origin.allFinite() || !grid.steps.allFinite() || grid.origin.cwiseAbs().maxCoeff() > 1e9)
    return malformed("place", "it is not finite");
  const Vec3 spacing = grid.spacing();
  if (spacing.minCoeff() < 1e-6 || spacing.maxCoeff() > 1e6)
    return malformed("spacing", "it is not a distance of samples");
  // Least volume of the parallelepiped of the steps, as a share of the cuboid's; flatter grids are rejected.
  constexpr double kFlattest = 0.05;
  if (!(std::abs(grid.steps.determinant()) > kFlattest * spacing.prod()))
    return malformed("directions", "the axes lie in one plane");
  return Done{};
}

ValueRange valuesOf(const ImageVolume& image) {
  return image.visitSamples([](auto samples) {
    const auto [least, largest] = std::minmax_element(samples.begin(), samples.end());
    return ValueRange{static_cast<double>(*least), static_cast<double>(*largest)};
  });
}

}  // namespace handwheel
