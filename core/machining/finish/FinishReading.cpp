// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/finish/FinishReading.h"

#include <algorithm>

namespace handwheel {

namespace {

// Returns the reading of the samples from first to before last; all are known.
FinishReading readingOf(const SurfaceFinish& finish, const TurnedProfile& profile, TurningSide side,
                        TurnedProfile::Range range) {
  constexpr double kMayBeRougher = 0.16;
  FinishReading reading;
  std::vector<double> all;
  for (std::size_t i = range.first; i < range.last; ++i) {
    all.push_back(finish.at(side, i).roughness);
    if (all.back() > reading.largest) reading.largest = all.back(), reading.largestAt = profile.z(i);
  }
  const auto rougher = static_cast<std::size_t>(kMayBeRougher * static_cast<double>(all.size()));
  const auto read = all.end() - 1 - static_cast<std::ptrdiff_t>(rougher);
  std::nth_element(all.begin(), read, all.end());
  reading.roughness = *read;
  return reading;
}

bool isSurface(const TurnedProfile& profile, TurningSide side, std::size_t i) {
  return profile.hasMaterial(i) && (side == TurningSide::Outside || profile.inner(i) > 0.0);
}

}  // namespace

std::optional<FinishReading> readFinish(const SurfaceFinish& finish, const TurnedProfile& profile, TurningSide side,
                                        AxisRange range) {
  TurnedProfile::Range samples;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!(profile.z(i) >= range.from && profile.z(i) <= range.to)) continue;
    if (!finish.at(side, i).isKnown()) return std::nullopt;
    samples.extend({i, i + 1});
  }
  if (samples.isEmpty()) return std::nullopt;
  return readingOf(finish, profile, side, samples);
}

std::vector<FinishInterval> finishIntervals(const SurfaceFinish& finish, const TurnedProfile& profile,
                                            TurningSide side) {
  std::vector<FinishInterval> intervals;
  const auto isPart = [&](std::size_t i) { return isSurface(profile, side, i) && finish.at(side, i).isKnown(); };
  for (std::size_t first = 0; first < profile.size();) {
    const FinishMark mark = finish.at(side, first);
    std::size_t last = first + 1;
    if (isPart(first)) {
      FinishInterval interval{profile.z(first), 0.0, mark.pass, mark.feed, {}};
      for (; last < profile.size() && isPart(last) && finish.at(side, last).pass == mark.pass; ++last)
        interval.feed = std::max<double>(interval.feed, finish.at(side, last).feed);
      interval.to = profile.z(last - 1);
      interval.reading = readingOf(finish, profile, side, {first, last});
      intervals.push_back(interval);
    }
    first = last;
  }
  return intervals;
}

}  // namespace handwheel
