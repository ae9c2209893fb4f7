// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/ProfileMeasure.h"

#include "machining/section/SectionSource.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Rounding of positions that users type, mm.
constexpr double kTypedRounding = 1e-9;

double sideAt(const TurnedProfile& profile, TurningSide side, std::size_t i) {
  return side == TurningSide::Outside ? profile.radius(i) : profile.inner(i);
}

bool isThere(const TurnedProfile& profile, TurningSide side, std::size_t i) {
  return profile.hasMaterial(i) && (side == TurningSide::Outside || profile.inner(i) > 0.0);
}

// Returns the samples of a range; empty if the range is not finite or has none.
TurnedProfile::Range samplesIn(const TurnedProfile& profile, AxisRange range) {
  const double spacing = profile.spacing(), last = static_cast<double>(profile.size() - 1);
  const double from = std::ceil((range.from - kTypedRounding) / spacing),
               to = std::floor((range.to + kTypedRounding) / spacing);
  if (!(from <= to) || !(to >= 0.0) || !(from <= last)) return {};
  return {static_cast<std::size_t>(std::max(from, 0.0)), static_cast<std::size_t>(std::min(to, last)) + 1};
}

// Returns the points of a side in a range; empty if one of them is missing.
std::vector<ProfilePoint> pointsOf(const TurnedProfile& profile, TurningSide side, AxisRange range) {
  const TurnedProfile::Range samples = samplesIn(profile, range);
  std::vector<ProfilePoint> points;
  points.reserve(samples.size());
  for (std::size_t i = samples.first; i < samples.last; ++i) {
    if (!isThere(profile, side, i)) return {};
    points.emplace_back(sideAt(profile, side, i), profile.z(i));
  }
  return points;
}

ProfilePoint meanOf(const std::vector<ProfilePoint>& points) {
  ProfilePoint sum(0.0, 0.0);
  for (const ProfilePoint& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// The algebraic fit (Kåsa): x² + y² = 2ax + 2by + c, about the mean of the points. Returns nothing for points on a
// line.
std::optional<ArcReading> algebraicCircle(const std::vector<ProfilePoint>& points) {
  const ProfilePoint mean = meanOf(points);
  double xx = 0, xy = 0, yy = 0, xq = 0, yq = 0, qq = 0;
  for (const ProfilePoint& p : points) {
    const ProfilePoint d = p - mean;
    const double q = d.squaredNorm();
    xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
    xq += d.x() * q, yq += d.y() * q, qq += q;
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) return std::nullopt;
  const ProfilePoint centre(0.5 * (xq * yy - yq * xy) / determinant, 0.5 * (yq * xx - xq * xy) / determinant);
  ArcReading circle;
  circle.centre = mean + centre;
  circle.radius = std::sqrt(centre.squaredNorm() + qq / static_cast<double>(points.size()));
  return circle;
}

// One step of Gauss and Newton towards the least squares of the distances. Returns the distance that it moved.
double refine(ArcReading& circle, const std::vector<ProfilePoint>& points) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const ProfilePoint& p : points) {
    const ProfilePoint d = p - circle.centre;
    const double distance = d.norm();
    if (!(distance > 0.0)) continue;
    const Eigen::Vector3d row(-d.x() / distance, -d.y() / distance, -1.0);
    normal += row * row.transpose();
    right -= row * (distance - circle.radius);
  }
  const Eigen::Vector3d step = normal.ldlt().solve(right);
  if (!step.allFinite()) return 0.0;
  circle.centre += step.head<2>();
  circle.radius += step.z();
  return step.norm();
}

}  // namespace

std::optional<DiameterReading> measureDiameter(const TurnedProfile& profile, TurningSide side, AxisRange range) {
  const std::vector<ProfilePoint> points = pointsOf(profile, side, range);
  if (points.empty()) return std::nullopt;
  const auto byRadius = [](const ProfilePoint& a, const ProfilePoint& b) { return a.x() < b.x(); };
  const auto [least, largest] = std::minmax_element(points.begin(), points.end(), byRadius);
  return DiameterReading{2.0 * least->x(), 2.0 * largest->x(), 2.0 * meanOf(points).x(), least->y(), largest->y()};
}

std::optional<double> measureFace(const TurnedProfile& profile, TurningSide side, double radius, double near,
                                  double reach) {
  const SectionSource::Pointer source = profile.section() ? profile.section() : SectionSource::fitted(profile);
  const TurnedSection& section = source->section();
  // Returns true if the side is there at a height, and reaches the radius. A bore begins and ends with the part. A
  // shoulder may lean over, so that there is material farther out at its height.
  const auto reaches = [&](double z) {
    const auto radii = section.radiiAt(z);
    if (!radii) return false;
    const bool isMaterial = section.contains({radius, z});
    return side == TurningSide::Outside ? isMaterial : !isMaterial && radius < radii->outer;
  };
  std::optional<double> face;
  const auto offer = [&](double z) {
    constexpr double kBeside = 1e-5;  // mm
    const bool isNearer = !face || std::abs(z - near) < std::abs(*face - near) - kBeside;
    if (std::abs(z - near) <= reach && isNearer && reaches(z - kBeside) != reaches(z + kBeside)) face = z;
  };
  std::vector<double> heights = section.heightsAt(radius);
  for (const TurnedSection& piece : section.pieces()) {
    heights.push_back(piece.box().min().y());
    heights.push_back(piece.box().max().y());
  }
  std::sort(heights.begin(), heights.end());
  for (const double z : heights) offer(z);
  return face;
}

std::optional<ArcReading> measureArc(const TurnedProfile& profile, TurningSide side, AxisRange range) {
  constexpr std::size_t kLeastPoints = 5;
  constexpr int kMostSteps = 50;
  const std::vector<ProfilePoint> points = pointsOf(profile, side, range);
  if (points.size() < kLeastPoints) return std::nullopt;
  std::optional<ArcReading> circle = algebraicCircle(points);
  if (!circle) return std::nullopt;
  for (int i = 0; i < kMostSteps; ++i) {
    if (refine(*circle, points) < 1e-12 * std::abs(circle->radius)) break;
  }
  for (const ProfilePoint& p : points)
    circle->deviation = std::max(circle->deviation, std::abs((p - circle->centre).norm() - circle->radius));
  return circle;
}

}  // namespace handwheel
