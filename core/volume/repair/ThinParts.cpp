// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/ThinParts.h"

#include "proximity/TriangleHierarchy.h"
#include "volume/VolumeSampler.h"
#include "volume/repair/BoundingTriangles.h"
#include "volume/repair/ClosedSurfaceInVoxels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {
namespace {

// All lengths are in voxels here.
constexpr double kThinRadius = 1.0;       // radius of a ball that is as thick as two voxels
constexpr double kEnoughOfRadius = 0.98;  // share of the radius that counts as all of it
constexpr double kReachOfBall = 3.0;      // from a point to the middle of such a ball: its radius, and two voxels
constexpr double kTouching = 1e-4;        // thickness; surfaces that are nearer touch
constexpr std::size_t kFewestThinPoints = 4'000, kMostThinPoints = 100'000, kMostMeasuredPoints = 20'000;
constexpr double kLeastThinArea = 8.0;  // square voxels; what is thin on less is as small as a speck of noise
constexpr std::size_t kLeastThinPoints = 3;

struct FacingPoint {
  Vec3 at, normal;  // outwards
  double area;      // square voxels
};

// The numbers of the point in a sequence that fills the unit square evenly (Roberts's R2).
std::pair<double, double> evenly(std::size_t i) {
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
  const auto number = static_cast<double>(i);
  const double u = number * kFirst, v = number * kSecond;
  return {u - std::floor(u), v - std::floor(v)};
}

// Points all over triangles that all bound the inside, in proportion to their areas.
std::vector<FacingPoint> pointsOnTriangles(const TriangleSoup& soup, std::size_t own, const std::vector<bool>& isUsed) {
  std::vector<double> until;
  double area = 0.0;
  const auto cross = [&](std::size_t i) {
    const Triangle& t = soup.triangles[i];
    return Vec3((soup.points[t[1]] - soup.points[t[0]]).cross(soup.points[t[2]] - soup.points[t[0]]));
  };
  for (std::size_t i = 0; i < own; ++i) until.push_back(area += isUsed[i] ? 0.5 * cross(i).norm() : 0.0);
  std::vector<FacingPoint> points;
  if (!(area > 0.0)) return points;
  const auto count = static_cast<std::size_t>(std::clamp<double>(area, kFewestThinPoints, kMostThinPoints));
  const double each = area / static_cast<double>(count);
  points.reserve(count);
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (triangle + 1 < own && until[triangle] <= (static_cast<double>(i) + 0.5) * each) ++triangle;
    auto [u, v] = evenly(i + 1);
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    const Triangle& t = soup.triangles[triangle];
    const Vec3& a = soup.points[t[0]];
    points.push_back(
        {a + u * (soup.points[t[1]] - a) + v * (soup.points[t[2]] - a), cross(triangle).normalized(), each});
  }
  return points;
}

// Crossings of rows along all axes: a square voxel of a surface is crossed by as many as the sum of its normal's parts.
std::vector<FacingPoint> pointsOfRows(const TriangleSoup& soup, std::size_t own, const BoundingTriangles& found) {
  std::vector<FacingPoint> points;
  const std::size_t step = found.points().size() / kMostThinPoints + 1;
  for (std::size_t i = 0; i < found.points().size(); i += step) {
    const auto& [at, triangle] = found.points()[i];
    if (triangle >= own) continue;
    const Triangle& t = soup.triangles[triangle];
    const Vec3 normal =
        (soup.points[t[1]] - soup.points[t[0]]).cross(soup.points[t[2]] - soup.points[t[0]]).normalized();
    const double rows = normal.cwiseAbs().sum();
    if (rows > 0.0) points.push_back({at, normal, static_cast<double>(step) / rows});
  }
  return points;
}

struct Thickness {
  double length;
  bool isStraight;  // measured to a surface that faces the point; else it is the diameter of a ball
};

