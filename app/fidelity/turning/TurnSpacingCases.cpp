// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/Cases.h"
#include "machining/TurnedSurface.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr StockCylinder kTurnedBar{50.0, 100.0, 0.0};

// Plunges beside each other, which leave a wave of half circles. Neither where they begin nor their pitch is a multiple
// of a spacing, for a sample at each crest would hide the error.
struct Grooves {
  static constexpr double kFirst = 20.0137;  // mm
  double noseRadius = 1.0;
  double pitch = 1.0173;  // mm
  double depth = 3.0;

  double centre(int i) const { return kFirst + pitch * i; }
  int count() const { return static_cast<int>(60.0 / pitch); }
  double radius() const { return 0.5 * kTurnedBar.diameter - depth + noseRadius; }
  double exact(double z) const {
    const double nearest = centre(std::clamp(static_cast<int>(std::lround((z - kFirst) / pitch)), 0, count() - 1));
    const double under = noseRadius * noseRadius - (z - nearest) * (z - nearest);
    const double left = under >= 0.0 ? radius() - std::sqrt(under) : radius() + noseRadius;
    return std::min(left, 0.5 * kTurnedBar.diameter);
  }
};

// Between the grooves, where the wave has its crests; flanks at the ends are vertical, and off by a sample in any case.
double largestError(const TurnedProfile& profile, const Grooves& grooves) {
  constexpr int kPositions = 100'000;
  const double from = grooves.centre(0), to = grooves.centre(grooves.count() - 1);
  double largest = 0.0;
  for (int i = 0; i <= kPositions; ++i) {
    const double z = from + (to - from) * i / kPositions;
    const double at = z / profile.spacing();
    const auto below = std::min(static_cast<std::size_t>(at), profile.size() - 2);
    const double t = at - static_cast<double>(below);
    const double radius = (1.0 - t) * profile.radius(below) + t * profile.radius(below + 1);
    largest = std::max(largest, std::abs(radius - grooves.exact(z)));
  }
  return largest;
}

FidelityCase caseOf(const std::string& name, const Grooves& grooves) {
  return {name, "closed form", [grooves](double spacing, std::uint64_t, Progress) {
            TurnedProfile profile(kTurnedBar, spacing);
            TurnedSurface surface(profile, 0.02);
            FidelitySample sample;
            const double all = cpuMilliseconds([&] {
              for (int i = 0; i < grooves.count(); ++i) {
                const ProfilePoint from(grooves.radius() + 5.0, grooves.centre(i));
                const ProfilePoint to(grooves.radius(), grooves.centre(i));
                surface.update(profile, profile.cut(from, to, grooves.noseRadius));
              }
            });
            sample.cost = all / grooves.count();
            sample.error = largestError(profile, grooves);
            return sample;
          }};
}

}  // namespace

std::vector<FidelityCase> turnSpacingCases() {
  return {caseOf("grooves of radius 1 mm, 1 mm apart", {1.0, 1.0173, 3.0}),
          caseOf("grooves of radius 4 mm, 3 mm apart", {4.0, 3.0519, 2.0})};
}

}  // namespace handwheel
