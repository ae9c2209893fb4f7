// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/ReferenceProfile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace handwheel {

namespace {

bool isBelow(const ProfilePoint& p, double z) {
  return p.y() < z;
}

const char* problemOf(const std::vector<ProfilePoint>& line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!line[i].allFinite() || line[i].norm() > ProfileCurve::kLargestCoordinate) return "a coordinate is impossible";
    if (line[i].x() < 0.0) return "a radius is negative";
    if (i > 0 && line[i].y() < line[i - 1].y()) return "the points go back in z";
  }
  return nullptr;
}

// The larger radius of a line at a height; 0 beyond its ends.
double radiusOn(const std::vector<ProfilePoint>& line, double z) {
  if (line.empty() || !(z >= line.front().y() && z <= line.back().y())) return 0.0;
  auto next = std::lower_bound(line.begin(), line.end(), z, isBelow);
  double largest = 0.0;
  if (next != line.begin() && next->y() > z) {
    const ProfilePoint &a = next[-1], &b = *next;
    largest = std::lerp(a.x(), b.x(), (z - a.y()) / (b.y() - a.y()));
  }
  for (; next != line.end() && next->y() == z; ++next) largest = std::max(largest, next->x());
  return largest;
}

double distanceToSegment(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  const ProfilePoint along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

// The distance to the nearest segment. From the height of the point both ways, until all further ones are too far.
double distanceTo(std::span<const ProfilePoint> line, const ProfilePoint& p) {
  double best = std::numeric_limits<double>::infinity();
  if (line.size() < 2) return best;
  const auto at = std::lower_bound(line.begin(), line.end(), p.y(), isBelow);
  const auto start = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at - line.begin(), 1, std::ssize(line) - 1));
  for (std::size_t i = start; i < line.size() && line[i - 1].y() - p.y() < best; ++i)
    best = std::min(best, distanceToSegment(p, line[i - 1], line[i]));
  for (std::size_t i = start; i-- > 1 && p.y() - line[i].y() < best;)
    best = std::min(best, distanceToSegment(p, line[i - 1], line[i]));
  return best;
}

}  // namespace

Result<ReferenceProfile> ReferenceProfile::make(std::vector<ProfilePoint> outer, std::vector<ProfilePoint> inner) {
  const auto malformed = [](const char* what) { return Error{ErrorCode::ElementMalformed, {"target", what}, {}, {}}; };
  if (const std::size_t count = outer.size() + inner.size(); count > kMostPoints)
    return Error{ErrorCode::FileTooLarge, {"points", std::to_string(count), std::to_string(kMostPoints)}, {}, {}};
  if (outer.size() < 2 || inner.size() == 1) return malformed("it has too few points");
  for (const auto* line : {&outer, &inner}) {
    if (const char* problem = problemOf(*line)) return malformed(problem);
  }
  if (!(outer.back().y() > outer.front().y())) return malformed("it has no length");
  ReferenceProfile profile;
  profile.m_outer = std::move(outer);
  profile.m_inner = std::move(inner);
  for (const ProfilePoint& p : profile.m_inner) {
    if (p.y() < profile.from() || p.y() > profile.to()) return malformed("the bore is longer than the part");
    if (p.x() > profile.radius(TurningSide::Outside, p.y())) return malformed("the bore is wider than the part");
  }
  profile.m_outerClosed = profile.m_outer;
  const ProfilePoint low(radiusOn(profile.m_inner, profile.from()), profile.from());
  const ProfilePoint high(radiusOn(profile.m_inner, profile.to()), profile.to());
  profile.m_outerClosed.insert(profile.m_outerClosed.begin(), low);
  profile.m_outerClosed.push_back(high);
  return profile;
}

double ReferenceProfile::radius(TurningSide side, double z) const {
  return radiusOn(side == TurningSide::Outside ? m_outer : m_inner, z);
}

double ReferenceProfile::distance(TurningSide side, const ProfilePoint& p) const {
  return distanceTo(side == TurningSide::Outside ? m_outerClosed : m_inner, p);
}

ReferenceDeviation deviationFrom(const ReferenceProfile& reference, const TurnedProfile& profile, AxisRange range,
                                 Progress progress) {
  constexpr std::size_t kLook = 1024;  // samples between two looks at the cancel flag
  ReferenceDeviation deviation;
  const auto count = [&](double distance, double z) {
    if (distance > deviation.left) deviation.left = distance, deviation.leftAt = z;
    if (-distance > deviation.gouged) deviation.gouged = -distance, deviation.gougedAt = z;
  };
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (i % kLook == 0 && progress.cancelled()) break;
    const double z = profile.z(i);
    if (!(z >= range.from && z <= range.to)) continue;
    const double wanted = reference.radius(TurningSide::Outside, z), bore = reference.radius(TurningSide::Bore, z);
    if (!profile.hasMaterial(i)) {
      if (wanted > bore) count(-reference.distance(TurningSide::Outside, {bore, z}), z);
      continue;
    }
    const ProfilePoint outer(profile.radius(i), z), inner(profile.inner(i), z);
    const double outside = reference.distance(TurningSide::Outside, outer);
    count(outer.x() > wanted ? outside : -outside, z);
    if (bore == 0.0) {
      if (inner.x() > 0.0 && wanted > 0.0) count(-std::min(inner.x(), reference.distance(TurningSide::Bore, inner)), z);
      continue;
    }
    const double inside = reference.distance(TurningSide::Bore, inner);
    count(inner.x() < bore ? inside : -inside, z);
  }
  return deviation;
}

}  // namespace handwheel
