// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/DrawnOutline.h"

#include "machining/drawing/PartDrawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

using Kind = ProfileFeature::Kind;

constexpr double kLargestChamfer = 5.0;  // mm
constexpr double kSmooth = 0.02;         // rad, between the directions of two features that touch
constexpr double kAtEnd = 0.02;          // share of the radius; nearer to its end an arc has no extreme

// Returns the unit tangent of a feature at its start or end, in the direction of the outline.
ProfilePoint directionAt(const ProfileFeature& f, bool atEnd) {
  if (f.kind != Kind::Arc) return (f.end() - f.start()).normalized();
  const ProfilePoint out = ((atEnd ? f.end() : f.start()) - f.centre).normalized();
  return (f.isConvex ? 1.0 : -1.0) * ProfilePoint(-out.y(), out.x());
}

double angleBetween(const ProfilePoint& a, const ProfilePoint& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

}  // namespace

bool isChamfer(const ProfileFeature& f) {
  constexpr double kRounded = 1e-3;  // mm
  return f.kind == Kind::Taper && std::abs(f.value - M_PI / 4) < 0.01 && f.length() <= kLargestChamfer + kRounded;
}

DrawnOutline::DrawnOutline(std::vector<ProfileFeature> features, bool isClosed)
    : m_features(std::move(features)), m_isClosed(isClosed) {}

std::optional<std::size_t> DrawnOutline::neighbour(std::size_t i, bool atEnd) const {
  const std::size_t count = m_features.size();
  const bool isLast = atEnd ? i + 1 == count : i == 0;
  if (count < 2 || (isLast && !m_isClosed)) return std::nullopt;
  return atEnd ? (i + 1) % count : (i + count - 1) % count;
}

DrawnOutline::Joint DrawnOutline::jointAt(std::size_t i, bool atEnd) const {
  const auto other = neighbour(i, atEnd);
  if (!other) return Joint::None;
  if (!is(i, Kind::Arc) && !is(*other, Kind::Arc)) return Joint::Corner;
  const ProfilePoint here = directionAt(m_features[i], atEnd), there = directionAt(m_features[*other], !atEnd);
  if (angleBetween(here, there) > kSmooth) return Joint::Corner;
  return std::abs(here.x()) < kSmooth ? Joint::SmoothAlongAxis : Joint::Smooth;
}

bool DrawnOutline::isBall(std::size_t i) const {
  return is(i, Kind::Arc) && std::abs(m_features[i].centre.x()) < kLeastDrawn;
}

bool DrawnOutline::endsOnAxis(std::size_t i) const {
  return std::min(m_features[i].low.x(), m_features[i].high.x()) < kLeastDrawn;
}

bool DrawnOutline::isEdgeChamfer(std::size_t i) const {
  if (!isChamfer(m_features[i])) return false;
  const auto isFace = [&](bool atEnd) {
    const auto other = neighbour(i, atEnd);
    return other && is(*other, Kind::FlatFace);
  };
  return isFace(true) || isFace(false) || endsOnAxis(i);
}

std::optional<ProfilePoint> DrawnOutline::extremeOf(std::size_t i) const {
  const ProfileFeature& f = m_features[i];
  const double margin = kAtEnd * f.value;
  if (!is(i, Kind::Arc) || isBall(i) || !(f.centre.y() > f.low.y() + margin && f.centre.y() < f.high.y() - margin))
    return std::nullopt;
  // A fillet in a narrow corner of a face has its position from its radius.
  const auto before = neighbour(i, false), after = neighbour(i, true);
  const bool isAtFace = (before && is(*before, Kind::FlatFace)) || (after && is(*after, Kind::FlatFace));
  if (isAtFace && isFillet(i)) return std::nullopt;
  const bool isOutwards = f.isConvex != f.isInner;
  return ProfilePoint(f.centre.x() + (isOutwards ? f.value : -f.value), f.centre.y());
}

bool DrawnOutline::isEquator(std::size_t i, bool atEnd) const {
  const auto other = neighbour(i, atEnd);
  return other && is(i, Kind::Arc) && is(*other, Kind::Arc) && jointAt(i, atEnd) == Joint::SmoothAlongAxis;
}

bool DrawnOutline::isFillet(std::size_t i) const {
  return is(i, Kind::Arc) && jointAt(i, false) > Joint::Corner && jointAt(i, true) > Joint::Corner;
}

bool DrawnOutline::hasOwnCentre(std::size_t i) const {
  const ProfileFeature& f = m_features[i];
  return isBall(i) && f.centre.y() > f.low.y() && f.centre.y() < f.high.y() && !endsOnAxis(i);
}

bool DrawnOutline::hasFixedCentre(std::size_t i) const {
  if (!is(i, Kind::Arc)) return false;
  return isFillet(i) || isEquator(i, false) || isEquator(i, true) || (isBall(i) && endsOnAxis(i)) || hasOwnCentre(i) ||
         extremeOf(i).has_value();
}

bool DrawnOutline::needsDiameter(std::size_t i, bool atEnd) const {
  const auto other = neighbour(i, atEnd);
  if (is(i, Kind::Taper)) return !isEdgeChamfer(i) && !(other && hasFixedCentre(*other));
  if (isEquator(i, atEnd)) return !isBall(i) && !isBall(*other);
  return is(i, Kind::Arc) && !isBall(i) && !hasFixedCentre(i) && jointAt(i, atEnd) == Joint::Corner;
}

// Returns true if the joint of two features, neither of which is a face, has a dimension along the axis.
bool DrawnOutline::isHeight(std::size_t before, std::size_t after) const {
  const Joint joint = jointAt(before, true);
  if (joint != Joint::Corner) return isEquator(before, true);
  if (isEdgeChamfer(before) || isEdgeChamfer(after)) return false;
  for (const auto& [fixed, other] : {std::pair(before, after), std::pair(after, before)}) {
    if (hasFixedCentre(fixed) && (!is(other, Kind::Arc) || hasFixedCentre(other))) return false;
  }
  for (const auto& [chamfer, other] : {std::pair(before, after), std::pair(after, before)}) {
    // The height of one end suffices.
    const ProfileFeature& f = m_features[chamfer];
    const ProfilePoint at = m_features[before].end();
    if (isChamfer(f) && !isChamfer(m_features[other])) return at.x() > 0.5 * (f.low.x() + f.high.x());
  }
  return true;
}

std::vector<double> DrawnOutline::heights(bool isInner) const {
  std::vector<double> faces, others;
  const auto isOf = [&](std::size_t i) { return !is(i, Kind::FlatFace) && m_features[i].isInner == isInner; };
  for (std::size_t i = 0; i < m_features.size(); ++i) {
    const ProfileFeature& f = m_features[i];
    const auto before = neighbour(i, false), after = neighbour(i, true);
    if (is(i, Kind::FlatFace)) {
      if ((before && isOf(*before)) || (after && isOf(*after))) faces.push_back(f.low.y());
      continue;
    }
    if (!isOf(i)) continue;
    if (!before) others.push_back(f.start().y());
    if (!after) others.push_back(f.end().y());
    if (after && !is(*after, Kind::FlatFace) && isHeight(i, *after)) others.push_back(f.end().y());
    if (extremeOf(i) || hasOwnCentre(i)) others.push_back(f.centre.y());
  }
  faces.insert(faces.end(), others.begin(), others.end());
  return faces;
}

}  // namespace handwheel
