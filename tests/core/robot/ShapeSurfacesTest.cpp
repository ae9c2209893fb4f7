// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/ShapeSurfaces.h"

#include "MeshChecks.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

double volumeOf(const TriangleSoup& soup) {
  double six = 0.0;
  for (const Triangle& t : soup.triangles) six += soup.points[t[0]].dot(soup.points[t[1]].cross(soup.points[t[2]]));
  return six / 6.0;
}

Box boxOf(const TriangleSoup& soup) {
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  return box;
}

}  // namespace

class ShapeSurfacesTest : public QObject {
  Q_OBJECT

 private slots:
  void boxes();
  void cylinders();
  void spheres();
  void anyNumberOfSides();
  void meshes();
};

void ShapeSurfacesTest::boxes() {
  const TriangleSoup soup = surfaceOf(BoxShape{{10, 20, 30}});
  QVERIFY(countEdges(soup).sound());
  QCOMPARE(soup.triangles.size(), std::size_t{12});
  QVERIFY(std::abs(volumeOf(soup) - 6000) < 1e-9);
  QVERIFY(boxOf(soup).min() == Vec3(-5, -10, -15) && boxOf(soup).max() == Vec3(5, 10, 15));
}

void ShapeSurfacesTest::cylinders() {
  const TriangleSoup soup = surfaceOf(CylinderShape{10, 50});
  QVERIFY(countEdges(soup).sound());
  QCOMPARE(eulerCharacteristic(soup), 2L);
  // A prism over a regular polygon with 48 corners.
  const double area = 0.5 * 48 * 100 * std::sin(2 * std::numbers::pi / 48);
  QVERIFY(std::abs(volumeOf(soup) - area * 50) < 1e-6);
  QVERIFY(boxOf(soup).isApprox(Box(Vec3(-10, -10, -25), Vec3(10, 10, 25)), 1e-12));
}

void ShapeSurfacesTest::spheres() {
  const TriangleSoup soup = surfaceOf(SphereShape{10});
  QVERIFY(countEdges(soup).sound());
  QCOMPARE(eulerCharacteristic(soup), 2L);
  for (const Vec3& p : soup.points) QVERIFY(std::abs(p.norm() - 10) < 1e-12);
  const double ball = 4.0 / 3.0 * std::numbers::pi * 1000;
  QVERIFY(volumeOf(soup) < ball && volumeOf(soup) > 0.99 * ball);
  double furthestIn = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Vec3 middle = (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3;
    furthestIn = std::max(furthestIn, 10 - middle.norm());
  }
  QVERIFY(furthestIn < 0.05);  // 0.5 %
}

void ShapeSurfacesTest::anyNumberOfSides() {
  for (std::uint32_t n : {kLeastShapeSides, 5u, 13u, 128u}) {
    const TriangleSoup cylinder = surfaceOf(CylinderShape{10, 50}, n), ball = surfaceOf(SphereShape{10}, n);
    for (const TriangleSoup& soup : {cylinder, ball}) {
      QVERIFY(countEdges(soup).sound());
      QCOMPARE(eulerCharacteristic(soup), 2L);
      QVERIFY(volumeOf(soup) > 0.0);
    }
    const double area = 0.5 * n * 100 * std::sin(2 * std::numbers::pi / n);
    QVERIFY(std::abs(volumeOf(cylinder) - area * 50) < 1e-6);
    for (const Vec3& p : ball.points) QVERIFY(std::abs(p.norm() - 10) < 1e-12);
  }
}

void ShapeSurfacesTest::meshes() {
  QVERIFY(surfaceOf(MeshShape{"a.stl", Vec3::Ones()}).triangles.empty());
  TriangleSoup soup = surfaceOf(BoxShape{{1, 1, 1}});
  place({"a.stl", {0.0254, 0.0254, 0.0254}}, soup);
  QVERIFY(boxOf(soup).isApprox(Box(Vec3::Constant(-12.7), Vec3::Constant(12.7)), 1e-12));
  // A mirrored mesh still has its faces outwards.
  TriangleSoup mirrored = surfaceOf(BoxShape{{1, 1, 1}});
  place({"a.stl", {1, -1, 2}}, mirrored);
  QVERIFY(std::abs(volumeOf(mirrored) - 2e9) < 1);
}

HANDWHEEL_TEST(ShapeSurfacesTest)
#include "ShapeSurfacesTest.moc"
