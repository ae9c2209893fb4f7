// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/ScanlineCrossings.h"

#include "../SolidAngles.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "proximity/ClosestPoint.h"
#include "volume/repair/BoundaryCaps.h"

#include <rapidcheck.h>

#include <QtTest>
#include <map>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Any triangles on few points: open, turned, non-manifold, through each other; on voxel centres, or not.
TriangleSoup anySoup() {
  TriangleSoup soup;
  const bool isOnCentres = *rc::gen::arbitrary<bool>();
  const int points = *rc::gen::inRange(4, 9), triangles = *rc::gen::inRange(1, 12);
  const auto coordinate = [&] {
    const int i = *rc::gen::inRange(0, 1000);
    return isOnCentres ? i % 9 : i * 0.009;
  };
  for (int i = 0; i < points; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    soup.points.push_back(Vec3(x, y, z));
  }
  for (int i = 0; i < triangles; ++i) {
    const auto any = [&] { return static_cast<std::uint32_t>(*rc::gen::inRange(0, points)); };
    const std::uint32_t a = any(), b = any(), c = any();
    soup.triangles.push_back({a, b, c});
  }
  return soup;
}

bool isOn(const TriangleSoup& soup, const Vec3& p) {
  return std::any_of(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
    const Vec3& a = soup.points[t[0]];
    return (closestOnTriangle(p, a, soup.points[t[1]], soup.points[t[2]]) - p).norm() < 1e-6;
  });
}

}  // namespace

class ScanlineCrossingsTest : public QObject {
  Q_OBJECT

 private slots:
  // With cones on the boundaries of any triangles, each edge occurs equally often in both directions.
  void boundariesAreClosed() {
    QVERIFY(rc::check([] {
      TriangleSoup soup = anySoup();
      const std::size_t triangles = soup.triangles.size();
      closeBoundaries(soup, 1e9);
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> passed;
      for (const Triangle& t : soup.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t a = t[k], b = t[(k + 1) % 3];
          if (a != b) passed[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
      for (const auto& [edge, times] : passed) RC_ASSERT(times == 0);
      RC_ASSERT(soup.triangles.size() >= triangles);
    }));
    TriangleSoup whole = icosphere(2);
    const std::size_t triangles = whole.triangles.size();
    QCOMPARE(closeBoundaries(whole, 1e9).boundaries, std::size_t{0});
    QCOMPARE(whole.triangles.size(), triangles);
    whole.triangles.pop_back();
    QCOMPARE(closeBoundaries(whole, 1e9).boundaries, std::size_t{1});
  }

  // The number of turns is that of the solid angles, and 0 outside.
  void turnsAreSolidAngles() {
    QVERIFY(rc::check([] {
      TriangleSoup soup = anySoup();
      closeBoundaries(soup, 1e9);
      const ScanlineCrossings rows(soup);
      for (int i = 0; i < 9 * 9 * 9; ++i) {
        const VoxelIndex at(i % 9, i / 9 % 9, i / 81);
        const Vec3 p = at.cast<double>();
        if (isOn(soup, p)) continue;
        const double turns = windingNumber(soup, p);
        RC_ASSERT(std::abs(turns - std::round(turns)) < 1e-6);
        RC_ASSERT(rows.winding(at) == static_cast<int>(std::round(turns)));
      }
      for (int i = 0; i < 100; ++i) {
        RC_ASSERT(rows.winding(VoxelIndex(-1, i % 10, i / 10)) == 0);
        RC_ASSERT(rows.winding(VoxelIndex(10, i % 10, i / 10)) == 0);
      }
    }));
  }

  // Some of the rows are crossed as they are among all; of the others nothing is known.
  void someRows() {
    QVERIFY(rc::check([] {
      TriangleSoup soup = anySoup();
      closeBoundaries(soup, 1e9);
      const Eigen::AlignedBox2i within(Eigen::Vector2i(2, 3), Eigen::Vector2i(5, 7));
      const ScanlineCrossings all(soup), some(soup, {}, within);
      for (int i = 0; i < 12 * 12; ++i) {
        const int y = i % 12 - 1, z = i / 12 - 1;
        const auto row = some.row(y, z), expected = all.row(y, z);
        if (!within.contains(Eigen::Vector2i(y, z))) {
          RC_ASSERT(row.empty());
          continue;
        }
        RC_ASSERT(row.size() == expected.size());
        for (std::size_t k = 0; k < row.size(); ++k)
          RC_ASSERT(row[k].x == expected[k].x && row[k].step == expected[k].step &&
                    row[k].triangle == expected[k].triangle);
        for (int x = -1; x < 11; ++x) RC_ASSERT(some.winding({x, y, z}) == all.winding({x, y, z}));
      }
    }));
  }

  // A ball within a ball bounds nothing; ball and ball beside each other do.
  void whatBounds() {
    TriangleSoup balls = moved(icosphere(2), Vec3(0.1, 0.2, 0.3), 20.0);
    const std::size_t outer = balls.triangles.size();
    append(balls, moved(icosphere(2), Vec3(0.1, 0.2, 0.3), 8.0));
    append(balls, moved(icosphere(2), Vec3(50.1, 0.2, 0.3), 8.0));
    const ScanlineCrossings rows(balls);
    QVERIFY(!rows.isSimple());
    const ScanlineCrossings::Bounding found = rows.boundingBy([](const Vec3&, int whole) { return whole; });
    // Flat faces lie up to a thirtieth of the radius within.
    for (const auto& [point, triangle] : found.points)
      QVERIFY(std::min(std::abs((point - Vec3(0.1, 0.2, 0.3)).norm() - 19.7),
                       std::abs((point - Vec3(50.1, 0.2, 0.3)).norm() - 7.88)) < 0.4);
    QVERIFY(!found.points.empty());
    for (std::size_t i = 0; i < balls.triangles.size(); ++i) {
      const bool isWithin = i >= outer && i < outer + (balls.triangles.size() - outer) / 2;
      if (rows.crossed()[i]) QCOMPARE(static_cast<bool>(found.triangles[i]), !isWithin);
    }
    QCOMPARE(rows.winding(VoxelIndex(0, 0, 0)), 2);
    QCOMPARE(rows.winding(VoxelIndex(15, 0, 0)), 1);
    QCOMPARE(rows.winding(VoxelIndex(50, 0, 0)), 1);
  }
};

HANDWHEEL_TEST(ScanlineCrossingsTest)
#include "ScanlineCrossingsTest.moc"
