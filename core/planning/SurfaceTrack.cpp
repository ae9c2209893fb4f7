// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/SurfaceTrack.h"

#include "base/Units.h"
#include "mesh/structure/AngleBetween.h"
#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

double distanceToSegment(const Vec3& position, const Vec3& a, const Vec3& b) {
  return (position - closestOnSegment(position, a, b)).norm();
}

double SurfaceTrack::length() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i].position - points[i - 1].position).norm();
  return sum;
}

SurfaceTrack SurfaceTrack::reversed() const {
  SurfaceTrack other = *this;
  std::reverse(other.points.begin(), other.points.end());
  for (TrackPoint& point : other.points) point.direction = -point.direction;
  return other;
}

bool isJagged(const SurfaceTrack& track) {
  constexpr double kBend = 15.0 * kRadiansPerDegree;
  constexpr int kFewest = 4;  // stairs of a part have two in a row
  int toAndFro = 0;
  Vec3 before = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < track.points.size(); ++i) {
    const Vec3 from = track.points[i].position - track.points[i - 1].position;
    const Vec3 to = track.points[i + 1].position - track.points[i].position;
    const bool isBend = angleBetween(from, to) > kBend;
    const Vec3 side = isBend ? Vec3(from.cross(to).normalized()) : Vec3(Vec3::Zero());
    if (before.dot(side) < 0.0) ++toAndFro;
    before = side;
  }
  return toAndFro >= kFewest;
}

void orient(SurfaceTrack& track) {
  std::vector<TrackPoint>& points = track.points;
  const std::size_t count = points.size();
  const auto directionTo = [&](std::size_t i) {
    return Vec3((points[i].position - points[i - 1].position).normalized());
  };
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 direction = Vec3::Zero();
    if (i > 0) direction += directionTo(i);
    if (i + 1 < count) direction += directionTo(i + 1);
    if (track.isClosed && i == 0) direction += directionTo(count - 1);
    if (track.isClosed && i + 1 == count) direction += directionTo(1);
    points[i].direction = direction.normalized();
  }
  for (TrackPoint& point : points) {
    Vec3 normal = point.normal - point.normal.dot(point.direction) * point.direction;
    if (!(normal.norm() > 1e-9)) normal = point.direction.unitOrthogonal();
    point.normal = normal.normalized();
  }
}

SurfaceTrack pieceFrom(const SurfaceTrack& track, const Vec3& position, double length) {
  const std::vector<TrackPoint>& points = track.points;
  if (points.size() < 2 || !(length > 0.0)) return {};
  std::size_t nearest = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double distance = distanceToSegment(position, points[i - 1].position, points[i].position);
    if (!(distance < least)) continue;
    least = distance;
    nearest = i;
  }
  const auto between = [&](std::size_t i, double share) {
    const TrackPoint &a = points[i - 1], &b = points[i];
    return TrackPoint{a.position + share * (b.position - a.position), Vec3::Zero(),
                      a.normal + share * (b.normal - a.normal)};
  };
  const Vec3 segment = points[nearest].position - points[nearest - 1].position;
  const double from =
      std::clamp((position - points[nearest - 1].position).dot(segment) / segment.squaredNorm(), 0.0, 1.0);
  SurfaceTrack piece;
  piece.points.push_back(between(nearest, from));
  const std::size_t count = points.size() - 1;  // segments
  for (std::size_t k = 0; k <= count && length > 0.0; ++k) {
    if (!track.isClosed && nearest + k > count) break;
    const std::size_t i = (nearest - 1 + k) % count + 1;
    const double to = k == count ? from : 1.0;  // back to its beginning
    const double step = (between(i, to).position - piece.points.back().position).norm();
    const double share = step > length ? length / step : 1.0;
    length -= step;
    if (!(step > 0.0)) continue;
    TrackPoint end = between(i, to);
    end.position = piece.points.back().position + share * (end.position - piece.points.back().position);
    piece.points.push_back(end);
    piece.isClosed = k == count && share == 1.0;
  }
  if (piece.points.size() < 2) return {};
  orient(piece);
  return piece;
}

SurfaceTrack simplified(const SurfaceTrack& track, double deviation, double angle) {
  const std::vector<TrackPoint>& points = track.points;
  if (points.size() < 3) return track;
  std::vector<bool> isKept(points.size(), false);
  isKept.front() = isKept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = 1.0;  // relative to the tolerances
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off =
          distanceToSegment(points[i].position, points[first].position, points[last].position) / deviation;
      const double turned = std::min(angleBetween(points[i].normal, points[first].normal),
                                     angleBetween(points[i].normal, points[last].normal)) /
                            angle;
      const double share = std::max(off, turned);
      if (share > worst) {
        worst = share;
        at = i;
      }
    }
    if (at == first) continue;
    isKept[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  SurfaceTrack kept{{}, track.isClosed};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isKept[i]) kept.points.push_back(points[i]);
  }
  orient(kept);
  return kept;
}

SurfaceTrack pieceBetween(const SurfaceTrack& track, const Vec3& from, const Vec3& to, double tolerance) {
  constexpr double kAll = std::numeric_limits<double>::max();
  SurfaceTrack shortest;
  for (const SurfaceTrack& curve : {track, track.reversed()}) {
    SurfaceTrack ahead = pieceFrom(curve, from, kAll);
    ahead.isClosed = false;
    // The part beyond the second point is cut off from the other end.
    const SurfaceTrack piece = pieceFrom(ahead.reversed(), to, kAll).reversed();
    if (piece.points.empty() || (piece.points.back().position - to).norm() > tolerance) continue;
    if (shortest.points.empty() || piece.length() < shortest.length()) shortest = piece;
  }
  return shortest;
}

}  // namespace handwheel
