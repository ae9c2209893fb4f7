// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom/Series.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

Error seriesError(const char* reason) {
  return {ErrorCode::LibraryFailed, {reason}, {}, {}};
}

// Returns the slices that belong to the series of the first slice, or to the largest series.
std::vector<DicomSlice> chosen(const std::vector<DicomSlice>& slices, bool ofFirst) {
  std::vector<std::vector<DicomSlice>> groups;
  for (const DicomSlice& slice : slices) {
    const auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& some) { return some.front().belongsWith(slice); });
    if (group != groups.end())
      group->push_back(slice);
    else
      groups.push_back({slice});
  }
  if (ofFirst) return groups.front();
  return *std::max_element(groups.begin(), groups.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

// Returns the distance as a multiple of the usual distance; 0 if it is not a multiple.
std::size_t multipleOf(double usual, double distance) {
  constexpr double kShare = 0.05;  // tolerance of a multiple, as a share of the usual distance
  const double steps = std::round(distance / usual);
  return steps >= 1.0 && std::abs(distance - steps * usual) <= kShare * usual ? static_cast<std::size_t>(steps) : 0;
}

// Even steps for slices of these heights.
Status setSteps(const std::vector<double>& heights, Series& series) {
  std::vector<double> distances;
  for (std::size_t i = 1; i < heights.size(); ++i) distances.push_back(heights[i] - heights[i - 1]);
  std::vector<double> ordered = distances;
  std::sort(ordered.begin(), ordered.end());
  const double usual = ordered[ordered.size() / 2], all = heights.back() - heights.front();
  series.least = ordered.front();
  series.largest = ordered.back();
  // mm; positions are written with one or two digits.
  const double rounding = std::max(0.02 * usual, 0.011);
  series.count = heights.size();
  if (series.largest - series.least > rounding) {
    std::size_t steps = 0;
    bool areMultiples = true;
    for (const double distance : distances) {
      const std::size_t multiple = multipleOf(usual, distance);
      areMultiples = areMultiples && multiple > 0;
      steps += multiple;
    }
    series.isUneven = !areMultiples;
    series.missing = areMultiples ? steps - distances.size() : 0;
    const double count = areMultiples ? static_cast<double>(steps) : std::round(all / usual);
    if (count > 4.0 * static_cast<double>(heights.size()) + 16.0) return seriesError("its slices are too far apart");
    series.count = static_cast<std::size_t>(count) + 1;
  }
  series.step /= static_cast<double>(series.count - 1);
  const double step = all / static_cast<double>(series.count - 1);
  for (const double height : heights) series.heights.push_back((height - heights.front()) / step);
  return Done{};
}

}  // namespace

Result<Series> seriesOf(std::vector<DicomSlice> slices, bool ofFirst) {
  if (slices.empty()) return seriesError("the file contains no image in grey");
  Series series;
  std::vector<DicomSlice> own = chosen(slices, ofFirst);
  series.others = slices.size() - own.size();
  std::stable_sort(own.begin(), own.end(),
                   [](const DicomSlice& a, const DicomSlice& b) { return a.height() < b.height(); });
  constexpr double kSamePosition = 1e-3;  // mm
  for (DicomSlice& slice : own) {
    if (!series.slices.empty() && slice.height() - series.slices.back().height() < kSamePosition)
      ++series.samePosition;
    else
      series.slices.push_back(std::move(slice));
  }
  const DicomSlice& first = series.slices.front();
  if (series.slices.size() == 1 || first.size[2] > 1) {
    // Frames of one file, with a stated distance; several files with frames are not combined.
    series.others += series.slices.size() - 1;
    series.slices.resize(1, first);
    series.step = first.spacing.z() * first.normal();
    series.count = static_cast<std::size_t>(first.size[2]);
    series.heights = {0.0};
    return series;
  }
  series.step = series.slices.back().origin - first.origin;
  const Vec3 normal = first.normal();
  std::vector<double> heights;
  for (const DicomSlice& slice : series.slices) {
    heights.push_back(slice.height());
    const double share = (slice.height() - first.height()) / normal.dot(series.step);
    if ((slice.origin - first.origin - share * series.step).norm() > 0.5)  // mm
      return seriesError("its slices do not lie along one line");
  }
  const double angle = std::acos(std::clamp(normal.dot(series.step.normalized()), -1.0, 1.0)) * 180.0 / M_PI;
  constexpr double kLeastTilt = 0.1;  // degrees, as positions are rounded
  series.tilt = angle > kLeastTilt ? angle : 0.0;
  if (const Status set = setSteps(heights, series); !set) return set.error();
  return series;
}

}  // namespace handwheel
