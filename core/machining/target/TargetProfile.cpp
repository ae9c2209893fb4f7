// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TargetProfile.h"

#include "machining/target/OutlineChecks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

double crossed(const ProfilePoint& a, const ProfilePoint& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double volumeInside(const std::vector<ProfileSegment>& segments) {
  double sum = 0.0;
  for (const ProfileSegment& segment : segments) sum += segment.squareMoment();
  return M_PI * sum;
}

ProfileBox boxOf(const std::vector<ProfileSegment>& segments) {
  ProfileBox box;
  for (const ProfileSegment& segment : segments) box.extend(segment.box());
  return box;
}

// Returns the points of an arc's circle at a height, as radii from that of its start; twice the same if the height
// touches it. With the chord d from the start and the bulge b, a point v from the start is on the circle if b (v·v −
// v·d) = ½ (1 − b²) v·left(d). No term of that is large for a flat arc, whose centre is far away.
std::optional<std::array<double, 2>> radiiOfCircle(const ProfileSegment& arc, double z) {
  constexpr double kTouching = 1e-14;  // relative discriminant, by rounding
  const ProfilePoint d = arc.to - arc.from;
  const double up = z - arc.from.y(), b = arc.bulge, half = 0.5 * (1.0 - b * b);
  const double linear = half * d.y() - b * d.x(), constant = b * up * (up - d.y()) - half * up * d.x();
  const double square = linear * linear, product = 4.0 * b * constant;
  const double discriminant = square - product;
  if (!(discriminant >= -kTouching * (square + std::abs(product)))) return std::nullopt;
  const double q = -0.5 * (linear + std::copysign(std::sqrt(std::max(discriminant, 0.0)), linear));
  return q == 0.0 ? std::array{0.0, 0.0} : std::array{q / b, constant / q};
}

// Returns true if a point on an arc's circle is on the arc. v: from its start.
bool isOnArc(const ProfileSegment& arc, const ProfilePoint& v) {
  constexpr double kRounding = 1e-12;  // share of the chord
  const ProfilePoint d = arc.to - arc.from;
  const double whole = d.squaredNorm(), along = v.dot(d), aside = crossed(d, v);
  // For an arc of half a circle at most: beside its chord and not across the circle; else on the rest of the circle.
  const bool isMinor = std::abs(arc.bulge) <= 1.0;
  const double bulge = isMinor ? arc.bulge : -1.0 / arc.bulge, slack = isMinor ? kRounding : -kRounding;
  const bool isBeside = along >= -slack * whole && along <= (1.0 + slack) * whole;
  const double toCentre = 0.25 * (1.0 / std::abs(bulge) - std::abs(bulge)) * whole;
  return (isBeside && (bulge > 0.0 ? aside : -aside) <= toCentre) == isMinor;
}

// Extends the range of radii by the points of a segment at a height.
void extendAt(const ProfileSegment& segment, double z, double& least, double& largest) {
  const auto take = [&](double r) {
    least = std::min(least, r);
    largest = std::max(largest, r);
  };
  if (segment.from.y() == z) take(segment.from.x());
  if (segment.to.y() == z) take(segment.to.x());
  if (!std::isfinite(segment.radius())) {
    const double rise = segment.to.y() - segment.from.y(), t = (z - segment.from.y()) / rise;
    if (t > 0.0 && t < 1.0) take(segment.from.x() + t * (segment.to.x() - segment.from.x()));
    return;
  }
  const auto radii = radiiOfCircle(segment, z);
  if (!radii) {
    // Its lowest or highest point, which the height misses by rounding.
    const ProfileBox box = segment.box();
    if (z == box.min().y() || z == box.max().y()) take(segment.centre().x());
    return;
  }
  for (const double r : *radii)
    if (isOnArc(segment, {r, z - segment.from.y()})) take(segment.from.x() + r);
}

}  // namespace

TargetProfile::TargetProfile(std::vector<ProfileSegment> sound, bool isClosed) {
  const double volume = volumeInside(sound);
  const ProfileBox box = boxOf(sound);
  ProfileHierarchy tree(sound);
  m_outline = std::make_shared<const Outline>(Outline{std::move(sound), isClosed, box, volume, std::move(tree)});
}

