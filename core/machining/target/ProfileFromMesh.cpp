// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileFromMesh.h"

#include "base/NumberText.h"
#include "machining/target/OutlineJoining.h"
#include "machining/target/TargetErrors.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace handwheel {

namespace {

constexpr double kRingWidth = 1e-4;  // mm; points nearer than this in r and z belong to one ring
constexpr double kRingGap = 1e-3;    // mm, between the ends of the outline's pieces

struct Axis {
  Vec3 point{0, 0, 0}, direction{0, 0, 1};
};

// All normals of a surface of revolution meet its axis, a line with the direction d and the moment m:
// d · (c × n) + m · n = 0 for each point c (Pottmann and Randrup 1998). Least squares with |d| = 1.
class NormalLines {
 public:
  explicit NormalLines(const TriangleSoup& soup) {
    for (const Vec3& p : soup.points) m_centre += p / static_cast<double>(soup.points.size());
    for (const Triangle& t : soup.triangles) {
      const Vec3 a = soup.points[t[0]] - m_centre, b = soup.points[t[1]] - m_centre, c = soup.points[t[2]] - m_centre;
      const Vec3 twice = (b - a).cross(c - a);
      const double weight = twice.norm();
      if (!(weight > 0.0)) continue;
      const Vec3 normal = twice / weight, moment = ((a + b + c) / 3.0).cross(normal);
      m_moments += weight * moment * moment.transpose();
      m_mixed += weight * moment * normal.transpose();
      m_normals += weight * normal * normal.transpose();
    }
    m_solve = m_normals.completeOrthogonalDecomposition().solve(m_mixed.transpose());
  }

  // Returns the best line of a direction.
  Axis along(const Vec3& direction) const {
    const Vec3 moment = -m_solve * direction;
    return {m_centre + direction.cross(moment), direction};
  }
  Axis best() const {
    const Eigen::Matrix3d left = m_moments - m_mixed * m_solve;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(0.5 * (left + left.transpose()));
    Vec3 direction = solver.eigenvectors().col(0);
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    if (direction[largest] < 0.0) direction = -direction;
    return along(direction);
  }

 private:
  Vec3 m_centre{0, 0, 0};
  Eigen::Matrix3d m_moments = Eigen::Matrix3d::Zero(), m_mixed = Eigen::Matrix3d::Zero(),
                  m_normals = Eigen::Matrix3d::Zero(), m_solve = Eigen::Matrix3d::Zero();
};

// The points of a mesh about an axis, sorted into rings.
class MeshRings {
 public:
  MeshRings(const TriangleSoup& soup, const Axis& axis) : m_ring(soup.points.size()) {
    const Vec3 across = axis.direction.unitOrthogonal(), third = axis.direction.cross(across);
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
      const Vec3 from = soup.points[i] - axis.point;
      const double x = from.dot(across), y = from.dot(third);
      m_points.push_back({std::hypot(x, y), axis.direction.dot(soup.points[i]), std::atan2(y, x), i});
    }
    std::sort(m_points.begin(), m_points.end(), [](const MeshPoint& a, const MeshPoint& b) { return a.z < b.z; });
    split(0, m_points.size(), &MeshPoint::z, [this](std::size_t first, std::size_t last) {
      // All points of a flat get one height: rounding would tilt it, and the end would lose its width.
      const double low = m_points[first].z, high = m_points[last - 1].z;
      if (high - low <= kRingWidth) std::for_each(at(first), at(last), [&](MeshPoint& p) { p.z = 0.5 * (low + high); });
      std::sort(at(first), at(last), [](const MeshPoint& a, const MeshPoint& b) { return a.r < b.r; });
      split(first, last, &MeshPoint::r, [this](std::size_t f, std::size_t l) { addRing(f, l); });
    });
  }

  std::size_t ringOf(std::size_t point) const { return m_ring[point]; }
  // The rings from the lower to the higher, those of one height outwards.
  std::size_t count() const { return m_rings.size(); }
  const ProfilePoint& ringPoint(std::size_t ring) const { return m_rings[ring]; }
  // Returns the distance of the widest gap's chord from the circle of the ring, mm.
  double deviation(std::size_t ring) const { return m_deviations[ring]; }
  double largestRadius() const { return m_largest; }

 private:
  struct MeshPoint {
    double r, z, angle;
    std::size_t point;
  };
  std::vector<MeshPoint>::iterator at(std::size_t i) { return m_points.begin() + static_cast<std::ptrdiff_t>(i); }

  template <class Take>
  void split(std::size_t first, std::size_t last, double MeshPoint::*by, const Take& take) {
    for (std::size_t begin = first; begin < last;) {
      std::size_t end = begin + 1;
      while (end < last && m_points[end].*by - m_points[end - 1].*by <= kRingWidth) ++end;
      take(begin, end);
      begin = end;
    }
  }

  void addRing(std::size_t first, std::size_t last) {
    ProfilePoint middle(0, 0);
    std::vector<double> angles;
    for (std::size_t i = first; i < last; ++i) {
      middle += ProfilePoint(m_points[i].r, m_points[i].z) / static_cast<double>(last - first);
      angles.push_back(m_points[i].angle);
      m_ring[m_points[i].point] = m_rings.size();
    }
    if (middle.x() <= kRingWidth) middle.x() = 0.0;
    const auto [low, high] =
        std::minmax_element(at(first), at(last), [](const MeshPoint& a, const MeshPoint& b) { return a.z < b.z; });
    middle.y() = std::clamp(middle.y(), low->z, high->z);  // the mean may be rounded beyond its points
    m_rings.push_back(middle);
    m_largest = std::max(m_largest, middle.x());
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + 2.0 * M_PI - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
    m_deviations.push_back(middle.x() * (1.0 - std::cos(0.5 * std::min(gap, 2.0 * M_PI))));
  }

