// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/ThreadMeasure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr double kStepsInPitch = 1'000.0;
constexpr double kMostLineSteps = 2e6;

// The radius of a side along the line, at equal steps of z. Depths count from the surface into the material.
struct SurfaceLine {
  double from = 0.0, step = 0.0;  // mm
  std::vector<double> radii;
  double z(double i) const { return from + i * step; }
};

double pitchWithin(const PartThreads& threads, TurningSide side, AxisRange range) {
  double least = 0.0;
  for (const ThreadGroove& groove : threads.grooves()) {
    if (groove.side() != side || groove.to() < range.from || groove.from() > range.to) continue;
    least = least == 0.0 ? groove.cut().pitch : std::min(least, groove.cut().pitch);
  }
  return least;
}

SurfaceLine lineAlong(const TurnedProfile& profile, const PartThreads& threads, TurningSide side, AxisRange range,
                      double pitch) {
  SurfaceLine line;
  line.from = std::max(range.from, 0.0);
  const double length = std::min(range.to, profile.length()) - line.from;
  const double steps = std::ceil(length / pitch * kStepsInPitch);
  if (!(steps >= 2.0 && steps <= kMostLineSteps)) return line;
  line.step = length / steps;
  const auto last = static_cast<double>(profile.size() - 1);
  for (std::size_t k = 0; k <= static_cast<std::size_t>(steps); ++k) {
    const double z = line.z(static_cast<double>(k)), at = std::min(z / profile.spacing(), last);
    const auto i = std::min(static_cast<std::size_t>(at), profile.size() - 2);
    const double t = at - static_cast<double>(i);
    const double outer = std::lerp(profile.radius(i), profile.radius(i + 1), t);
    const double inner = std::lerp(profile.inner(i), profile.inner(i + 1), t);
    const bool isBore = side == TurningSide::Bore;
    line.radii.push_back(threads.radius(side, isBore ? inner : outer, isBore ? outer : inner, z, 0.0));
  }
  return line;
}

// The positions at which the line crosses a radius: downwards into a groove, and up out of it; mm. A groove that is cut
// off by an end of the range does not count.
struct Gap {
  double begin = 0.0, end = 0.0;
  double middle() const { return 0.5 * (begin + end); }
};

std::vector<Gap> gapsAt(const SurfaceLine& line, double radius, TurningSide side) {
  std::vector<Gap> gaps;
  std::optional<double> begin;
  const auto into = [&](std::size_t i) {
    return side == TurningSide::Bore ? line.radii[i] - radius : radius - line.radii[i];
  };
  for (std::size_t i = 1; i < line.radii.size(); ++i) {
    const double before = into(i - 1), now = into(i);
    if ((before > 0.0) == (now > 0.0)) continue;
    const double z = line.z(static_cast<double>(i - 1) + before / (before - now));
    if (now > 0.0)
      begin = z;
    else if (begin)
      gaps.push_back({*std::exchange(begin, std::nullopt), z});
  }
  return gaps;
}

// Returns the mean excess of the grooves' width over half the pitch at a radius.
double excessAt(const SurfaceLine& line, double radius, TurningSide side, double pitch) {
  const std::vector<Gap> gaps = gapsAt(line, radius, side);
  double sum = 0.0;
  for (const Gap& gap : gaps) sum += gap.end - gap.begin;
  return gaps.empty() ? -0.5 * pitch : sum / static_cast<double>(gaps.size()) - 0.5 * pitch;
}

}  // namespace

std::optional<ThreadReading> measureThread(const TurnedProfile& profile, const PartThreads& threads, TurningSide side,
                                           AxisRange range) {
  const double nominal = pitchWithin(threads, side, range);
  if (nominal == 0.0) return std::nullopt;
  const SurfaceLine line = lineAlong(profile, threads, side, range, nominal);
  if (line.radii.size() < 2) return std::nullopt;
  const auto [least, largest] = std::minmax_element(line.radii.begin(), line.radii.end());
  const std::vector<Gap> gaps = gapsAt(line, 0.5 * (*least + *largest), side);
  if (gaps.size() < 2) return std::nullopt;
  ThreadReading reading;
  reading.grooves = static_cast<int>(gaps.size());
  reading.minor = 2.0 * *least;
  reading.major = 2.0 * *largest;
  reading.pitch = (gaps.back().middle() - gaps.front().middle()) / (static_cast<double>(gaps.size()) - 1.0);
  for (std::size_t i = 1; i < gaps.size(); ++i)
    reading.largestError =
        std::max(reading.largestError, std::abs(gaps[i].middle() - gaps[i - 1].middle() - reading.pitch));
  // A groove widens from its root to the crest.
  double root = side == TurningSide::Bore ? *largest : *least, crest = side == TurningSide::Bore ? *least : *largest;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (root + crest);
    (excessAt(line, middle, side, reading.pitch) < 0.0 ? root : crest) = middle;
  }
  reading.pitchDiameter = root + crest;
  return reading;
}

}  // namespace handwheel