Result<TargetProfile> TargetProfile::make(std::vector<ProfileSegment> segments, Progress progress) {
  Result<CheckedOutline> outline = checkedOutline(std::move(segments), progress);
  if (!outline) return outline.error();
  return TargetProfile(std::move(outline->segments), outline->isClosed);
}

// A point whose nearest point is a corner is outside if the material fills less than half of the surroundings. On the
// axis the outline continues as its mirror image.
bool TargetProfile::isOutsideOfCorner(std::size_t segment, bool atEnd, const ProfilePoint& p) const {
  const auto& all = m_outline->segments;
  const std::size_t before = atEnd ? segment : segment + all.size() - 1, after = atEnd ? segment + 1 : segment;
  const bool isOnAxis = !m_outline->isClosed && (after == all.size() || (!atEnd && segment == 0));
  const ProfileSegment& in = all[before % all.size()];
  const ProfileSegment& out = all[after % all.size()];
  ProfilePoint arriving = in.direction(1.0), leaving = out.direction(0.0);
  if (isOnAxis && !atEnd) arriving = {leaving.x(), -leaving.y()};
  if (isOnAxis && atEnd) leaving = {arriving.x(), -arriving.y()};
  const double turn = crossed(arriving, leaving);
  if (std::abs(turn) > 1e-6) return turn > 0.0;
  const ProfilePoint corner = atEnd ? all[segment].to : all[segment].from;
  return crossed(arriving + leaving, p - corner) < 0.0;
}

double TargetProfile::distance(const ProfilePoint& p) const {
  if (!p.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const ProfileHierarchy::Nearest near = m_outline->tree.nearest(m_outline->segments, p);
  const ProfileSegment& segment = m_outline->segments[near.segment];
  bool isOutside = false;
  if (near.point == segment.from || near.point == segment.to) {
    isOutside = isOutsideOfCorner(near.segment, near.point == segment.to, p);
  } else if (std::isfinite(segment.radius())) {
    const bool isBeyond = (p - near.point).dot(p - segment.centre()) > 0.0;
    isOutside = isBeyond == (segment.bulge > 0.0);
  } else {
    isOutside = crossed(segment.to - segment.from, p - segment.from) < 0.0;
  }
  return isOutside ? near.distance : -near.distance;
}

std::optional<TargetProfile::Extent> TargetProfile::extentAt(double z) const {
  const Outline& outline = *m_outline;
  if (!(z >= lowerEnd() && z <= upperEnd())) return std::nullopt;
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  outline.tree.meeting(ProfileBox(ProfilePoint(outline.box.min().x(), z), ProfilePoint(outline.box.max().x(), z)),
                       [&](std::size_t i) {
                         extendAt(outline.segments[i], z, least, largest);
                         return true;
                       });
  if (!(largest >= 0.0)) return std::nullopt;
  // An arc that leaves a face along it may go beyond it by rounding, which makes no recess.
  const bool isAxisInside = !outline.isClosed && z >= outline.segments.front().from.y() - kJoin &&
                            z <= outline.segments.back().to.y() + kJoin;
  return Extent{isAxisInside ? 0.0 : std::max(least, 0.0), largest};
}

TargetProfile TargetProfile::moved(double dz) const {
  std::vector<ProfileSegment> all = m_outline->segments;
  for (ProfileSegment& segment : all) {
    segment.from.y() += dz;
    segment.to.y() += dz;
  }
  return TargetProfile(std::move(all), m_outline->isClosed);
}

// Reflected, and traversed in reverse so that the material stays on the left: both reverse an arc, so it keeps its
// bulge.
TargetProfile TargetProfile::turnedEndForEnd() const {
  const double sum = lowerEnd() + upperEnd();
  const auto reflected = [sum](const ProfilePoint& p) { return ProfilePoint(p.x(), sum - p.y()); };
  std::vector<ProfileSegment> all;
  all.reserve(m_outline->segments.size());
  for (auto segment = m_outline->segments.rbegin(); segment != m_outline->segments.rend(); ++segment)
    all.push_back({reflected(segment->to), reflected(segment->from), segment->bulge});
  return TargetProfile(std::move(all), m_outline->isClosed);
}

bool TargetProfile::operator==(const TargetProfile& other) const {
  return m_outline == other.m_outline || m_outline->segments == other.m_outline->segments;
}

}  // namespace handwheel
