// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PartSurface.h"

#include "../collision/TriangleOracle.h"
#include "Scenes.h"
#include "TestClass.h"
#include "robot/ShapeSurfaces.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kPi = std::numbers::pi;

Vec3 anyPosition(double far) {
  return {evenly(-far, far), evenly(-far, far), evenly(-far, far)};
}

// Returns a convex body of triangles: points of an ellipsoid, far from the origin, its triangles in disorder.
TriangleSoup anyEllipsoid(int rows, int columns) {
  TriangleSoup soup;
  const Vec3 half(evenly(10, 90), evenly(10, 90), evenly(10, 90)), middle = anyPosition(1e4);
  for (int i = 0; i <= rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const double polar = kPi * i / rows, azimuth = 2.0 * kPi * k / columns;
      const Vec3 unit(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
      soup.points.push_back(
          middle + (i == 0 || i == rows ? Vec3(0, 0, i == 0 ? half.z() : -half.z()) : Vec3(half.cwiseProduct(unit))));
    }
  }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i * columns + k % columns); };
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      if (i > 0) soup.triangles.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
      if (i + 1 < rows) soup.triangles.push_back({at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)});
    }
  }
  for (std::size_t i = soup.triangles.size(); i > 1; --i)
    std::swap(soup.triangles[i - 1], soup.triangles[*rc::gen::inRange<std::size_t>(0, i)]);
  return soup;
}

// Returns the length of the section of a triangle with a plane; mm.
double cutLength(const Corners& t, const Vec3& on, const Vec3& normal) {
  std::vector<Vec3> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = t[k], &b = t[(k + 1) % 3];
    const double from = (a - on).dot(normal), to = (b - on).dot(normal);
    if ((from < 0.0) != (to < 0.0)) ends.emplace_back(a + from / (from - to) * (b - a));
  }
  return ends.size() == 2 ? (ends[0] - ends[1]).norm() : 0.0;
}

constexpr double kAnywhere = 1e9;

// A box with a corner of 100 × 60 × 40 mm around the origin.
const TriangleSoup kBlock = surfaceOf(BoxShape{{100.0, 60.0, 40.0}});

// A rod of radius 30 and length 80 mm along z with so many sides.
TriangleSoup rod(int sides) {
  TriangleSoup soup;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * kPi * i / sides;
    for (const double z : {-40.0, 40.0}) soup.points.emplace_back(30.0 * std::cos(angle), 30.0 * std::sin(angle), z);
  }
  soup.points.emplace_back(0, 0, -40);
  soup.points.emplace_back(0, 0, 40);
  const auto n = static_cast<std::uint32_t>(2 * sides);
  for (std::uint32_t i = 0; i < n; i += 2) {
    const std::uint32_t j = (i + 2) % n;
    soup.triangles.push_back({i, j, j + 1});
    soup.triangles.push_back({i, j + 1, i + 1});
    soup.triangles.push_back({n, j, i});
    soup.triangles.push_back({n + 1, i + 1, j + 1});
  }
  return soup;
}