class ThinSearch {
 public:
  ThinSearch(const TriangleHierarchy& surface, ThinKind kind)
      : m_surface(surface), m_facing(kind == ThinKind::Walls ? 1.0 : -1.0) {}

  // Returns the thickness along `across` from a point of the surface; nothing where that is two voxels or more.
  std::optional<Thickness> thickness(const Vec3& at, const Vec3& across) const {
    if (!m_surface.isWithin(at + kThinRadius * across, kEnoughOfRadius * kThinRadius)) return std::nullopt;
    const std::optional<double> radius = climbed(at, across);
    if (!radius) return std::nullopt;
    const std::optional<double> straight = straightAcross(at, across);
    return Thickness{straight.value_or(2.0 * *radius), straight.has_value()};
  }

 private:
  // Returns the radius of the largest ball that touches the surface at the point.
  double touching(const Vec3& at, const Vec3& across) const {
    constexpr int kRounds = 6;
    double radius = kThinRadius;
    for (int i = 0; i < kRounds; ++i) {
      const auto nearest = m_surface.nearest(at + radius * across, kEnoughOfRadius * radius);
      if (!nearest) break;
      const Vec3 toNearest = nearest->point - at;
      const double ahead = toNearest.dot(across);
      if (!(ahead > 0.0)) break;  // the surface is bent away here
      radius = std::min(radius, toNearest.squaredNorm() / (2.0 * ahead));
    }
    return radius;
  }

  // Moves a ball away from the last two surfaces that it touched, which lets it grow. Returns the largest radius that
  // was reached; nothing if that is enough.
  std::optional<double> climbed(const Vec3& at, const Vec3& across) const {
    constexpr int kRounds = 48;
    constexpr double kStep = 0.8, kLeastStep = 0.02, kBeyond = 1.5, kOpposite = 0.15, kSame = 0.98;
    double best = touching(at, across);
    Vec3 middle = at + best * across, last = across, other = across;
    for (int i = 0; i < kRounds; ++i) {
      const auto nearest = m_surface.nearest(middle, kThinRadius);
      if (!nearest) return std::nullopt;
      const double radius = std::sqrt(nearest->squaredDistance);
      best = std::max(best, radius);
      if (radius >= kEnoughOfRadius * kThinRadius) return std::nullopt;
      if (!(radius > 0.0)) break;
      const Vec3 away = (middle - nearest->point) / radius;
      if (away.dot(last) < kSame) other = last;
      last = away;
      const Vec3 between = away + other;
      if (between.norm() < kOpposite) break;  // walls that are parallel
      const double wanted = kBeyond * (kThinRadius - radius) + kLeastStep;
      middle += std::min(kStep * radius, wanted) * between.normalized();
      if ((middle - at).norm() > kReachOfBall * kThinRadius) break;
    }
    return best;
  }

  // Returns the distance to a surface on the other side that faces this one.
  std::optional<double> straightAcross(const Vec3& at, const Vec3& across) const {
    constexpr double kStart = 1e-6, kFacing = 0.7;
    const auto hit = m_surface.firstHit(at + kStart * across, across);
    if (!hit || hit->distance > 2.0 * kThinRadius) return std::nullopt;
    const auto [a, b, c] = m_surface.corners(hit->triangle);
    if ((b - a).cross(c - a).normalized().dot(across) * m_facing < kFacing) return std::nullopt;
    return kStart + hit->distance;
  }

  const TriangleHierarchy& m_surface;
  double m_facing;  // 1: the normal of the other side points along `across`, -1: against it
};

}  // namespace

