// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom/SeriesImage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

// The values of an image, slice by slice: of 16 bits as long as that holds them.
class SliceStack {
 public:
  SliceStack(const ImageGrid& grid, std::size_t pixels) : m_grid(grid), m_pixels(pixels), m_whole(grid.count()) {}

  // slice: the values of one slice.
  void put(std::size_t index, const std::vector<float>& slice) {
    if (!m_whole.empty() && !areShort(slice)) {
      m_values.assign(m_whole.begin(), m_whole.end());
      m_whole = {};
    }
    const auto at = static_cast<std::ptrdiff_t>(index * m_pixels);
    if (m_whole.empty())
      std::copy(slice.begin(), slice.end(), m_values.begin() + at);
    else
      std::transform(slice.begin(), slice.end(), m_whole.begin() + at,
                     [](float v) { return static_cast<std::int16_t>(v); });
  }
  ImageFile image() && {
    if (m_whole.empty()) return imageOfValues(m_grid, std::move(m_values));
    return {ImageVolume(m_grid, std::move(m_whole)), {}};
  }

 private:
  ImageGrid m_grid;
  std::size_t m_pixels;
  std::vector<std::int16_t> m_whole;  // or else
  std::vector<float> m_values;
};

// Puts the slices of an image between two of the series, both included.
void fill(SliceStack& stack, std::size_t count, double below, const std::vector<float>& low, double above,
          const std::vector<float>& high) {
  constexpr double kSame = 1e-6;
  std::vector<float> between(low.size());
  for (auto k = static_cast<std::size_t>(std::max(0.0, std::ceil(below - kSame)));
       k < count && static_cast<double>(k) <= above + kSame; ++k) {
    const double share = above > below ? std::clamp((static_cast<double>(k) - below) / (above - below), 0.0, 1.0) : 0.0;
    if (share == 0.0 || share == 1.0) {
      stack.put(k, share == 0.0 ? low : high);
      continue;
    }
    std::transform(low.begin(), low.end(), high.begin(), between.begin(), [share](float a, float b) {
      return static_cast<float>((1.0 - share) * static_cast<double>(a) + share * static_cast<double>(b));
    });
    stack.put(k, between);
  }
}

}  // namespace

Result<ImageFile> imageOf(const Series& series, Progress progress) {
  const DicomSlice& first = series.slices.front();
  ImageGrid grid;
  grid.size = {first.size[0], first.size[1], static_cast<int>(std::min<std::size_t>(series.count, 1 << 20))};
  grid.origin = first.origin;
  grid.steps.col(0) = first.spacing[0] * first.across;
  grid.steps.col(1) = first.spacing[1] * first.down;
  grid.steps.col(2) = series.step;
  if (!checkGrid(grid)) return Error{ErrorCode::LibraryFailed, {"it is not a grid of samples"}, {}, {}};
  const Error notUnpacked{ErrorCode::LibraryFailed, {"the pixels of a slice cannot be unpacked"}, {}, {}};
  SlicePixels pixels;
  if (series.slices.size() == 1) {
    std::optional<std::vector<float>> values = pixels.valuesOf(first);
    return values ? Result<ImageFile>(imageOfValues(grid, std::move(*values))) : notUnpacked;
  }
  const auto count = static_cast<std::size_t>(grid.size[2]);
  SliceStack stack(grid, grid.count() / count);
  std::vector<float> before;
  for (std::size_t i = 0; i < series.slices.size(); ++i) {
    std::optional<std::vector<float>> own = pixels.valuesOf(series.slices[i]);
    if (!own) return notUnpacked;
    progress.set(static_cast<double>(i) / static_cast<double>(series.slices.size()));
    if (i > 0) fill(stack, count, series.heights[i - 1], before, series.heights[i], *own);
    before = std::move(*own);
  }
  return std::move(stack).image();
}

}  // namespace handwheel
