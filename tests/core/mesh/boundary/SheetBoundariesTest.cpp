// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/SheetBoundaries.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

// The lengths of the loops that are boundaries, and how many are not.
struct Boundaries {
  std::vector<double> lengths;
  std::size_t holes = 0;
};

Boundaries boundariesOf(const TriangleSoup& soup) {
  Boundaries boundaries;
  for (const BoundaryLoop& loop : findBoundaryLoops(buildMesh(soup).mesh)) {
    if (loop.isSheetBoundary)
      boundaries.lengths.push_back(loop.length);
    else
      ++boundaries.holes;
  }
  return boundaries;
}

TriangleSoup tilted(TriangleSoup s) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.9, Vec3::UnitX()) * Eigen::AngleAxisd(0.4, Vec3::UnitZ())).toRotationMatrix();
  for (Vec3& p : s.points) p = turn * p;
  return s;
}

// The part of a sphere above a height.
TriangleSoup cap(double height) {
  TriangleSoup s = test::uvSphere(48, 48);
  std::erase_if(s.triangles, [&](const Triangle& t) {
    return s.points[t[0]].z() + s.points[t[1]].z() + s.points[t[2]].z() < 3.0 * height;
  });
  return s;
}

}  // namespace

class SheetBoundariesTest : public QObject {
  Q_OBJECT

 private slots:
  void flatDisc();
  void annulusOuterOnly();
  void closedShapesWithHoles();
  void platesWithAHole();
  void cylinders();
  void raggedOutline();
  void boxesWithoutALid();
  void flakeAtAVertex();
  void eachPartOnItsOwn();
};

void SheetBoundariesTest::flatDisc() {
  for (double scale : {1e-6, 1.0, 1e6}) {
    for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(1000 * scale, 500 * scale, -2000 * scale)}) {
      const Boundaries boundaries = boundariesOf(test::moved(tilted(test::disc(24, 4)), shift, scale));
      QCOMPARE(boundaries.lengths.size(), std::size_t{1});
      QCOMPARE(boundaries.holes, std::size_t{0});
    }
  }
}

void SheetBoundariesTest::annulusOuterOnly() {
  const Boundaries boundaries = boundariesOf(tilted(test::annulus(24, 4, 1.0, 1.5)));
  QCOMPARE(boundaries.holes, std::size_t{1});
  QCOMPARE(boundaries.lengths.size(), std::size_t{1});
  QVERIFY(std::abs(boundaries.lengths[0] - 24 * 2 * 1.5 * std::sin(M_PI / 24)) < 1e-9);
}

// A part of a sphere that is clearly more than half is a body with a hole; a smaller part has no inside to close.
void SheetBoundariesTest::closedShapesWithHoles() {
  for (double height : {-0.9, -0.3, 0.0, 0.5}) {
    const Boundaries boundaries = boundariesOf(cap(height));
    QCOMPARE(boundaries.lengths.size(), std::size_t(height < 0.0 ? 0 : 1));
    QCOMPARE(boundaries.holes, std::size_t(height < 0.0 ? 1 : 0));
  }
  QCOMPARE(boundariesOf(test::sphereWithHoles(4, 5, 0.3)).holes, std::size_t{5});
  QVERIFY(boundariesOf(test::sphereWithHoles(4, 5, 0.3)).lengths.empty());
}

// A plate, as flat as a sheet, whose only open edge is a small triangle in its lid: no sheet has so short an outline.
void SheetBoundariesTest::platesWithAHole() {
  const TriangleSoup lid =
      test::grid(9, 9, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.01); });
  TriangleSoup plate = lid;
  test::append(plate, test::turnedOver(test::moved(lid, {0, 0, -0.01})));
  const TriangleSoup wall = test::grid(33, 2, false, false, [](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t side = i % 32 / 8, k = i % 8;
    const Vec3 corners[] = {{double(k), 0, 0}, {8, double(k), 0}, {8.0 - k, 8, 0}, {0, 8.0 - k, 0}};
    return Vec3(corners[side] + 0.01 * j * Vec3::UnitZ());
  });
  test::append(plate, wall);
  QVERIFY(boundariesOf(plate).lengths.empty() && boundariesOf(plate).holes == 0);
  plate.triangles.erase(plate.triangles.begin() + 40);
  const Boundaries boundaries = boundariesOf(plate);
  QVERIFY(boundaries.lengths.empty());
  QCOMPARE(boundaries.holes, std::size_t{1});
}

