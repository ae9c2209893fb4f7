// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/Tolerance.h"
#include "document/formats/PolygonTriangulation.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <numeric>

using namespace handwheel;

namespace {

struct Cut {
  PolygonTriangulation::Outcome outcome;
  std::vector<Triangle> triangles;
};

Cut cut(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0u);
  Cut result;
  PolygonTriangulation triangulation([] { return true; });
  result.outcome = triangulation.cut(points, corners, result.triangles);
  return result;
}

Vec3 areaOf(const std::vector<Vec3>& p, const Triangle& t) {
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]) / 2;
}

// The shoelace formula: no triangulation is needed for it.
Vec3 areaOf(const std::vector<Vec3>& p) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) sum += p[i].cross(p[(i + 1) % p.size()]) / 2;
  return sum;
}

// The triangles cover the polygon once: all turn as it does, and their areas add up to its own.
bool coversOnce(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, double smallest = -1e-12) {
  const Vec3 whole = areaOf(points);
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    const double share = areaOf(points, t).dot(whole) / whole.squaredNorm();
    if (share < smallest) return false;
    sum += share;
  }
  return triangles.size() == points.size() - 2 && std::abs(sum - 1.0) < 1e-9;
}

// Distance of a point from a segment.
double distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - along * (b - a)).norm();
}

// The outline of a letter H, and of a comb: corners of different parts are in line.
std::vector<Vec3> letter() {
  return {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {2, 2, 0}, {2, 0, 0}, {3, 0, 0},
          {3, 5, 0}, {2, 5, 0}, {2, 3, 0}, {1, 3, 0}, {1, 5, 0}, {0, 5, 0}};
}
std::vector<Vec3> comb(int teeth) {
  std::vector<Vec3> points{{2.0 * teeth + 1.0, 0, 0}, {2.0 * teeth + 1.0, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  for (int i = 0; i < teeth; ++i) {
    const double x = 2.0 * i + 1.0;
    points.insert(points.end(), {{x, 0, 0}, {x, -3, 0}, {x + 1.0, -3, 0}, {x + 1.0, 0, 0}});
  }
  std::reverse(points.begin(), points.end());
  if (areaOf(points).z() < 0.0) std::reverse(points.begin(), points.end());
  return points;
}
// A square with corners on its edges.
std::vector<Vec3> dividedSquare() {
  std::vector<Vec3> points;
  const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) points.push_back(corners[i] + k / 3.0 * (corners[(i + 1) % 4] - corners[i]));
  }
  return points;
}

std::vector<Vec3> star(int corners, double inner) {
  std::vector<Vec3> points;
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * M_PI * i / corners, r = i % 2 == 0 ? 1.0 : inner;
    points.emplace_back(r * std::cos(a), r * std::sin(a), 0);
  }
  return points;
}

// Any plane: a rotation and a shift.
std::vector<Vec3> moved(std::vector<Vec3> points, const Vec3& axis, double angle) {
  const Eigen::AngleAxisd turn(angle, axis.normalized());
  for (Vec3& p : points) p = turn * p + Vec3(10, -20, 30);
  return points;
}

}  // namespace

