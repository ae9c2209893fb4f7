// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/RemovedMaterial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

// Counts the change of a sample from one radius to another.
void countChange(RemovedMaterial& cut, std::size_t i, double before, double after, double spacing) {
  cut.changed.extend({i, i + 1});
  cut.area += std::abs(before - after) * spacing;
  cut.volume += M_PI * std::abs(before * before - after * after) * spacing;
  cut.depth = std::max(cut.depth, std::abs(before - after));
}

// Calls change(sample, its new radius), which returns true if that is a change.
template <class Change>
RemovedMaterial cutWith(const TurnedProfile& profile, const SectionSweep& sweep, TurningSide side, Change change) {
  RemovedMaterial cut;
  if (sweep.empty()) return cut;
  const TurnedProfile::Range under = samplesWithin(profile, sweep.first(), sweep.last());
  for (std::size_t i = under.first; i < under.last; ++i) {
    const double z = profile.z(i), outer = profile.radius(i), inner = profile.inner(i);
    if (!(outer > inner)) continue;
    // Beyond the material it cuts nothing: a shank there would be in the work.
    if (!(sweep.lowest(z) < outer && sweep.highest(z) > inner)) continue;
    if (side == TurningSide::Outside) {
      const double left = std::max(sweep.lowest(z), inner);
      if (!(left < outer && change(i, left))) continue;
      countChange(cut, i, outer, left, profile.spacing());
      cut.beyond = std::max(cut.beyond, outer - sweep.largest());
    } else {
      const double left = std::min(sweep.highest(z), outer);
      if (!(left > inner && change(i, left))) continue;
      countChange(cut, i, inner, left, profile.spacing());
      cut.beyond = std::max(cut.beyond, sweep.least() - inner);
    }
  }
  return cut;
}

double segmentDistance(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  const ProfilePoint along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

double sideOf(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& p) {
  return (b.y() - a.y()) * (p.x() - a.x()) - (b.x() - a.x()) * (p.y() - a.y());
}

bool isInConvex(std::span<const ProfilePoint> corners, const ProfilePoint& p) {
  if (corners.size() < 3) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (sideOf(corners[i], corners[(i + 1) % corners.size()], p) < 0.0) return false;
  }
  return true;
}

bool segmentsCross(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c, const ProfilePoint& d) {
  return sideOf(a, b, c) * sideOf(a, b, d) < 0.0 && sideOf(c, d, a) * sideOf(c, d, b) < 0.0;
}

}  // namespace

void RemovedMaterial::add(const RemovedMaterial& other) {
  changed.extend(other.changed);
  area += other.area;
  volume += other.volume;
  depth = std::max(depth, other.depth);
  beyond = std::max(beyond, other.beyond);
}

TurnedProfile::Range samplesWithin(const TurnedProfile& profile, double first, double last) {
  if (!(first <= profile.length() && last >= 0.0)) return {};
  const double end = static_cast<double>(profile.size() - 1);
  const auto from = static_cast<std::size_t>(std::clamp(std::ceil(first / profile.spacing()), 0.0, end));
  const auto to = static_cast<std::size_t>(std::clamp(std::floor(last / profile.spacing()), 0.0, end));
  return {from, to + 1};
}

RemovedMaterial cutSection(TurnedProfile& profile, const SectionSweep& sweep, TurningSide side) {
  return cutWith(profile, sweep, side, [&](std::size_t i, double left) {
    return side == TurningSide::Outside ? profile.limitOuter(i, left) : profile.limitInner(i, left);
  });
}

RemovedMaterial previewCut(const TurnedProfile& profile, const SectionSweep& sweep, TurningSide side) {
  return cutWith(profile, sweep, side, [](std::size_t, double left) { return std::isfinite(left); });
}

SectionOverlap overlapOf(const TurnedProfile& profile, const SectionSweep& sweep, double within) {
  SectionOverlap deepest;
  if (sweep.empty() || !(sweep.largest() > -within && sweep.least() < within)) return deepest;
  const TurnedProfile::Range under = samplesWithin(profile, sweep.first(), sweep.last());
  for (std::size_t i = under.first; i < under.last; ++i) {
    const double z = profile.z(i), outer = profile.radius(i), inner = profile.inner(i);
    if (!(outer > inner)) continue;
    const double low = sweep.lowest(z), high = sweep.highest(z);
    const double here = std::min(outer, high) - std::max(inner, low);
    const double beyond = std::min(outer, -low) - std::max(inner, -high);
    if (const double depth = std::max(here, beyond); depth > deepest.depth)
      deepest = {depth, {here >= beyond ? std::max(inner, low) : -std::max(inner, -high), z}};
  }
  return deepest;
}

double distanceBetween(const RoundedPolygon& a, const RoundedPolygon& b) {
  const auto p = a.corners(), q = b.corners();
  if (p.empty() || q.empty()) return std::numeric_limits<double>::infinity();
  if (isInConvex(p, q[0]) || isInConvex(q, p[0])) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const ProfilePoint &p0 = p[i], &p1 = p[(i + 1) % p.size()];
    for (std::size_t k = 0; k < q.size(); ++k) {
      const ProfilePoint &q0 = q[k], &q1 = q[(k + 1) % q.size()];
      if (segmentsCross(p0, p1, q0, q1)) return 0.0;
      least = std::min({least, segmentDistance(p0, q0, q1), segmentDistance(q0, p0, p1)});
    }
  }
  return std::max(0.0, least - a.radius() - b.radius());
}

}  // namespace handwheel