  std::vector<MeshPoint> m_points;
  std::vector<ProfilePoint> m_rings;
  std::vector<std::size_t> m_ring;  // ring of each point
  std::vector<double> m_deviations;
  double m_largest = 0.0;
};

// The outline through the rings of a mesh, which is kept by reference. Points within a flat end or shoulder may be
// arbitrary: the flat is one line.
class RingOutline {
 public:
  RingOutline(const TriangleSoup& soup, const MeshRings& rings)
      : m_soup(soup), m_rings(rings), m_hasWall(rings.count()) {
    for (const Triangle& t : soup.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = rings.ringOf(t[k]), b = rings.ringOf(t[(k + 1) % 3]);
        if (a != b && !isFlat(a, b)) m_hasWall[a] = m_hasWall[b] = true;
      }
    }
  }

  // Returns the largest deviation of the rings of walls, mm. O(rings).
  double deviation() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < m_rings.count(); ++i)
      if (m_hasWall[i]) largest = std::max(largest, m_rings.deviation(i));
    return largest;
  }

  // Returns the lines of the outline, once. O(n log n) of the triangles.
  std::vector<ProfileSegment> lines(const Axis& axis) && {
    std::set<std::pair<std::size_t, std::size_t>> joined, flat;
    for (const Triangle& t : m_soup.triangles) {
      bool isFlatTriangle = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t a = m_rings.ringOf(t[k]), b = m_rings.ringOf(t[(k + 1) % 3]);
        isFlatTriangle = isFlatTriangle && isFlat(a, b);
        if (a != b) (isFlat(a, b) ? flat : joined).insert(std::minmax(a, b));
      }
      if (isFlatTriangle && isAcross(axis, m_soup, t)) m_acrossAxis.insert(m_rings.ringOf(t[0]));
    }
    for (const auto& [a, b] : joined) add(m_rings.ringPoint(a), m_rings.ringPoint(b));
    addFlats(flat);
    return std::move(m_lines);
  }

 private:
  bool isFlat(std::size_t a, std::size_t b) const {
    return std::abs(m_rings.ringPoint(a).y() - m_rings.ringPoint(b).y()) <= kRingWidth;
  }
  // Returns true if the axis goes through a triangle.
  static bool isAcross(const Axis& axis, const TriangleSoup& soup, const Triangle& t) {
    int left = 0, right = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 from = soup.points[t[k]] - axis.point, to = soup.points[t[(k + 1) % 3]] - axis.point;
      const double side = axis.direction.dot(from.cross(to));
      left += side > 0.0;
      right += side < 0.0;
    }
    return (left == 0) != (right == 0);
  }
  void add(const ProfilePoint& from, const ProfilePoint& to) {
    if (from.x() > 0.0 || to.x() > 0.0) m_lines.push_back({from, to, 0.0});
  }

  // Flats of one height do not overlap, and their rings follow one another.
  void addFlats(const std::set<std::pair<std::size_t, std::size_t>>& edges) {
    for (auto edge = edges.begin(); edge != edges.end();) {
      const std::size_t inner = edge->first;
      std::size_t outer = edge->second;
      const auto goesOn = [&] { return edge->first < outer || (edge->first == outer && !m_hasWall[outer]); };
      while (++edge != edges.end() && goesOn()) outer = std::max(outer, edge->second);
      const auto across = m_acrossAxis.lower_bound(inner);
      const bool isDisc = across != m_acrossAxis.end() && *across <= outer;
      const ProfilePoint& from = m_rings.ringPoint(inner);
      add(isDisc ? ProfilePoint(0.0, from.y()) : from, m_rings.ringPoint(outer));
    }
  }

  const TriangleSoup& m_soup;
  const MeshRings& m_rings;
  std::vector<bool> m_hasWall;         // true for each ring that bounds a face that is not flat
  std::set<std::size_t> m_acrossAxis;  // rings of flat triangles that the axis goes through
  std::vector<ProfileSegment> m_lines;
};

}  // namespace

double turnedMeshTolerance(double radius) {
  constexpr double kLeast = 0.1, kShare = 0.005;
  return std::max(kLeast, kShare * radius);
}

// Directions of the coordinates come first: a ball has many axes.
Result<ProfileFromMesh> profileFromMesh(const TriangleSoup& soup, Progress progress) {
  if (soup.triangles.empty()) return Error{TargetError::NoAxis, {}, {}, {}};
  const NormalLines lines(soup);
  double least = std::numeric_limits<double>::infinity(), tolerance = 0.0;
  for (const Axis& axis :
       {lines.along(Vec3::UnitZ()), lines.along(Vec3::UnitX()), lines.along(Vec3::UnitY()), lines.best()}) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    const MeshRings rings(soup, axis);
    RingOutline found(soup, rings);
    const double deviation = found.deviation(), allowed = turnedMeshTolerance(rings.largestRadius());
    if (deviation < least) {
      least = deviation;
      tolerance = allowed;
    }
    if (!(deviation <= allowed)) continue;
    Result<std::vector<ProfileSegment>> outline = joinedOutline(std::move(found).lines(axis), kRingGap, progress);
    if (!outline) return outline.error();
    Result<TargetProfile> target = TargetProfile::make(std::move(outline.value()), progress);
    if (!target) return target.error();
    return ProfileFromMesh{std::move(target.value()), deviation};
  }
  return Error{TargetError::MeshNotTurned, {roundedText(least, 3), roundedText(tolerance, 3)}, {}, {}};
}

}  // namespace handwheel
