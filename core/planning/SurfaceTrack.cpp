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

double distanceToSegment(const Vec3& place, const Vec3& a, const Vec3& b) {
  return (place - closestOnSegment(place, a, b)).norm();
}

double SurfaceTrack::length() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i].place - points[i - 1].place).norm();
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
  constexpr int kFewest = 4;  // steps of a part have two in a row
  int toAndFro = 0;
  Vec3 before = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < track.points.size(); ++i) {
    const Vec3 from = track.points[i].place - track.points[i - 1].place;
    const Vec3 to = track.points[i + 1].place - track.points[i].place;
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
  const auto wayTo = [&](std::size_t i) { return Vec3((points[i].place - points[i - 1].place).normalized()); };
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 direction = Vec3::Zero();
    if (i > 0) direction += wayTo(i);
    if (i + 1 < count) direction += wayTo(i + 1);
    if (track.isClosed && i == 0) direction += wayTo(count - 1);
    if (track.isClosed && i + 1 == count) direction += wayTo(1);
    points[i].direction = direction.normalized();
  }
  for (TrackPoint& point : points) {
    Vec3 normal = point.normal - point.normal.dot(point.direction) * point.direction;
    if (!(normal.norm() > 1e-9)) normal = point.direction.unitOrthogonal();
    point.normal = normal.normalized();
  }
}

SurfaceTrack pieceFrom(const SurfaceTrack& track, const Vec3& place, double length) {
  const std::vector<TrackPoint>& points = track.points;
  if (points.size() < 2 || !(length > 0.0)) return {};
  std::size_t nearest = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double distance = distanceToSegment(place, points[i - 1].place, points[i].place);
    if (!(distance < least)) continue;
    least = distance;
    nearest = i;
  }
  const auto between = [&](std::size_t i, double share) {
    const TrackPoint &a = points[i - 1], &b = points[i];
    return TrackPoint{a.place + share * (b.place - a.place), Vec3::Zero(), a.normal + share * (b.normal - a.normal)};
  };
  const Vec3 way = points[nearest].place - points[nearest - 1].place;
  const double from = std::clamp((place - points[nearest - 1].place).dot(way) / way.squaredNorm(), 0.0, 1.0);
  SurfaceTrack piece;
  piece.points.push_back(between(nearest, from));
  const std::size_t count = points.size() - 1;  // segments
  for (std::size_t k = 0; k <= count && length > 0.0; ++k) {
    if (!track.isClosed && nearest + k > count) break;
    const std::size_t i = (nearest - 1 + k) % count + 1;
    const double to = k == count ? from : 1.0;  // round to where it began
    const double step = (between(i, to).place - piece.points.back().place).norm();
    const double share = step > length ? length / step : 1.0;
    length -= step;
    if (!(step > 0.0)) continue;
    TrackPoint end = between(i, to);
    end.place = piece.points.back().place + share * (end.place - piece.points.back().place);
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
    double worst = 1.0;  // in units of what is allowed
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distanceToSegment(points[i].place, points[first].place, points[last].place) / deviation;
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
  for (const SurfaceTrack& way : {track, track.reversed()}) {
    SurfaceTrack ahead = pieceFrom(way, from, kAll);
    ahead.isClosed = false;
    // What is behind the second place is cut off from the other end.
    const SurfaceTrack piece = pieceFrom(ahead.reversed(), to, kAll).reversed();
    if (piece.points.empty() || (piece.points.back().place - to).norm() > tolerance) continue;
    if (shortest.points.empty() || piece.length() < shortest.length()) shortest = piece;
  }
  return shortest;
}

}  // namespace handwheel