ThinParts thinParts(const ClosedSurfaceInVoxels& surface, std::size_t own, const BoundingTriangles& found,
                    const std::vector<bool>& bounding, const Progress& progress) {
  const TriangleSoup& soup = surface.closed;
  const double voxel = surface.grid.voxel();
  ThinParts thin;
  thin.below = 2.0 * kThinRadius * voxel;
  const std::vector<FacingPoint> points =
      found.isSimple() ? pointsOnTriangles(soup, own, bounding) : pointsOfRows(soup, own, found);
  std::vector<Triangle> used;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    if (bounding[i]) used.push_back(soup.triangles[i]);
  const TriangleHierarchy hierarchy(soup.points, used, progress);
  if (progress.cancelled() || hierarchy.empty()) return thin;
  const ThinSearch walls(hierarchy, ThinKind::Walls), gaps(hierarchy, ThinKind::Gaps);
  std::vector<std::array<std::optional<Thickness>, 2>> thickness(points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 256), [&](const tbb::blocked_range<std::size_t>&
                                                                                    range) {
    for (std::size_t i = range.begin(); i < range.end() && !progress.cancelled(); ++i)
      thickness[i] = {walls.thickness(points[i].at, -points[i].normal), gaps.thickness(points[i].at, points[i].normal)};
  });
  if (progress.cancelled()) return thin;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FacingPoint& p = points[i];
    const double area = p.area * voxel * voxel;
    thin.area += area;
    const auto add = [&](std::vector<ThinParts::Point>& to, const std::optional<Thickness>& across,
                         const Vec3& direction) {
      if (across && across->length > kTouching)
        to.push_back(
            {surface.grid.origin() + voxel * p.at, direction, across->length * voxel, across->isStraight, area});
    };
    add(thin.walls, thickness[i][0], -p.normal);
    add(thin.gaps, thickness[i][1], p.normal);
  }
  return thin;
}

ThinFigures thinFigures(const ThinParts& parts, ThinKind kind, const std::function<bool(const Vec3&)>& isInside) {
  const std::vector<ThinParts::Point>& points = kind == ThinKind::Walls ? parts.walls : parts.gaps;
  const double voxel = 0.5 * parts.below / kThinRadius;
  const double leastArea = kLeastThinArea * voxel * voxel;
  ThinFigures figures;
  figures.below = parts.below;
  for (const ThinParts::Point& p : points) figures.area += p.area;
  if (points.size() < kLeastThinPoints || figures.area < leastArea) return {.below = parts.below};
  // A ball that is found near the rim of a plate may be smaller than the plate is thick.
  const auto thinnest = std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return std::pair(!a.isStraight, a.thickness) < std::pair(!b.isStraight, b.thickness);
  });
  figures.share = figures.area / parts.area;
  figures.least = thinnest->thickness;
  figures.at = thinnest->at;

  // The share across each that is not as it was.
  constexpr int kAcross = 16;
  constexpr double kMuch = 0.5;
  const std::size_t step = points.size() / kMostMeasuredPoints + 1;
  std::vector<double> changed(points.size() / step + 1, 0.0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, (points.size() + step - 1) / step, 64),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        const ThinParts::Point& p = points[i * step];
                        int differing = 0;
                        for (int k = 0; k < kAcross; ++k)
                          differing += isInside(p.at + (k + 0.5) / kAcross * p.thickness * p.across) !=
                                       (kind == ThinKind::Walls);
                        changed[i] = static_cast<double>(differing) / kAcross;
                      }
                    });
  std::size_t much = 0;
  for (std::size_t i = 0; i * step < points.size(); ++i) {
    const ThinParts::Point& p = points[i * step];
    const double area = p.area * static_cast<double>(step);
    if (changed[i] < kMuch) continue;
    ++much;
    figures.changedArea += area;
  }
  // The voxels round the edges of a plate off, which is less than this share of it.
  constexpr double kLeastChange = 0.02;
  if (much < kLeastThinPoints || figures.changedArea < std::max(leastArea, kLeastChange * figures.area))
    figures.changedArea = 0.0;
  figures.changedShare = figures.changedArea / parts.area;
  return figures;
}

ThinFigures thinFigures(const ThinParts& parts, ThinKind kind, const SparseVolume& volume) {
  return thinFigures(parts, kind, [&](const Vec3& p) { return VolumeSampler(volume).depthAt(p).depth > 0.0; });
}

}  // namespace handwheel
