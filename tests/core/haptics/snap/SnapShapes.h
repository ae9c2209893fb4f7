// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapField.h"
#include "haptics/snap/SnapProfile.h"

#include <random>
#include <vector>

// Features to snap to, and an independent computation of the nearest point. The computation uses no code of the
// program.
namespace handwheel::test {

using Real = long double;
using Vec3l = Eigen::Matrix<Real, 3, 1>;

inline constexpr SnapShape kSnapShapes[] = {SnapShape::Spring, SnapShape::Triangular, SnapShape::Quadratic,
                                            SnapShape::Gaussian};
inline constexpr SnapShape kSmoothShapes[] = {SnapShape::Triangular, SnapShape::Quadratic, SnapShape::Gaussian};

// Returns the force according to the equations 3-1 to 3-3 (He 2008; SnapProfile.h). k: stiffness; ls: snap distance;
// x: distance from the feature.
inline Real forceByEquation(SnapShape shape, Real k, Real ls, Real x) {
  if (x <= 0 || x >= ls) return 0;
  const auto g = [&](Real at) {
    const Real z = (at - ls / 2) / (ls / 6);
    return std::exp(-z * z / 2);
  };
  if (shape == SnapShape::Spring) return k * x;
  if (shape == SnapShape::Triangular) return x <= ls / 2 ? k * x : k * (ls - x);
  if (shape == SnapShape::Quadratic) return k * x * (ls - x) * (2 / ls);
  return k * (ls / 2) * (g(x) - g(0)) / (1 - g(0));
}

// Returns the largest slope of the force, as a multiple of k.
inline double slopeByEquation(SnapShape shape) {
  if (shape == SnapShape::Quadratic) return 2.0;
  return shape == SnapShape::Gaussian ? 1.8401 : 1.0;
}

// A convex feature.
struct Simplex {
  SnapKind kind = SnapKind::Point;
  std::vector<Vec3> corners;

  std::size_t dimension() const { return corners.size() - 1; }
};

inline Vec3l nearestOnLine(const Vec3l& p, const Vec3l& a, const Vec3l& b) {
  const Vec3l along = b - a;
  const Real length2 = along.squaredNorm();
  const Real t = length2 > 0 ? std::clamp<Real>((p - a).dot(along) / length2, 0, 1) : 0;
  return a + t * along;
}

// Returns the point of a triangle nearest to p, by the regions of the triangle's plane (Ericson, Real-Time Collision
// Detection, 5.1.5).
inline Vec3l nearestOnFace(const Vec3l& p, const Vec3l& a, const Vec3l& b, const Vec3l& c) {
  const Vec3l normal = (b - a).cross(c - a);
  const bool hasArea = normal.squaredNorm() > 0;
  const auto isInside = [&](const Vec3l& from, const Vec3l& to) { return normal.cross(to - from).dot(p - from) >= 0; };
  if (hasArea && isInside(a, b) && isInside(b, c) && isInside(c, a))
    return p - normal * ((p - a).dot(normal) / normal.squaredNorm());
  Vec3l best = nearestOnLine(p, a, b);
  for (const Vec3l& q : {nearestOnLine(p, b, c), nearestOnLine(p, c, a)})
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  return best;
}

inline Vec3l nearestOn(const Simplex& s, const Vec3& p) {
  const auto at = [&](std::size_t i) -> Vec3l { return s.corners[i].cast<Real>(); };
  if (s.corners.size() == 1) return at(0);
  if (s.corners.size() == 2) return nearestOnLine(p.cast<Real>(), at(0), at(1));
  return nearestOnFace(p.cast<Real>(), at(0), at(1), at(2));
}

inline Real distanceTo(const Simplex& s, const Vec3& p) {
  return (nearestOn(s, p) - p.cast<Real>()).norm();
}

inline Simplex point(const Vec3& a) {
  return {SnapKind::Point, {a}};
}
inline Simplex segment(const Vec3& a, const Vec3& b) {
  return {SnapKind::Segment, {a, b}};
}
inline Simplex face(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {SnapKind::Facet, {a, b, c}};
}

// Converts simplices to features. The number of each feature is its index in the list.
inline SnapFeatures featuresOf(const std::vector<Simplex>& simplices) {
  SnapFeatures features;
  for (std::uint32_t i = 0; i < simplices.size(); ++i) {
    const auto& c = simplices[i].corners;
    if (c.size() == 1) features.addPoint(i, c[0]);
    if (c.size() == 2) features.addSegment(i, c[0], c[1]);
    if (c.size() == 3) features.addTriangle(i, c[0], c[1], c[2]);
  }
  return features;
}

inline SnapField fieldOf(const std::vector<Simplex>& simplices) {
  return SnapField(featuresOf(simplices));
}

inline Vec3 randomIn(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  const double x = number(random), y = number(random);
  return {x, y, number(random)};
}

// Returns random simplices of all kinds in a cube of half-width `size` (mm). Each is about `length` (mm) long.
inline std::vector<Simplex> randomSimplices(std::mt19937& random, std::size_t count, double size, double length,
                                            const Vec3& middle = Vec3::Zero()) {
  std::vector<Simplex> simplices;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 a = middle + randomIn(random, size);
    const Vec3 b = a + randomIn(random, length), c = a + randomIn(random, length);
    const std::size_t dimension = random() % 3;
    simplices.push_back(dimension == 0 ? point(a) : dimension == 1 ? segment(a, b) : face(a, b, c));
  }
  return simplices;
}

// Returns the sum of the forces of all features.
inline Vec3 sumOf(const std::vector<Simplex>& simplices, SnapShape shape, double k, double ls, const Vec3& hand) {
  Vec3l sum = Vec3l::Zero();
  for (const Simplex& s : simplices) {
    const Vec3l toNearest = nearestOn(s, hand) - hand.cast<Real>();
    if (const Real x = toNearest.norm(); x > 0) sum += toNearest * (forceByEquation(shape, k, ls, x) / x);
  }
  return sum.cast<double>();
}

}  // namespace handwheel::test
