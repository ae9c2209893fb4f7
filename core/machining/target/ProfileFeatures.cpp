// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileFeatures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

// Returns true if two neighbours are pieces of one line or circle.
bool isContinued(const ProfileSegment& a, const ProfileSegment& b, double tolerance) {
  if (a.isArc() != b.isArc()) return false;
  if (a.isArc()) {
    return (a.bulge > 0.0) == (b.bulge > 0.0) && std::abs(a.radius() - b.radius()) <= tolerance &&
           (a.centre() - b.centre()).norm() <= tolerance;
  }
  const ProfileSegment whole{a.from, b.to, 0.0};
  return a.direction(1.0).dot(b.direction(0.0)) > 0.0 && (whole.nearest(a.to) - a.to).norm() <= tolerance;
}

ProfileSegment together(const ProfileSegment& a, const ProfileSegment& b) {
  const double angle = a.angle() + b.angle();
  return {a.from, b.to, a.isArc() ? std::tan(0.25 * angle) : 0.0};
}

ProfileFeature featureOf(const ProfileSegment& s, double tolerance) {
  ProfileFeature feature;
  const ProfilePoint along = s.to - s.from;
  const bool isFace = !s.isArc() && std::abs(along.y()) <= tolerance;
  const bool isUp = isFace ? along.x() > 0.0 : along.y() > 0.0;
  feature.low = isUp ? s.from : s.to;
  feature.high = isUp ? s.to : s.from;
  feature.isDownwards = !isUp;
  // Material is on the left: what runs down faces the axis.
  feature.isInner = !isFace && s.direction(0.5).y() < 0.0;
  if (s.isArc()) {
    feature.kind = ProfileFeature::Kind::Arc;
    feature.value = s.radius();
    feature.centre = s.centre();
    feature.isConvex = s.bulge > 0.0;
  } else if (isFace) {
    feature.kind = ProfileFeature::Kind::FlatFace;
  } else if (std::abs(along.x()) <= tolerance) {
    feature.kind = ProfileFeature::Kind::Cylinder;
    feature.value = s.from.x() + s.to.x();
  } else {
    feature.kind = ProfileFeature::Kind::Taper;
    feature.value = std::atan2(std::abs(along.x()), std::abs(along.y()));
  }
  return feature;
}

// A shoulder on the outside that leans over, as an insert leaves it, is no bore, although it faces the axis. The
// outside goes from the lowest point of the outline to its highest point.
void keepShouldersOutside(std::vector<ProfileFeature>& features, double tolerance) {
  constexpr double kShoulder = 75.0 * M_PI / 180.0;  // least angle to the axis
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const ProfileFeature& f : features) {
    lowest = std::min(lowest, f.low.y());
    highest = std::max(highest, f.high.y());
  }
  bool isOutside = false;
  // A closed outline may begin on its outside: the second round knows.
  for (int round = 0; round < 2; ++round) {
    for (ProfileFeature& f : features) {
      if (f.start().y() <= lowest + tolerance) isOutside = true;
      if (f.start().y() >= highest - tolerance) isOutside = false;
      const bool isShoulder = f.kind == ProfileFeature::Kind::Taper && f.value > kShoulder;
      if (isOutside && isShoulder) f.isInner = false;
    }
  }
}

constexpr std::size_t kLeastPieces = 5;   // pieces of a curve
constexpr double kLongestPiece = 10.0;    // mm, along the axis
constexpr double kMostTurn = M_PI / 6.0;  // rad, between two pieces
constexpr double kJoined = 1e-9;          // mm

bool isPiece(const ProfileFeature& f) {
  const bool isLine = f.kind == ProfileFeature::Kind::Taper || f.kind == ProfileFeature::Kind::Cylinder;
  return isLine && f.length() <= kLongestPiece;
}

// Returns true if a piece follows another on the same surface of a curve. The outline goes up the outside and down a
// bore.
bool turnsOn(const ProfileFeature& a, const ProfileFeature& b) {
  if (!isPiece(a) || !isPiece(b) || a.isInner != b.isInner) return false;
  const ProfilePoint gap = a.end() - b.start();
  const auto slope = [](const ProfileFeature& f) { return std::atan2(f.high.x() - f.low.x(), f.length()); };
  return gap.norm() <= kJoined && std::abs(slope(a) - slope(b)) <= kMostTurn;
}

}  // namespace

std::vector<ProfileFeature> featuresOf(const TargetProfile& profile, double tolerance) {
  std::vector<ProfileSegment> merged;
  for (const ProfileSegment& s : profile.segments()) {
    const bool isSame = !merged.empty() && isContinued(merged.back(), s, tolerance) &&
                        std::abs(merged.back().angle() + s.angle()) < 1.99 * M_PI;
    if (isSame) {
      merged.back() = together(merged.back(), s);
    } else {
      merged.push_back(s);
    }
  }
  // A closed outline may begin within a feature.
  if (profile.isClosed() && merged.size() > 2 && isContinued(merged.back(), merged.front(), tolerance)) {
    merged.front() = together(merged.back(), merged.front());
    merged.pop_back();
  }
  std::vector<ProfileFeature> features;
  features.reserve(merged.size());
  for (const ProfileSegment& s : merged) features.push_back(featureOf(s, tolerance));
  keepShouldersOutside(features, tolerance);
  return features;
}

std::vector<ProfileFeature> withCurves(const std::vector<ProfileFeature>& features) {
  std::vector<ProfileFeature> listed;
  const auto isCylinder = [&](std::size_t i) { return features[i].kind == ProfileFeature::Kind::Cylinder; };
  for (std::size_t first = 0; first < features.size();) {
    std::size_t end = first + 1;
    if (!isCylinder(first)) {
      while (end < features.size() && turnsOn(features[end - 1], features[end])) ++end;
      while (end > first + 1 && isCylinder(end - 1)) --end;
    }
    if (end - first < kLeastPieces) {
      listed.push_back(features[first++]);
      continue;
    }
    ProfileFeature curve = features[first];
    curve.kind = ProfileFeature::Kind::Curve;
    curve.value = 0.0;
    (curve.isDownwards ? curve.low : curve.high) = features[end - 1].end();
    listed.push_back(curve);
    first = end;
  }
  return listed;
}

const char* nameOf(ProfileFeature::Kind kind) {
  switch (kind) {
    case ProfileFeature::Kind::Cylinder:
      return "cylinder";
    case ProfileFeature::Kind::Taper:
      return "taper";
    case ProfileFeature::Kind::FlatFace:
      return "face";
    case ProfileFeature::Kind::Arc:
      return "arc";
    case ProfileFeature::Kind::Curve:
      break;
  }
  return "curve";
}

}  // namespace handwheel
