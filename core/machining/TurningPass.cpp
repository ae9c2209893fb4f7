// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurningPass.h"

#include "machining/PassSteps.h"
#include "machining/section/SectionCut.h"
#include "machining/section/SectionSource.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Cuts with a point that moves straight from a to b: removes all material outside of its path, or all between the path
// and the axis. A motion straight out or in removes nothing.
TurnedProfile::Range cutByPoint(TurnedProfile& profile, TurningSide side, const ProfilePoint& a,
                                const ProfilePoint& b) {
  TurnedProfile::Range changed;
  const double along = b.y() - a.y();
  if (!a.allFinite() || !b.allFinite() || along == 0.0) return changed;
  const double last = static_cast<double>(profile.size() - 1), spacing = profile.spacing();
  constexpr double kShare = 1e-9;  // share of a spacing; rounding of the ends
  const double low = std::ceil(std::min(a.y(), b.y()) / spacing - kShare);
  const double high = std::floor(std::max(a.y(), b.y()) / spacing + kShare);
  if (high < 0.0 || low > last || low > high) return changed;
  const auto end = static_cast<std::size_t>(std::min(high, last));
  for (auto i = static_cast<std::size_t>(std::max(low, 0.0)); i <= end; ++i) {
    const double t = std::clamp((profile.z(i) - a.y()) / along, 0.0, 1.0);
    const double radius = std::max(0.0, a.x() + t * (b.x() - a.x()));
    // In the bore, or around the part, it is beside the material.
    const bool isBeside =
        side == TurningSide::Bore ? radius >= profile.radius(i) : profile.inner(i) > 0.0 && radius <= profile.inner(i);
    if (isBeside) continue;
    const bool isCut = side == TurningSide::Bore ? profile.limitInner(i, radius) : profile.limitOuter(i, radius);
    if (isCut) changed.extend({i, i + 1});
  }
  return changed;
}

// The wall that certainly contains a position: of all samples from the one below it to the one above. If a shoulder
// lies between two samples, its exact position is unknown; so a tool that leaves the shoulder is not in the wall.
struct Wall {
  double inner = 0.0, outer = 0.0;  // mm; equal if there is no wall
};

Wall wallBetween(const TurnedProfile& profile, double low, double high) {
  constexpr double kShare = 1e-6;  // share of a spacing: on a sample
  const double first = std::floor(low + kShare) == std::floor(low - kShare) ? std::floor(low) : std::round(low) - 1.0;
  const double last = std::ceil(high + kShare) == std::ceil(high - kShare) ? std::ceil(high) : std::round(high) + 1.0;
  if (first < 0.0 || last > static_cast<double>(profile.size() - 1)) return {};
  Wall wall{0.0, profile.radius(static_cast<std::size_t>(first))};
  for (auto i = static_cast<std::size_t>(first); i <= static_cast<std::size_t>(last); ++i) {
    wall.inner = std::max(wall.inner, profile.inner(i));
    wall.outer = std::min(wall.outer, profile.radius(i));
  }
  return wall;
}

// Returns the depth of a path between two radii in a wall: at the point equally far from both sides, or at an end of
// the path.
double deepestIn(const Wall& wall, double r0, double r1) {
  if (wall.inner >= wall.outer) return 0.0;
  const double low = std::max(0.0, std::min(r0, r1)), high = std::max(0.0, std::max(r0, r1));
  if (wall.inner == 0.0) return wall.outer - low;
  const double r = std::clamp(0.5 * (wall.inner + wall.outer), low, high);
  return std::min(wall.outer - r, r - wall.inner);
}

}  // namespace

double pointDepth(const TurnedProfile& profile, const ProfilePoint& a, const ProfilePoint& b) {
  if (!a.allFinite() || !b.allFinite()) return 0.0;
  const double spacing = profile.spacing(), from = a.y() / spacing, along = b.y() / spacing - from;
  if (along == 0.0) return std::max(0.0, deepestIn(wallBetween(profile, from, from), a.x(), b.x()));
  const double low = std::max(0.0, std::min(from, from + along));
  const double high = std::min(static_cast<double>(profile.size() - 1), std::max(from, from + along));
  double deepest = 0.0;
  const auto radiusAt = [&](double sample) { return a.x() + (sample - from) / along * (b.x() - a.x()); };
  for (double cell = std::floor(low); cell < high; cell += 1.0) {
    const double begin = std::max(low, cell), end = std::min(high, cell + 1.0);
    const double middle = 0.5 * (begin + end);
    deepest = std::max(deepest, deepestIn(wallBetween(profile, middle, middle), radiusAt(begin), radiusAt(end)));
  }
  return deepest;
}

TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& how, const ProfilePoint& a, const ProfilePoint& b) {
  if (how.thread) return {};
  if (how.isExact) {
    const ProfileSegment move{a, b, 0.0};
    if (const std::optional<ExactStep> step = cutExactly(profile, how, move, move, 0)) return step->changed;
  }
  return cutSamples(profile, how, a, b);
}

TurnedProfile::Range cutSamples(TurnedProfile& profile, const TurningPass& how, const ProfilePoint& a,
                                const ProfilePoint& b) {
  if (how.thread) return {};
  if (how.tool) return cutWithTool(profile, *how.tool, a, b).changed;
  if (how.noseRadius == 0.0) return cutByPoint(profile, how.side, a, b);
  if (how.method == TurningMethod::Poles)
    return ControlPointCut(profile, how.resolution, how.isInParts).cut(profile, how.side, a, b, how.noseRadius);
  return how.side == TurningSide::Bore ? profile.cutBore(a, b, how.noseRadius) : profile.cut(a, b, how.noseRadius);
}

TurnedProfile::Range cut(TurnedProfile& profile, const std::shared_ptr<const TurningPass>& pass, std::uint32_t number,
                         Progress progress) {
  constexpr std::size_t kLook = 64;  // points between two checks of the cancel flag
  const TurnedProfile before = profile;
  const PassSteps steps(*pass, number);
  TurnedProfile::Range changed;
  for (std::size_t i = 0; i < pass->path.size() && !pass->isExact; ++i) {
    if (i % kLook == 0) {
      if (progress.cancelled()) return changed;
      progress.set(static_cast<double>(i) / static_cast<double>(pass->path.size()));
    }
    changed.extend(steps.cut(profile, i));
  }
  if (pass->isExact || !changed.isEmpty()) changed.extend(settlePass(profile, before, pass, number, progress));
  return changed;
}

TurnedProfile::Range cut(TurnedProfile& profile, const TurningPass& pass, Progress progress) {
  return cut(profile, std::make_shared<const TurningPass>(pass), 0, progress);
}

std::uint64_t samplesUnder(const TurnedProfile& profile, const TurningPass& pass) {
  constexpr double kMost = 1e18;
  if (pass.thread) return 0;
  const ControlPointCut poles(profile, pass.resolution, pass.isInParts);
  double sum = 0.0;
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    const ProfilePoint &a = pass.path[i == 0 ? 0 : i - 1], &b = pass.path[i];
    sum += pass.tool ? static_cast<double>(samplesUnderTool(profile, *pass.tool, a, b))
           : pass.method == TurningMethod::Poles
               ? poles.work(profile, a, b, pass.noseRadius, i > 0)
               : static_cast<double>(profile.samplesUnder(a, b, std::max(pass.noseRadius, profile.spacing())).size());
  }
  return static_cast<std::uint64_t>(std::min(sum, kMost));
}

}  // namespace handwheel
