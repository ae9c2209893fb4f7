// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/FlatFace.h"

#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace handwheel {

namespace {

constexpr double kNearPart = 1e-3;             // Share of the size of a part by which a picked point may be off it
constexpr std::size_t kMostFollowed = 20'000;  // triangles
constexpr double kFlat = 1.5e-6;               // 1 - cos 0.1°

Vec3 areaOf(const TriangleSoup& soup, const Triangle& t) {
  return (soup.points[t[1]] - soup.points[t[0]]).cross(soup.points[t[2]] - soup.points[t[0]]);
}

// Returns the triangle nearest to a point within `most`; degenerate ones are left out.
std::optional<std::size_t> triangleAt(const TriangleSoup& soup, const Vec3& point, double most) {
  std::optional<std::size_t> found;
  double nearest = most * most;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    const bool isFar = (a.cwiseMin(b).cwiseMin(c).array() > point.array() + most).any() ||
                       (a.cwiseMax(b).cwiseMax(c).array() < point.array() - most).any();
    if (isFar || areaOf(soup, t).isZero(0.0)) continue;
    const double apart = (closestOnTriangle(point, a, b, c) - point).squaredNorm();
    if (apart >= nearest) continue;
    nearest = apart;
    found = i;
  }
  return found;
}

// Returns the triangles that have nearly the same normal as this one and lie in its plane.
std::vector<std::size_t> coplanarWith(const TriangleSoup& soup, std::size_t seed, double slack) {
  const Vec3 normal = areaOf(soup, soup.triangles[seed]).normalized();
  const Vec3& origin = soup.points[soup.triangles[seed][0]];
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    if (std::abs((soup.points[t[0]] - origin).dot(normal)) > slack) continue;
    const Vec3 area = areaOf(soup, t);
    const double along = area.dot(normal);
    if (along > 0.0 && along >= (1.0 - kFlat) * area.norm()) found.push_back(i);
  }
  return found;
}

// Returns the triangles of the flat piece around this one: those that share edges with it, by the positions of their
// ends, and so on. If there are very many, all coplanar ones, as the window waits.
std::vector<std::size_t> flatPiece(const TriangleSoup& soup, std::size_t seed, double slack) {
  using Position = std::array<double, 3>;
  using Edge = std::pair<Position, Position>;
  const std::vector<std::size_t> coplanar = coplanarWith(soup, seed, slack);
  if (coplanar.size() > kMostFollowed) return coplanar;
  const auto positionOf = [&](std::uint32_t point) {
    const Vec3& p = soup.points[point];
    return Position{p.x(), p.y(), p.z()};
  };
  const auto edgeOf = [&](std::size_t triangle, std::size_t side) {
    const Triangle& t = soup.triangles[triangle];
    return Edge(std::minmax(positionOf(t[side]), positionOf(t[(side + 1) % 3])));
  };
  std::map<Edge, std::vector<std::size_t>> byEdge;
  for (const std::size_t i : coplanar) {
    for (std::size_t side = 0; side < 3; ++side) byEdge[edgeOf(i, side)].push_back(i);
  }
  std::set<std::size_t> isTaken{seed};
  std::vector<std::size_t> taken{seed};
  for (std::size_t next = 0; next < taken.size(); ++next) {
    for (std::size_t side = 0; side < 3; ++side) {
      for (const std::size_t other : byEdge[edgeOf(taken[next], side)]) {
        if (isTaken.insert(other).second) taken.push_back(other);
      }
    }
  }
  return taken;
}

Vec3 middleOf(const TriangleSoup& soup, const std::vector<std::size_t>& piece) {
  Vec3 sum = Vec3::Zero();
  double whole = 0.0;
  for (const std::size_t i : piece) {
    const Triangle& t = soup.triangles[i];
    const double area = areaOf(soup, t).norm();
    sum += area / 3.0 * (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]);
    whole += area;
  }
  return sum / whole;
}

}  // namespace

std::optional<FlatFace> faceAt(const DisplayPart& part, const Vec3& position, bool isWhole) {
  const TriangleSoup& soup = *part.soup;
  const Vec3 local = part.pose.inverse(Eigen::Isometry) * position;
  Box bounds;
  for (const Vec3& point : soup.points) bounds.extend(point);
  if (bounds.isEmpty() || !local.allFinite()) return std::nullopt;
  const double slack = kNearPart * bounds.diagonal().norm();
  const auto seed = triangleAt(soup, local, slack);
  if (!seed) return std::nullopt;
  FlatFace face{.point = position, .normal = part.pose.linear() * areaOf(soup, soup.triangles[*seed]).normalized()};
  face.middle = isWhole ? part.pose * middleOf(soup, flatPiece(soup, *seed, slack)) : position;
  return face;
}

Pose bringingTogether(const Vec3& point, const Vec3& normal, const Vec3& onto, const Vec3& ontoNormal, double offset,
                      double angle) {
  const Eigen::Quaterniond facing = Eigen::Quaterniond::FromTwoVectors(normal, Vec3(-ontoNormal));
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, ontoNormal).toRotationMatrix() * facing.normalized().toRotationMatrix();
  Pose motion = Pose::Identity();
  motion.linear() = turn;
  motion.translation() = onto + offset * ontoNormal - turn * point;
  return motion;
}

}  // namespace handwheel
