// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TargetDeviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr int kFacePoints = 32;  // across a flat end
constexpr std::size_t kPlacesPerPoll = 1024;

void note(TargetDeviation& deviation, double distance, const ProfilePoint& at) {
  if (distance > deviation.largestOver.distance) deviation.largestOver = {distance, at};
  if (distance < deviation.largestUnder.distance) deviation.largestUnder = {distance, at};
}

}  // namespace

TargetDeviation deviationFrom(const TargetProfile& target, const TurnedProfile& part, double base, Progress progress) {
  TargetDeviation deviation;
  deviation.outer.resize(part.size());
  deviation.inner.assign(part.size(), std::numeric_limits<double>::quiet_NaN());
  const auto measure = [&](double r, double z) {
    const ProfilePoint at(r, base + z);
    const double distance = target.distance(at);
    note(deviation, distance, at);
    return distance;
  };
  const auto measureAxis = [&](double z) {
    const ProfilePoint at(0.0, base + z);
    note(deviation, std::max(target.distance(at), 0.0), at);
  };
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (i % kPlacesPerPoll == 0) {
      if (progress.cancelled()) return deviation;
      progress.set(static_cast<double>(i) / static_cast<double>(part.size()));
    }
    deviation.outer[i] = measure(part.radius(i), part.z(i));
    // Where there is no bore, the axis tells whether there should be one.
    if (part.inner(i) > 0.0) {
      deviation.inner[i] = measure(part.inner(i), part.z(i));
    } else if (part.radius(i) > 0.0) {
      measureAxis(part.z(i));
    }
  }
  for (const std::size_t end : {std::size_t{0}, part.size() - 1}) {
    for (int k = 0; k <= kFacePoints; ++k) {
      const double t = static_cast<double>(k) / kFacePoints;
      measure((1.0 - t) * part.inner(end) + t * part.radius(end), part.z(end));
    }
  }
  return deviation;
}

}  // namespace handwheel
