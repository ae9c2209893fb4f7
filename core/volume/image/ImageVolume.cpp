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
    return malformed("spacing", "it is no distance of samples");
  // Of the box of the steps, as a share of a cuboid's: what is flatter is no image of a body.
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

double otsuThreshold(const ImageVolume& image) {
  constexpr std::size_t kBins = 4096;
  const ValueRange range = valuesOf(image);
  const double width = (range.largest - range.least) / kBins;
  if (!(width > 0.0)) return range.largest;
  std::vector<double> counts(kBins, 0.0);
  image.visitSamples([&](auto samples) {
    for (const auto v : samples)
      ++counts[std::min(kBins - 1, static_cast<std::size_t>((static_cast<double>(v) - range.least) / width))];
  });
  double all = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < kBins; ++i) {
    all += counts[i];
    sum += counts[i] * static_cast<double>(i);
  }
  double below = 0.0, sumBelow = 0.0, best = -1.0;
  std::size_t first = 0, last = 0;  // of the bins that are equally good: between two peaks there are many
  for (std::size_t i = 0; i + 1 < kBins; ++i) {
    below += counts[i];
    sumBelow += counts[i] * static_cast<double>(i);
    if (below == 0.0 || below == all) continue;
    const double apart = sumBelow / below - (sum - sumBelow) / (all - below);
    const double variance = below * (all - below) * apart * apart;
    if (variance > best) first = i;
    if (variance >= best) last = i;
    best = std::max(best, variance);
  }
  return range.least + width * (0.5 * static_cast<double>(first + last) + 1.0);
}

}  // namespace handwheel
