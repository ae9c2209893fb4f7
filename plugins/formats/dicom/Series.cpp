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

// Returns the distance as a multiple of the usual distance; 0 if it is not a multiple.
std::size_t multipleOf(double usual, double distance) {
  constexpr double kShare = 0.05;  // tolerance of a multiple, as a share of the usual distance
  const double steps = std::round(distance / usual);
  return steps >= 1.0 && std::abs(distance - steps * usual) <= kShare * usual ? static_cast<std::size_t>(steps) : 0;
}

// Even steps for slices of these heights, with this number of pixels each.
Status setSteps(const std::vector<double>& heights, double pixels, Series& series) {
  std::vector<double> distances;
  for (std::size_t i = 1; i < heights.size(); ++i) distances.push_back(heights[i] - heights[i - 1]);
  std::vector<double> ordered = distances;
  std::sort(ordered.begin(), ordered.end());
  const double usual = ordered[ordered.size() / 2], all = heights.back() - heights.front();
  const auto own = static_cast<double>(heights.size());
  series.least = ordered.front();
  series.largest = ordered.back();
  // mm; positions are written with one or two digits.
  const double rounding = std::max(0.02 * usual, 0.011);
  // Largest numbers of slices, so that a stray one does not fill the memory: of those that are missing, and of those
  // with the smallest distance, which may be that of a single pair.
  constexpr double kMostSamples = 1 << 28;
  const double most = 32.0 * own + 64.0, mostFine = std::min(most, std::max(4.0 * own + 16.0, kMostSamples / pixels));
  series.count = heights.size();
  if (series.largest - series.least > rounding) {
    if (all / usual > most) return seriesError("its slices are too far apart");
    std::size_t steps = 0;
    bool areMultiples = true;
    for (const double distance : distances) {
      const std::size_t multiple = multipleOf(usual, distance);
      areMultiples = areMultiples && multiple > 0;
      steps += multiple;
    }
    series.isUneven = !areMultiples;
    series.missing = areMultiples ? steps - distances.size() : 0;
    constexpr double kRounding = 1e-3;
    const double count =
        areMultiples ? static_cast<double>(steps) : std::min(std::ceil(all / series.least - kRounding), mostFine);
    series.count = static_cast<std::size_t>(count) + 1;
  }
  series.step /= static_cast<double>(series.count - 1);
  const double step = all / static_cast<double>(series.count - 1);
  for (const double height : heights) series.heights.push_back((height - heights.front()) / step);
  return Done{};
}

// Gives positions to the slices of an image that have none: in the order of their numbers, with the stated distance.
// Several files with frames are not combined.
Status placeByOrder(std::vector<DicomSlice>& own, Series& series) {
  if (own.front().frames > 1)
    std::erase_if(own, [file = own.front().bytes.data()](const DicomSlice& s) { return s.bytes.data() != file; });
  if (own.size() == 1) return Done{};
  std::vector<double> locations;
  for (const DicomSlice& slice : own)
    if (slice.location) locations.push_back(*slice.location);
  std::sort(locations.begin(), locations.end());
  const bool areLocated =
      locations.size() == own.size() && std::adjacent_find(locations.begin(), locations.end()) == locations.end();
  std::stable_sort(own.begin(), own.end(),
                   [](const DicomSlice& a, const DicomSlice& b) { return a.number < b.number; });
  const double apart = areLocated ? (locations.back() - locations.front()) / static_cast<double>(locations.size() - 1)
                                  : own.front().apart;
  if (apart == 0.0) return seriesError("its slices have neither positions nor a stated distance");
  const Vec3 origin = own.front().origin, step = apart * own.front().normal();
  const double least = own.front().number;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (areLocated)
      own[i].origin = *own[i].location * own[i].normal();
    else
      own[i].origin = origin + (own[i].frames > 1 ? own[i].number - least : static_cast<double>(i)) * step;
  }
  series.assumed = std::abs(apart);
  return Done{};
}

}  // namespace

std::vector<DicomSlice> chosenSeries(const std::vector<DicomSlice>& slices, bool ofFirst) {
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
  // A segmentation has several frames at each position of the image that it lies beside.
  const auto rank = [](const std::vector<DicomSlice>& group) {
    return std::pair(group.front().labels == nullptr, group.size());
  };
  return *std::max_element(groups.begin(), groups.end(),
                           [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

Result<Series> seriesOf(std::vector<DicomSlice> own) {
  Series series;
  if (!own.front().hasPosition)
    if (const Status placed = placeByOrder(own, series); !placed) return placed.error();
  std::stable_sort(own.begin(), own.end(),
                   [](const DicomSlice& a, const DicomSlice& b) { return a.height() < b.height(); });
  constexpr double kSamePosition = 1e-3;  // mm
  for (DicomSlice& slice : own) {
    if (series.slices.empty() || slice.height() - series.slices.back().height() >= kSamePosition) {
      series.slices.push_back(std::move(slice));
      continue;
    }
    ++series.samePosition;
    // The first of several moments or echoes is taken everywhere, in whatever order the files are.
    if (slice.frames == 1 && slice.moment < series.slices.back().moment) series.slices.back() = std::move(slice);
  }
  const DicomSlice& first = series.slices.front();
  if (series.slices.size() == 1) {
    series.step = (first.apart == 0.0 ? 1.0 : std::abs(first.apart)) * first.normal();
    series.count = 1;
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
  const double pixels = static_cast<double>(first.size[0]) * static_cast<double>(first.size[1]);
  if (const Status set = setSteps(heights, pixels, series); !set) return set.error();
  return series;
}

}  // namespace handwheel