void SheetBoundariesTest::cylinders() {
  for (double height : {0.5, 1.0, 10.0}) {
    const Boundaries boundaries = boundariesOf(test::cylinder(24, 4, 1.0, height, false));
    QVERIFY(boundaries.lengths.empty());
    QCOMPARE(boundaries.holes, std::size_t{2});
  }
}

// A curved sheet whose outline has teeth: the square of its length is far over 60 times its area.
void SheetBoundariesTest::raggedOutline() {
  TriangleSoup s = test::grid(41, 41, false, false, [](std::uint32_t i, std::uint32_t j) {
    const double x = i / 40.0, y = j / 40.0;
    return Vec3(x, y, 0.3 * std::sin(3 * x) * std::cos(2 * y));
  });
  std::erase_if(s.triangles, [&](const Triangle& t) {  // every other line of cells, but for a spine in the middle
    const Vec3 middle = (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]) / 3.0;
    return int(middle.y() * 40) % 2 == 1 && std::abs(middle.x() - 0.5) > 0.1;
  });
  const Boundaries boundaries = boundariesOf(s);
  QCOMPARE(boundaries.lengths.size(), std::size_t{1});
  QVERIFY(boundaries.lengths[0] * boundaries.lengths[0] > 60.0 * test::area(s));
}

// A box without its largest side: a lid over a shallow one would be half as large as the rest of it, over a deep one a
// fifth at most.
void SheetBoundariesTest::boxesWithoutALid() {
  for (const double depth : {0.2, 1.0, 3.0}) {
    TriangleSoup box = test::cube();
    std::erase_if(box.triangles, [&](const Triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return box.points[v].z() > 0.5; });
    });
    for (Vec3& p : box.points) p.z() *= depth;
    const Boundaries boundaries = boundariesOf(box);
    QCOMPARE(boundaries.lengths.size(), std::size_t(1.0 / (1.0 + 4.0 * depth) > tolerance::kSheetAreaVector ? 1 : 0));
    QCOMPARE(boundaries.lengths.size() + boundaries.holes, std::size_t{1});
  }
}

// A flake that touches the border of a ball in one point is a sheet of its own, and its outline no hole of the ball.
void SheetBoundariesTest::flakeAtAVertex() {
  TriangleSoup s = test::sphereWithoutCap(3);
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(buildMesh(s).mesh);
  const Vec3 at = s.points[buildMesh(s).mesh.from(loops.at(0).halfEdges.front())];
  const auto first = static_cast<std::uint32_t>(s.points.size());
  s.points.insert(s.points.end(), {at, at + Vec3(0.1, 0, 1), at + Vec3(0, 0.1, 1)});
  s.triangles.push_back({first, first + 1, first + 2});
  const Boundaries boundaries = boundariesOf(s);
  QCOMPARE(boundaries.holes, std::size_t{1});
  QCOMPARE(boundaries.lengths.size(), std::size_t{1});
}

void SheetBoundariesTest::eachPartOnItsOwn() {
  TriangleSoup s = test::sphereWithHoles(3, 2, 0.4);
  test::append(s, test::moved(test::annulus(24, 3, 1, 2), Vec3(10, 0, 0)));
  const Boundaries boundaries = boundariesOf(s);
  QCOMPARE(boundaries.holes, std::size_t{3});
  QCOMPARE(boundaries.lengths.size(), std::size_t{1});
}

HANDWHEEL_TEST(SheetBoundariesTest)
#include "SheetBoundariesTest.moc"
