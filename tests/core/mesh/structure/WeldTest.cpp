// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/Weld.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class WeldTest : public QObject {
  Q_OBJECT

 private slots:
  void zeroHasNoSign();
  void neighboursInTheLastPlaceStayApart();
  void numbersInOrderOfAppearance();
  void unusedPointsGo();
  void classesOfRandomPoints();
  void undoesUnsharing();
  void roundsPoints();
};

void WeldTest::zeroHasNoSign() {
  const std::vector<Vec3> points = {Vec3(0.0, 1, -0.0), Vec3(-0.0, 1, 0.0), Vec3(0, -1, 0)};
  const PointClasses classes = classifyPoints(points);
  QCOMPARE(classes.classOf, std::vector<std::uint32_t>({0, 0, 1}));
  QCOMPARE(classes.representative, std::vector<std::uint32_t>({0, 2}));
}

void WeldTest::neighboursInTheLastPlaceStayApart() {
  for (double x : {0.0, 1.0, 1e-300, 1e6, -123.456}) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Vec3> points(3, Vec3(x, x, x));
      points[1][axis] = std::nextafter(x, 1e308);
      const PointClasses classes = classifyPoints(points);
      QCOMPARE(classes.classOf, std::vector<std::uint32_t>({0, 1, 0}));
    }
  }
}

void WeldTest::numbersInOrderOfAppearance() {
  TriangleSoup soup;
  soup.points = {Vec3(9, 9, 9), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 4)};
  soup.triangles = {{4, 3, 2}, {1, 5, 4}};
  const TriangleSoup welded = weld(soup);
  QVERIFY(welded.triangles == std::vector<Triangle>({{0, 1, 2}, {1, 3, 0}}));
  QVERIFY(welded.points == std::vector<Vec3>({Vec3(0, 3, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, 4)}));
}

void WeldTest::unusedPointsGo() {
  TriangleSoup soup = test::cube();
  soup.points.insert(soup.points.end(), 5, Vec3(7, 7, 7));
  QCOMPARE(weld(soup).points.size(), std::size_t{8});
  QVERIFY(weld({{Vec3(1, 2, 3)}, {}}).points.empty());
}

void WeldTest::classesOfRandomPoints() {
  QVERIFY(rc::check("equal class exactly when equal position; numbered in order", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto steps = *rc::gen::inRange<std::uint32_t>(1, 8);
    std::vector<Vec3> points(*rc::gen::inRange<std::size_t>(0, 200));
    for (Vec3& p : points) p = Vec3(random() % steps, random() % steps, random() % 2 ? 0.0 : -0.0);
    const PointClasses classes = classifyPoints(points);
    std::map<test::Coordinates, std::uint32_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [at, isNew] =
          expected.try_emplace(test::coordinates(points[i]), static_cast<std::uint32_t>(expected.size()));
      RC_ASSERT(classes.classOf[i] == at->second);
      if (isNew) RC_ASSERT(classes.representative.at(at->second) == i);
    }
    RC_ASSERT(classes.representative.size() == expected.size());
  }));
}

void WeldTest::undoesUnsharing() {
  for (const TriangleSoup& s : {test::cube(), test::icosphere(3), test::kleinBottle(12, 6)}) {
    const TriangleSoup welded = weld(test::unshared(s));
    QCOMPARE(welded.points.size(), s.points.size());
    for (std::size_t i = 0; i < s.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k)
        QVERIFY(test::sameBits(welded.points[welded.triangles[i][k]], s.points[s.triangles[i][k]]));
  }
}

void WeldTest::roundsPoints() {
  TriangleSoup soup = test::icosphere(1);
  const TriangleSoup before = soup;
  roundPoints(soup, NumberType::Float64);
  for (std::size_t i = 0; i < soup.points.size(); ++i) QVERIFY(soup.points[i] == before.points[i]);
  roundPoints(soup, NumberType::Float32);
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    for (int k = 0; k < 3; ++k) QVERIFY(std::abs(soup.points[i][k] - before.points[i][k]) <= std::ldexp(1.0, -25));
}

HANDWHEEL_TEST(WeldTest)
#include "WeldTest.moc"