class PolygonTriangulationTest : public QObject {
  Q_OBJECT
 private slots:
  void convexPolygonsAreFans() {
    QCOMPARE(cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).triangles, (std::vector<Triangle>{{0, 1, 2}}));
    QCOMPARE(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).triangles,
             (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    QCOMPARE(cut(star(6, 1.0)).triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}));
  }

  // An arrowhead: only the cut through the notch stays inside.
  void concaveQuadIsCutAtItsNotch() {
    for (int first = 0; first < 4; ++first) {
      std::vector<Vec3> points = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}};
      std::rotate(points.begin(), points.begin() + first, points.end());
      QVERIFY(coversOnce(points, cut(points).triangles));
      QVERIFY(coversOnce(moved(points, {1, 2, 3}, 1.1), cut(moved(points, {1, 2, 3}, 1.1)).triangles));
    }
  }

  void concavePolygons() {
    const std::vector<Vec3> comb = {{0, 0, 0}, {7, 0, 0}, {7, 3, 0}, {6, 3, 0}, {6, 1, 0}, {5, 1, 0},
                                    {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {3, 1, 0}, {3, 3, 0}, {2, 3, 0},
                                    {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    QVERIFY(coversOnce(comb, cut(comb).triangles));
    for (double angle : {0.0, 0.7, 2.5, M_PI}) {
      const auto points = moved(comb, {1, -1, 0.5}, angle);
      QVERIFY(coversOnce(points, cut(points).triangles));
    }
    const std::vector<Vec3> turned(comb.rbegin(), comb.rend());
    QVERIFY(coversOnce(turned, cut(turned).triangles));
    QVERIFY(coversOnce(star(1000, 0.3), cut(star(1000, 0.3)).triangles));
  }

  // A square with a square hole, drawn as one outline that goes in and out along the same edge.
  void holeWithABridge() {
    const std::vector<Vec3> points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 0},
                                      {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}};
    QVERIFY((areaOf(points) - Vec3(0, 0, 8)).norm() < 1e-12);
    QVERIFY(coversOnce(points, cut(points).triangles));
  }

  // A healthy polygon must not bring triangles without area.
  void cornersInLine() {
    const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
    QVERIFY(coversOnce(points, cut(points).triangles, 1e-3));
  }

  // Files have polygons at any pose, so corners in line are in line but for rounding. No triangle may reach past a
  // corner: it would intersect what is behind it.
  void cornersInLineAtAnyPose() {
    const std::vector<std::vector<Vec3>> outlines{letter(), comb(3), comb(6), dividedSquare()};
    QVERIFY(rc::check("turned outlines", [&] {
      std::vector<Vec3> points = outlines[*rc::gen::inRange<std::size_t>(0, outlines.size())];
      const auto any = [] { return *rc::gen::inRange(-1'000'000, 1'000'001) / 1e6; };
      const Eigen::Quaterniond turn = Eigen::Quaterniond(any() + 1e-3, any(), any(), any()).normalized();
      const bool isFloat = *rc::gen::arbitrary<bool>();
      const double size = isFloat ? 1.0 : std::pow(10.0, *rc::gen::inRange(-6, 7));
      const Vec3 at = (isFloat ? 1.0 : 100.0) * size * Vec3(any(), any(), any());
      for (Vec3& p : points) {
        p = size * (turn * p) + at;
        if (isFloat) p = p.cast<float>().cast<double>();
      }
      const Cut result = cut(points);
      RC_ASSERT(coversOnce(points, result.triangles));
      const double least = (isFloat ? 1e-4 : 1e-9) * size;
      for (const Triangle& t : result.triangles) {
        for (std::uint32_t corner = 0; corner < points.size(); ++corner) {
          for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if (corner != a && corner != b) RC_ASSERT(distance(points[corner], points[a], points[b]) > least);
          }
        }
      }
    }));
  }

  void notPlanarIsAFan() {
    QCOMPARE(cut({{0, 0, 0}, {2, 1, 1}, {0, 2, 0}, {0.5, 1, -1}}).triangles,
             (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  }

  // A notched quad whose notch is off its plane: up to a thousandth of its size it is cut at the notch as a planar one,
  // beyond that it is a fan.
  void asPlanarAsFilesAre() {
    const auto notched = [](double height) {
      return std::vector<Vec3>{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, height}};
    };
    const auto share = [&](double height) {  // distance of the corners along the normal, relative to the size
      const std::vector<Vec3> points = notched(height);
      const Vec3 normal = areaOf(points).normalized();
      double low = 0.0, high = 0.0;
      for (const Vec3& p : points) {
        low = std::min(low, normal.dot(p));
        high = std::max(high, normal.dot(p));
      }
      return (high - low) / 2.0;
    };
    const double unit = 1e-4 / share(1e-4);  // the height for a share is proportional to it, as long as it is small
    for (const double wanted : {0.9e-3, 1.1e-3}) {
      const double height = unit * wanted;
      QVERIFY(std::abs(share(height) / wanted - 1.0) < 1e-3);
      const bool isFan = cut(notched(height)).triangles == (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
      QCOMPARE(isFan, wanted > tolerance::kPlanarPolygon);
    }
  }

  // No sensible cut exists, but the number of triangles is as for any polygon.
  void nonsense() {
    const std::vector<Vec3> bow = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1.5, 0}};
    QCOMPARE(cut(bow).triangles.size(), std::size_t{2});
    QCOMPARE(cut(std::vector<Vec3>(9, Vec3(1, 2, 3))).triangles.size(), std::size_t{7});
    std::vector<Vec3> twice = star(10, 0.4);
    twice.insert(twice.end(), twice.begin(), twice.begin() + 10);
    QCOMPARE(cut(twice).triangles.size(), std::size_t{18});
    QCOMPARE(cut({{0, 0, 0}, {1e308, 0, 0}, {1e308, 1e308, 0}, {1e300, 1e200, 0}}).triangles.size(), std::size_t{2});
  }

  // Corners at random distances round a centre: simple, mostly concave.
  void randomStars() {
    QVERIFY(rc::check([] {
      const int n = *rc::gen::inRange(4, 60);
      std::vector<Vec3> points;
      for (int i = 0; i < n; ++i) {
        const double a = 2 * M_PI * i / n, r = *rc::gen::inRange(1, 1000) / 100.0;
        points.emplace_back(r * std::cos(a), r * std::sin(a), 0);
      }
      points = moved(points, {1, 2, 2}, *rc::gen::inRange(0, 628) / 100.0);
      const Cut result = cut(points);
      RC_ASSERT(result.outcome == PolygonTriangulation::Outcome::Done);
      RC_ASSERT(coversOnce(points, result.triangles, -1e-9));
    }));
  }

  // Half the corners are notches that every ear has to be tested against: beyond the budget.
  void aHugePolygonEnds() {
    const auto points = star(200000, 0.999999);
    const Cut result = cut(points);
    QCOMPARE(result.outcome, PolygonTriangulation::Outcome::TooComplex);
    QCOMPARE(result.triangles.size(), points.size() - 2);
  }

  void stopsOnCancellation() {
    const auto points = star(100000, 0.5);
    std::vector<std::uint32_t> corners(points.size());
    std::iota(corners.begin(), corners.end(), 0u);
    int asked = 0;
    PolygonTriangulation triangulation([&] { return ++asked < 3; });
    std::vector<Triangle> triangles;
    QCOMPARE(triangulation.cut(points, corners, triangles), PolygonTriangulation::Outcome::Stopped);
    QCOMPARE(asked, 3);
  }
};

HANDWHEEL_TEST(PolygonTriangulationTest)
#include "PolygonTriangulationTest.moc"
