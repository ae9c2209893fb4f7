// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TargetDeviation.h"

#include "machining/target/TargetSides.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr int kFacePoints = 32;  // number of points across a flat end
constexpr std::size_t kSamplesPerPoll = 1024;

void note(TargetDeviation& deviation, double distance, const ProfilePoint& at) {
  if (distance > deviation.largestOver.distance) deviation.largestOver = {distance, at};
  if (distance < deviation.largestUnder.distance) deviation.largestUnder = {distance, at};
}

// The nominal surfaces of a part.
class Measured {
 public:
  explicit Measured(const TargetProfile& target) : m_target(target), m_sides(sidesOf(target)) {}

  double outside(const ProfilePoint& p) const { return m_sides ? m_sides->outside.distance(p) : m_target.distance(p); }
  double bore(const ProfilePoint& p) const {
    if (!m_sides) return m_target.distance(p);
    double beyond = p.x();  // distance from the axis, if there should be no bore
    for (const TargetProfile& bore : m_sides->bores) beyond = std::min(beyond, bore.distance(p));
    return -beyond;
  }
  // Returns the depth within the material of the target of the furthest point at a height; not above zero.
  double deepest(double z, double base) const {
    constexpr int kSamples = 16;
    const auto extent = m_target.extentAt(base + z);
    double least = 0.0;
    for (int k = 0; extent && k <= kSamples; ++k) {
      const double r = std::lerp(extent->inner, extent->outer, static_cast<double>(k) / kSamples);
      least = std::min(least, m_target.distance({r, base + z}));
    }
    return least;
  }

 private:
  const TargetProfile& m_target;
  Result<TargetSides> m_sides;
};

}  // namespace

AxisRange rangeOfTarget(const TargetProfile& target, const TurnedProfile& part, double base, double from) {
  const double end = target.lowerEnd() - base, spacing = part.spacing();
  return {end > 0.5 * spacing ? std::max(from, end + spacing) : from, kWholeAxis.to};
}

TargetDeviation deviationFrom(const TargetProfile& target, const TurnedProfile& part, double base, Progress progress,
                              AxisRange range) {
  constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();
  const Measured wanted(target);
  TargetDeviation deviation;
  deviation.outer.assign(part.size(), kNotMeasured);
  deviation.inner.assign(part.size(), kNotMeasured);
  const auto take = [&](double distance, double r, double z) {
    note(deviation, distance, {r, base + z});
    return distance;
  };
  const auto isWithin = [&](double z) { return z >= range.from && z <= range.to; };
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (i % kSamplesPerPoll == 0) {
      if (progress.cancelled()) return deviation;
      progress.set(static_cast<double>(i) / static_cast<double>(part.size()));
    }
    const double r = part.radius(i), bore = part.inner(i), z = part.z(i);
    if (!isWithin(z)) continue;
    if (!part.hasMaterial(i)) {
      if (const double missing = wanted.deepest(z, base); missing < 0.0) deviation.outer[i] = take(missing, r, z);
      continue;
    }
    deviation.outer[i] = take(wanted.outside({r, base + z}), r, z);
    // If there is no bore, the axis shows if there should be one.
    if (bore > 0.0) {
      deviation.inner[i] = take(wanted.bore({bore, base + z}), bore, z);
    } else {
      take(std::max(wanted.bore({0.0, base + z}), 0.0), 0.0, z);
    }
  }
  for (const std::size_t end : {std::size_t{0}, part.size() - 1}) {
    if (!isWithin(part.z(end)) || !part.hasMaterial(end)) continue;
    for (int k = 0; k <= kFacePoints; ++k) {
      const double r = std::lerp(part.inner(end), part.radius(end), static_cast<double>(k) / kFacePoints);
      take(target.distance({r, base + part.z(end)}), r, part.z(end));
    }
  }
  return deviation;
}

}  // namespace handwheel