// Every triangle with points of its own, as in an STL file.
TriangleSoup loose(const TriangleSoup& soup) {
  TriangleSoup apart;
  for (const Triangle& t : soup.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.points.size());
    for (const std::uint32_t v : t) apart.points.push_back(soup.points[v]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

bool areOriented(const SurfaceTrack& track) {
  for (const TrackPoint& point : track.points) {
    const bool isSound = std::abs(point.direction.norm() - 1.0) < 1e-9 && std::abs(point.normal.norm() - 1.0) < 1e-9 &&
                         std::abs(point.direction.dot(point.normal)) < 1e-9;
    if (!isSound) return false;
  }
  return true;
}

}  // namespace

// Tests curves on parts, whose positions follow from the shapes.
class PartSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // From corner to corner; between the two faces the normal halves their angle.
  void anEdgeOfABox() {
    for (const TriangleSoup& soup : {kBlock, loose(kBlock)}) {
      const SurfaceTrack track = PartSurface(soup).edgeNear({10.0, 28.0, 25.0}, kAnywhere);
      QCOMPARE(track.points.size(), std::size_t{2});
      QVERIFY(!track.isClosed && areOriented(track));
      QCOMPARE(track.length(), 100.0);
      for (const TrackPoint& point : track.points) {
        QVERIFY(std::abs(point.position.y() - 30.0) < 1e-12 && std::abs(point.position.z() - 20.0) < 1e-12);
        QVERIFY((point.normal - Vec3(0.0, 1.0, 1.0).normalized()).norm() < 1e-12);
      }
      const SurfaceTrack back = track.reversed();
      QCOMPARE(back.points.front().position, track.points.back().position);
      QCOMPARE(back.points.front().direction, Vec3(-track.points.back().direction));
    }
  }

  // A rim closes; simplified it stays within the tolerance of the circle's polygon, and comes with fewer points.
  void theRimOfARod() {
    const int sides = 360;
    const SurfaceTrack rim = PartSurface(loose(rod(sides))).edgeNear({0.0, 31.0, 41.0}, kAnywhere);
    QVERIFY(rim.isClosed && areOriented(rim));
    QCOMPARE(rim.points.size(), std::size_t{sides + 1});
    QVERIFY(std::abs(rim.length() - sides * 60.0 * std::sin(kPi / sides)) < 1e-9);
    for (const double tolerance : {0.01, 0.1, 1.0}) {
      const SurfaceTrack fewer = simplified(rim, tolerance, 10.0);
      QVERIFY(fewer.isClosed && fewer.points.size() < rim.points.size() && areOriented(fewer));
      // The points of the rim are on the circle; its own chords are off by r (1 - cos(pi / sides)).
      const double sag = 30.0 * (1.0 - std::cos(kPi / sides));
      for (std::size_t i = 1; i < fewer.points.size(); ++i) {
        const Vec3 middle = 0.5 * (fewer.points[i].position + fewer.points[i - 1].position);
        QVERIFY(30.0 - middle.head<2>().norm() <= tolerance + sag);
      }
    }
    // Normals count, too: at most 5° from that of one end, which at 45° is 7.07° about the rod.
    QVERIFY(simplified(rim, 100.0, 5.0 * kPi / 180.0).points.size() >= 26);
  }

  // A saw is jagged; a circle, a polygon, the steps of a part and a line that is not quite straight are not.
  void jaggedCurves() {
    const auto through = [](int count, auto&& positionOf) {
      SurfaceTrack track;
      for (int i = 0; i < count; ++i) track.points.push_back({positionOf(i), Vec3::UnitX(), Vec3::UnitZ()});
      return track;
    };
    const auto saw = [&](double height, int count) {
      return through(count, [=](int i) { return Vec3(i, i % 2 == 0 ? 0.0 : height, 0.0); });
    };
    QVERIFY(isJagged(saw(0.5, 20)));
    QVERIFY(!isJagged(saw(0.05, 20)));  // it bends by 5.7 degrees
    QVERIFY(!isJagged(saw(0.5, 4)) && !isJagged(saw(0.5, 1)) && !isJagged(SurfaceTrack()));
    const auto circle = [&](int sides) {
      return through(sides + 1, [=](int i) {
        return Vec3(std::cos(2.0 * kPi * i / sides), std::sin(2.0 * kPi * i / sides), 0.0);
      });
    };
    QVERIFY(!isJagged(circle(6)) && !isJagged(circle(60)));
    QVERIFY(!isJagged(through(6, [](int i) { return Vec3((i + 1) / 2, i / 2, 0.0); })));  // steps of a stair
    const Vec3 nowhere = Vec3::Constant(std::nan(""));
    QVERIFY(!isJagged(through(20, [&](int) { return nowhere; })));
    QVERIFY(!isJagged(through(20, [](int) { return Vec3(Vec3::Zero()); })));
  }

  void sharpnessAndCornersAreSettings() {
    const TriangleSoup twelve = rod(12);  // its sides meet at 30°
    QVERIFY(PartSurface(twelve, {.sharpness = 0.6}).edgeNear({30.0, 0.0, 0.0}, 5.0).points.empty());
    const SurfaceTrack side = PartSurface(twelve, {.sharpness = 0.5}).edgeNear({30.0, 0.0, 0.0}, 5.0);
    QCOMPARE(side.length(), 80.0);
    QVERIFY(PartSurface(kBlock, {.corner = 1.6}).edgeNear({10.0, 30.0, 20.0}, 5.0).length() > 100.0);
  }

  // Around a box, through its sides: 2 (100 + 60) mm; normals are those of the faces.
  void aSectionOfABox() {
    const SurfaceTrack track = PartSurface(kBlock).sectionNear({0.0, 0.0, 5.0}, Vec3::UnitZ(), {0.0, 40.0, 5.0});
    QVERIFY(track.isClosed && areOriented(track));
    QVERIFY(std::abs(track.length() - 320.0) < 1e-9);
    for (const TrackPoint& point : track.points) QVERIFY(std::abs(point.position.z() - 5.0) < 1e-12);
    const SurfaceTrack corners = simplified(track, 0.01, 10.0);
    QCOMPARE(corners.points.size(), std::size_t{5});
  }

  // Through vertices, edges and faces: the plane counts as just below.
  void sectionsThroughVertices() {
    const PartSurface box(kBlock);
    for (const double z : {-20.0, 0.0, 20.0}) {
      const SurfaceTrack track = box.sectionNear({0.0, 0.0, z}, Vec3::UnitZ(), {0.0, 40.0, z});
      if (z == -20.0) continue;  // all of it is above: nothing, or its rim
      QVERIFY(std::abs(track.length() - 320.0) < 1e-9);
    }
    QVERIFY(box.sectionNear({0.0, 0.0, 30.0}, Vec3::UnitZ(), Vec3::Zero()).points.empty());
  }

  // The nearest of several curves is returned.
  void twoParts() {
    TriangleSoup two = kBlock;
    for (const Triangle& t : kBlock.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    for (std::size_t i = 0; i < 8; ++i) two.points.push_back(kBlock.points[i] + Vec3(500.0, 0.0, 0.0));
    const PartSurface both(two);
    QVERIFY(both.sectionNear({0, 0, 0}, Vec3::UnitZ(), {490.0, 0.0, 0.0}).points.front().position.x() > 400.0);
    QVERIFY(both.sectionNear({0, 0, 0}, Vec3::UnitZ(), {10.0, 0.0, 0.0}).points.front().position.x() < 100.0);
    QVERIFY(both.edgeNear({250.0, 400.0, 0.0}, 10.0).points.empty());
  }

  // A piece has its length, begins next to the position, and of a closed curve goes round at most once.
  void piecesOfCurves() {
    const SurfaceTrack around = PartSurface(kBlock).sectionNear({0.0, 0.0, 5.0}, Vec3::UnitZ(), {0.0, 40.0, 5.0});
    const Vec3 begin(10.0, 30.0, 5.0);
    for (const double length : {1.0, 30.0, 90.0, 250.0, 319.0}) {
      for (const SurfaceTrack& track : {around, around.reversed()}) {
        const SurfaceTrack piece = pieceFrom(track, begin + Vec3(0.0, 7.0, 0.0), length);
        QVERIFY(std::abs(piece.length() - length) < 1e-9);
        QVERIFY((piece.points.front().position - begin).norm() < 1e-9 && !piece.isClosed && areOriented(piece));
      }
    }
    for (const double length : {321.0, 1e300}) {
      const SurfaceTrack whole = pieceFrom(around, begin, length);
      QVERIFY(whole.isClosed && std::abs(whole.length() - 320.0) < 1e-9);
      QVERIFY((whole.points.back().position - begin).norm() < 1e-9);
    }
    const SurfaceTrack edge = PartSurface(kBlock).edgeNear({10.0, 30.0, 20.0}, 5.0);
    const double rest = (edge.points.back().position - Vec3(10.0, 30.0, 20.0)).norm();
    QVERIFY(std::abs(pieceFrom(edge, {10.0, 30.0, 20.0}, 1e9).length() - rest) < 1e-9);
    QVERIFY(pieceFrom(edge, edge.points.back().position, 10.0).points.empty());
    QVERIFY(pieceFrom({}, begin, 10.0).points.empty() && pieceFrom(edge, begin, 0.0).points.empty());
  }

  // A plane through a convex body cuts it along one curve, which is as long as its sections of all triangles.
  void sectionsMissNoTriangle() {
    QVERIFY(rc::check("all of the curve", [] {
      const TriangleSoup soup = anyEllipsoid(*rc::gen::inRange(3, 20), *rc::gen::inRange(4, 30));
      const PartSurface surface(soup);
      const Vec3 normal = (anyPosition(1.0) + Vec3(1e-3, 0, 0)).normalized();
      const Vec3 &a = soup.points.front(), &b = soup.points.back();
      const Vec3 on = a + evenly(0.1, 0.9) * (b - a);
      double length = 0.0;
      for (std::size_t i = 0; i < soup.triangles.size(); ++i)
        length += cutLength(cornersOf(soup, i, Pose::Identity()), on, normal);
      const SurfaceTrack track = surface.sectionNear(on, normal, on);
      RC_ASSERT(track.isClosed);
      RC_ASSERT(std::abs(track.length() - length) < 1e-6 * length);
    }));
  }

  // No triangle is nearer.
  void nearestPoints() {
    QVERIFY(rc::check("as of all triangles", [] {
      const TriangleSoup soup = anyEllipsoid(*rc::gen::inRange(3, 12), *rc::gen::inRange(4, 16));
      const PartSurface surface(soup);
      for (int i = 0; i < 10; ++i) {
        const Vec3 position = soup.points[*rc::gen::inRange<std::size_t>(0, soup.points.size())] + anyPosition(50.0);
        const double expected = distanceFromSurface(position, soup, Pose::Identity());
        const TrackPoint found = surface.pointNear(position);
        RC_ASSERT(std::abs((found.position - position).norm() - expected) < 1e-6);
        RC_ASSERT(std::abs(found.normal.norm() - 1.0) < 1e-9);
      }
    }));
  }

  void extremes() {
    QVERIFY(!PartSurface({}).hasEdges());
    QVERIFY(PartSurface({}).pointNear(Vec3::Zero()).normal.isZero());
    QVERIFY(PartSurface({}).edgeNear(Vec3::Zero(), kAnywhere).points.empty());
    TriangleSoup broken = kBlock;
    broken.points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
    broken.triangles.push_back({0, 1, static_cast<std::uint32_t>(broken.points.size() - 1)});
    broken.triangles.push_back({0, 0, 1});
    QCOMPARE(PartSurface(broken).edgeNear({10.0, 30.0, 20.0}, kAnywhere).length(), 100.0);
    for (const double scale : {1e-6, 1e6}) {
      TriangleSoup scaled = kBlock;
      for (Vec3& p : scaled.points) p *= scale;
      const SurfaceTrack track = PartSurface(scaled).edgeNear(scale * Vec3(10.0, 30.0, 20.0), kAnywhere);
      QVERIFY(std::abs(track.length() / scale - 100.0) < 1e-9 && areOriented(track));
    }
    QVERIFY(simplified({}, 0.1, 0.1).points.empty());
  }
};

HANDWHEEL_TEST(PartSurfaceTest)
#include "PartSurfaceTest.moc"
