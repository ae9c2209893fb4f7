// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom/SeriesImage.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Puts the slices of an image between two of the series, both included.
void fill(std::vector<float>& values, std::size_t pixels, double below, const std::vector<float>& low, double above,
          const std::vector<float>& high) {
  constexpr double kSame = 1e-6;
  const auto count = values.size() / pixels;
  for (auto k = static_cast<std::size_t>(std::max(0.0, std::ceil(below - kSame)));
       k < count && static_cast<double>(k) <= above + kSame; ++k) {
    const double share = above > below ? std::clamp((static_cast<double>(k) - below) / (above - below), 0.0, 1.0) : 0.0;
    float* const slice = values.data() + k * pixels;
    for (std::size_t i = 0; i < pixels; ++i)
      slice[i] =
          share == 0.0 ? low[i]
          : share == 1.0
              ? high[i]
              : static_cast<float>((1.0 - share) * static_cast<double>(low[i]) + share * static_cast<double>(high[i]));
  }
}

}  // namespace

Result<ImageFile> imageOf(const Series& series, Progress progress) {
  const DicomSlice& first = series.slices.front();
  ImageGrid grid;
  grid.size = {first.size[0], first.size[1], static_cast<int>(std::min<std::size_t>(series.count, 1 << 20))};
  grid.origin = first.origin;
  grid.steps.col(0) = first.spacing.x() * first.across;
  grid.steps.col(1) = first.spacing.y() * first.down;
  grid.steps.col(2) = series.step;
  if (!checkGrid(grid)) return Error{ErrorCode::LibraryFailed, {"it is not a grid of samples"}, {}, {}};
  const std::size_t pixels = static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
  std::vector<float> values;
  std::vector<float> before;
  for (std::size_t i = 0; i < series.slices.size(); ++i) {
    std::optional<std::vector<float>> own = valuesOf(series.slices[i]);
    if (!own) return Error{ErrorCode::LibraryFailed, {"the pixels of a slice cannot be unpacked"}, {}, {}};
    progress.set(static_cast<double>(i) / static_cast<double>(series.slices.size()));
    if (series.slices.size() == 1) {
      values = std::move(*own);
      break;
    }
    values.resize(grid.count());
    if (i > 0) fill(values, pixels, series.heights[i - 1], before, series.heights[i], *own);
    before = std::move(*own);
  }
  return imageOfValues(grid, std::move(values));
}

}  // namespace handwheel
