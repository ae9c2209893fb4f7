// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramArc.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// These limits are those of LinuxCNC.
constexpr double kRadius = 0.00127;        // mm; shortfall of a radius
constexpr double kSpiral = 0.0127;         // mm
constexpr double kRelativeSpiral = 0.001;  // share of the radius; both limit the difference between the two ends
constexpr double kMostSpiral = 100.0 * kSpiral;

}  // namespace

PlanePoint centreFromRadius(const PlanePoint& from, const PlanePoint& to, int turn, double radius,
                            const SourceLocation& location) {
  const PlanePoint chord = to - from;
  const double half = 0.5 * std::abs(chord), size = std::abs(radius);
  if (!(half > 0.0))
    refuse(location, "R", "an arc with R cannot end where it begins", "Give the centre with I and K instead of R.");
  if (half > size + kRadius)
    refuse(location, "R" + roundedText(radius), "the radius is too small to reach the end of the arc",
           "It must be at least " + roundedText(half) + " mm.");
  const double height = std::sqrt(std::max(0.0, size * size - half * half));
  const double side = (radius < 0.0 ? -1.0 : 1.0) * turn;  // the shorter arc has its centre on the side it turns to
  return 0.5 * (from + to) + PlanePoint(0.0, side * height / (2.0 * half)) * chord;
}

void checkCentre(const PlanePoint& from, const PlanePoint& to, const PlanePoint& centre,
                 const SourceLocation& location) {
  const double begin = std::abs(from - centre), end = std::abs(to - centre);
  const double off = std::abs(begin - end);
  const double relative = off / std::max({begin, end, 1e-9});
  if (off > kMostSpiral || (off > kSpiral && relative > kRelativeSpiral))
    refuse(location, "I K",
           "the ends of the arc are " + roundedText(begin) + " and " + roundedText(end) + " mm from its centre",
           "Correct I and K, or give the radius R instead.");
  if (!(begin > 0.0)) refuse(location, "I K", "the arc has no radius", "Correct I and K.");
}

}  // namespace handwheel
