// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageHistogram.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace handwheel {

namespace {

std::size_t binAt(double value, double least, double width, std::size_t bins) {
  if (!(width > 0.0)) return 0;
  return static_cast<std::size_t>(std::clamp((value - least) / width, 0.0, static_cast<double>(bins - 1)));
}

}  // namespace

std::size_t ImageHistogram::binOf(double value) const {
  return binAt(value, values.least, width(), counts.size());
}

double ImageHistogram::quantile(double share) const {
  const auto all = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  double below = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    below += static_cast<double>(counts[i]);
    if (below >= share * static_cast<double>(all)) return values.least + width() * static_cast<double>(i + 1);
  }
  return values.largest;
}

ImageHistogram histogramOf(const ImageVolume& image, std::size_t bins) {
  ImageHistogram histogram{valuesOf(image), std::vector<std::size_t>(bins, 0)};
  using Counts = std::vector<std::size_t>;
  const double least = histogram.values.least, width = histogram.width();
  histogram.counts = image.visitSamples([&](auto samples) {
    constexpr std::size_t kGrain = 1 << 20;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, samples.size(), kGrain), Counts(bins, 0),
        [&](const tbb::blocked_range<std::size_t>& range, Counts counts) {
          for (std::size_t i = range.begin(); i < range.end(); ++i)
            ++counts[binAt(static_cast<double>(samples[i]), least, width, bins)];
          return counts;
        },
        [](Counts a, const Counts& b) {
          std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::plus<>());
          return a;
        });
  });
  return histogram;
}

double otsuThreshold(const ImageHistogram& histogram) {
  const std::vector<std::size_t>& counts = histogram.counts;
  if (!(histogram.width() > 0.0)) return histogram.values.largest;
  double all = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    all += static_cast<double>(counts[i]);
    sum += static_cast<double>(counts[i]) * static_cast<double>(i);
  }
  double below = 0.0, sumBelow = 0.0, best = -1.0;
  std::size_t first = 0, last = 0;  // range of equally good bins; between two peaks there are many
  for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
    below += static_cast<double>(counts[i]);
    sumBelow += static_cast<double>(counts[i]) * static_cast<double>(i);
    if (below == 0.0 || below == all) continue;
    const double apart = sumBelow / below - (sum - sumBelow) / (all - below);
    const double variance = below * (all - below) * apart * apart;
    if (variance > best) first = i;
    if (variance >= best) last = i;
    best = std::max(best, variance);
  }
  return histogram.values.least + histogram.width() * (0.5 * static_cast<double>(first + last) + 1.0);
}

ValueRange withoutIdleEnds(const ValueRange& range, const ValueRange& values) {
  constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  return {range.least <= values.least ? -kNoEnd : range.least,
          range.largest >= values.largest ? kNoEnd : range.largest};
}

bool looksLikeHounsfield(const ValueRange& values) {
  constexpr double kNoAir = -800.0, kLeastOfFiles = -4096.0, kBone = 250.0;
  return values.least >= kLeastOfFiles && values.least <= kNoAir && values.largest >= kBone;
}

}  // namespace handwheel
