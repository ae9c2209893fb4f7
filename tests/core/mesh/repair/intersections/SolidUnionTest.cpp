// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SolidUnion.h"

#include "../../SoupsTogether.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/InsideOutShells.h"
#include "mesh/repair/Repair.h"
#include "mesh/repair/intersections/IntersectionClusters.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/Weld.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

using namespace handwheel;

namespace {

TriangleSoup insideOut(TriangleSoup soup) {
  for (Triangle& t : soup.triangles) std::swap(t[0], t[1]);
  return soup;
}

// Returns the number of unit grid cells in the boxes, which have integer corners.
double cellsIn(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all.extend(box);
  double count = 0.0;
  for (double x = all.min().x() + 0.5; x < all.max().x(); ++x) {
    for (double y = all.min().y() + 0.5; y < all.max().y(); ++y) {
      for (double z = all.min().z() + 0.5; z < all.max().z(); ++z)
        count += std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) { return b.contains(Vec3(x, y, z)); });
    }
  }
  return count;
}

const TriangleSoup kTenCube = test::box({0, 0, 0}, {10, 10, 10});

}  // namespace

// Solids that intersect become one, without walls inside.
class SolidUnionTest : public QObject {
  Q_OBJECT

 private slots:
  void twoCubes() {
    const HalfEdgeMesh united = unionOf({kTenCube, test::box({5, 5, 5}, {10, 10, 10})});
    QVERIFY(test::countEdges(united).sound());
    QCOMPARE(test::pieces(united).size(), std::size_t{1});
    QVERIFY(std::abs(test::volume(united.compact().soup) - 1875.0) < 1e-9);
  }

  // Three bars along the axes: what sticks out of the others stays, and there is nothing in the middle.
  void barsAlongTheAxes() {
    const HalfEdgeMesh united = unionOf({test::box({-10, -1, -2}, {20, 2, 4}), test::box({-2, -10, -1}, {4, 20, 2}),
                                         test::box({-1, -2, -10}, {2, 4, 20})});
    QVERIFY(test::countEdges(united).sound());
    QCOMPARE(test::pieces(united).size(), std::size_t{1});
    const std::vector<Box> boxes{
        {Vec3(-10, -1, -2), Vec3(10, 1, 2)}, {Vec3(-2, -10, -1), Vec3(2, 10, 1)}, {Vec3(-1, -2, -10), Vec3(1, 2, 10)}};
    QVERIFY(std::abs(test::volume(united.compact().soup) - cellsIn(boxes)) < 1e-9);
  }

  // The volume of any boxes with integer corners is counted in cells, however their walls meet.
  void anyBoxes() {
    int united = 0;
    QVERIFY(rc::check("the union of boxes holds what they hold", [&] {
      std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
      const auto upTo = [&](int most) { return static_cast<double>(random() % static_cast<unsigned>(most)); };
      std::vector<Box> boxes;
      std::vector<TriangleSoup> parts;
      for (int i = *rc::gen::inRange(2, 6); i > 0; --i) {
        const Vec3 corner(upTo(8), upTo(8), upTo(8)), size(2 + upTo(6), 2 + upTo(6), 2 + upTo(6));
        boxes.emplace_back(corner, corner + size);
        parts.push_back(test::box(corner, size));
      }
      HalfEdgeMesh mesh = buildMesh(test::together(parts)).mesh;
      const std::size_t removed = uniteSolids(mesh, NumberType::Float64);
      RC_ASSERT(validate(mesh) == std::string());
      RC_PRE(removed > 0);
      ++united;
      RC_ASSERT(test::meetingPairs(mesh) == std::size_t{0});
      RC_ASSERT(test::countEdges(mesh).border == std::size_t{0});
      RC_ASSERT(std::abs(test::volume(mesh.compact().soup) - cellsIn(boxes)) < 1e-6);
    }));
    QVERIFY(united > 50);
  }

  // Boxes that share a whole wall, in files with separate and with common corners: the wall goes.
  void sharedWalls() {
    const TriangleSoup left = test::box({0, 0, 0}, {1, 1, 1}), right = test::box({1, 0, 0}, {1, 1, 1});
    for (const TriangleSoup& soup : {test::together({left, right}), weld(test::together({left, right}))}) {
      HalfEdgeMesh mesh = buildMesh(soup).mesh;
      QVERIFY(uniteSolids(mesh, NumberType::Float32) > 0);
      QCOMPARE(validate(mesh), std::string());
      QCOMPARE(mesh.liveFaceCount(), std::size_t{20});
      QCOMPARE(test::pieces(buildMesh(mesh.compact().soup).mesh).size(), std::size_t{1});
      QCOMPARE(test::volume(mesh.compact().soup), 2.0);
    }
  }

  // Boxes on a grid that touch in walls, whole ones and parts, however they are turned and rounded: a repair leaves one
  // body for each connected group, of the sum of their volumes.
  void boxesSideBySide() {
    QVERIFY(rc::check("boxes that share walls become one body", [&] {
      std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
      const auto upTo = [&](int most) { return static_cast<double>(random() % static_cast<unsigned>(most)); };
      const bool isTurned = upTo(2) > 0, isFloat = upTo(2) > 0;
      const Eigen::Quaterniond turn = isTurned
                                          ? Eigen::Quaterniond(1.0 + upTo(9), upTo(9), upTo(9), upTo(9)).normalized()
                                          : Eigen::Quaterniond::Identity();
      double volume = 0.0, reach = 0.0;
      std::vector<TriangleSoup> parts;
      for (int i = 2 + static_cast<int>(upTo(4)); i > 0; --i) {  // a row of boxes with a common edge along x
        const Vec3 size(1 + upTo(3), 1 + upTo(3), 1 + upTo(3));
        parts.push_back(test::box(Vec3(reach, 0, 0), size));
        reach += size.x();
        volume += size.prod();
      }
      TriangleSoup soup = test::together(parts);
      const NumberType numbers = isFloat ? NumberType::Float32 : NumberType::Float64;
      for (Vec3& p : soup.points) p = rounded(Vec3(turn * p), numbers);
      HalfEdgeMesh mesh = buildMesh(soup).mesh;
      RepairOptions options;
      options.uniteSolids = true;
      options.fill.numbers = numbers;
      repair(mesh, options);
      RC_ASSERT(validate(mesh) == std::string());
      const HalfEdgeMesh read = buildMesh(mesh.compact().soup).mesh;
      RC_ASSERT(test::countEdges(read).sound());
      RC_ASSERT(test::pieces(read).size() == std::size_t{1});
      RC_ASSERT(std::abs(test::volume(read.compact().soup) - volume) < 1e-4);
    }));
  }

  // Any cells of a grid as separate cubes: their volume is their number, their pieces those that walls connect.
  void cubesOfAGrid() {
    for (std::uint32_t seed = 0; seed < 16; ++seed) {
      std::mt19937 random(seed);
      const auto upTo = [&](int most) { return static_cast<double>(random() % static_cast<unsigned>(most)); };
      const bool isTurned = upTo(2) > 0;
      const Eigen::Quaterniond turn = isTurned
                                          ? Eigen::Quaterniond(1.0 + upTo(9), upTo(9), upTo(9), upTo(9)).normalized()
                                          : Eigen::Quaterniond::Identity();
      std::array<bool, 27> cells{};
      std::vector<TriangleSoup> parts;
      for (int i = 0; i < 27; ++i) {
        cells[i] = upTo(2) > 0;
        if (cells[i]) parts.push_back(test::box(Vec3(i % 3, i / 3 % 3, i / 9), Vec3(1, 1, 1)));
      }
      DisjointSets groups(27);
      for (int i = 0; i < 27; ++i) {
        if (i % 3 < 2 && cells[i] && cells[i + 1]) groups.join(i, i + 1);
        if (i / 3 % 3 < 2 && cells[i] && cells[i + 3]) groups.join(i, i + 3);
        if (i / 9 < 2 && cells[i] && cells[i + 9]) groups.join(i, i + 9);
      }
      std::set<std::uint32_t> bodies;
      for (std::uint32_t i = 0; i < 27; ++i)
        if (cells[i]) bodies.insert(groups.root(i));
      TriangleSoup soup = test::together(parts);
      for (Vec3& p : soup.points) p = rounded(Vec3(turn * p), NumberType::Float32);
      HalfEdgeMesh mesh = buildMesh(soup).mesh;
      RepairOptions options;
      options.uniteSolids = true;
      options.fill.numbers = NumberType::Float32;
      repair(mesh, options);
      QVERIFY(validate(mesh) == std::string());
      const HalfEdgeMesh read = buildMesh(mesh.compact().soup).mesh;
      QVERIFY(test::countEdges(read).sound());
      QVERIFY(std::abs(test::volume(read.compact().soup) - double(parts.size())) < 1e-4);
      QVERIFY(test::pieces(read).size() == bodies.size());
    }
  }

  // A plate of 12 triangles, of which each large one is cut by many pegs: the area of a peg is that of its polygon.
  void manyPegsInAPlate() {
    std::vector<TriangleSoup> parts{test::box({0, 0, 0}, {80, 80, 5})};
    const int n = 24;
    for (int i = 0; i < 16; ++i) {
      parts.push_back(
          test::moved(test::cylinder(n, 1, 4.0, 15.0, true), Vec3(10 + 20 * (i % 4), 10 + 20 * (i / 4), -5)));
    }
    const HalfEdgeMesh united = unionOf(parts);
    QVERIFY(test::countEdges(united).sound());
    QCOMPARE(test::pieces(united).size(), std::size_t{1});
    const double area = 0.5 * n * 16.0 * std::sin(2.0 * std::numbers::pi / n);
    QVERIFY(std::abs(test::volume(united.compact().soup) - (80.0 * 80.0 * 5.0 + 16.0 * 10.0 * area)) < 1e-6);
  }

  // Text files with few decimals: the common wall goes all over, so that the area is that of the outside.
  void decimals() {
    std::mt19937 random(11);
    std::normal_distribution<double> any;
    for (int i = 0; i < 12; ++i) {
      const Eigen::Quaterniond turn =
          Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
      const double step = i % 2 ? 1e-6 : 1e-3;
      TriangleSoup soup = test::together({kTenCube, test::box({10, 2, 3}, {5, 6, 5})});
      for (Vec3& p : soup.points) {
        const Vec3 q = turn * p / step;
        p = Vec3(std::round(q.x()), std::round(q.y()), std::round(q.z())) / (1.0 / step);
      }
      HalfEdgeMesh mesh = buildMesh(soup).mesh;
      RepairOptions options;
      options.uniteSolids = true;
      repair(mesh, options);
      mesh = buildMesh(mesh.compact().soup).mesh;
      double area = 0.0;
      for (Face f = 0; f < mesh.faceSlots(); ++f)
        if (mesh.isLive(f)) area += areaOf(mesh.points(f));
      QVERIFY(test::countEdges(mesh).sound());
      QCOMPARE(test::pieces(mesh).size(), std::size_t{1});
      const double wanted = 600.0 + 2.0 * 5.0 * (6.0 + 5.0);
      QVERIFY2(std::abs(area - wanted) < 200.0 * step, qPrintable(QString::number(area - wanted)));
    }
  }

  // Two balls: the volume of the lens in common is known.
  void twoBalls() {
    const TriangleSoup ball = test::icosphere(5);
    TriangleSoup other = ball;
    const double distance = 1.1234;
    for (Vec3& p : other.points) p += Vec3(0.3, 0.5, 0.81).normalized() * distance;
    const HalfEdgeMesh united = unionOf({ball, other});
    QVERIFY(test::countEdges(united).sound());
    const double lens = std::numbers::pi / 12.0 * (4.0 + distance) * (2.0 - distance) * (2.0 - distance);
    const double wanted = 2.0 * 4.0 / 3.0 * std::numbers::pi - lens;
    QVERIFY(std::abs(test::volume(united.compact().soup) / wanted - 1.0) < 2e-3);
  }

  // In single precision, too, and however it is turned.
  void turned() {
    std::mt19937 random(3);
    std::normal_distribution<double> any;
    for (int i = 0; i < 10; ++i) {
      const Eigen::Quaterniond turn =
          Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
      for (const NumberType numbers : {NumberType::Float32, NumberType::Float64}) {
        TriangleSoup soup = test::together({kTenCube, test::box({5, 4, 3}, {10, 10, 10})});
        for (Vec3& p : soup.points) p = rounded(Vec3(turn * p), numbers);
        HalfEdgeMesh mesh = buildMesh(soup).mesh;
        QVERIFY(uniteSolids(mesh, numbers) > 0);
        QCOMPARE(validate(mesh), std::string());
        QVERIFY(test::countEdges(mesh).sound());
        QVERIFY(std::abs(test::volume(mesh.compact().soup) - (2000.0 - 5.0 * 6.0 * 7.0)) < 1e-2);
      }
    }
  }

  // A cavity is no wall inside the union; nor is it lost where another solid reaches into it.
  void cavitiesStay() {
    const TriangleSoup hollow = test::together({kTenCube, insideOut(test::box({2, 2, 2}, {6, 6, 6}))});
    const HalfEdgeMesh beside = unionOf({hollow, test::box({9, 1, 1}, {5, 5, 5})});
    QVERIFY(std::abs(test::volume(beside.compact().soup) - (1000.0 - 216.0 + 100.0)) < 1e-9);
    const HalfEdgeMesh into = unionOf({hollow, test::box({7, 3, 3}, {5, 1, 1})});
    QVERIFY(std::abs(test::volume(into.compact().soup) - (1000.0 - 216.0 + 1.0 + 2.0)) < 1e-9);
  }

  // Bodies in bodies go, also a cavity that another body fills; what is in a cavity stays.
  void nestedBodies() {
    const TriangleSoup inner = test::box({3, 3, 3}, {4, 4, 4}), innermost = test::box({4, 4, 4}, {1, 1, 1});
    for (const auto& parts : {std::vector{kTenCube, inner}, std::vector{kTenCube, inner, innermost},
                              std::vector{kTenCube, test::box({1, 1, 1}, {8, 8, 8}), insideOut(inner)}}) {
      HalfEdgeMesh mesh = buildMesh(test::together(parts)).mesh;
      QCOMPARE(findNestedBodies(mesh).size(), parts.size() - 1);
      QCOMPARE(findDefects(mesh).nestedBodies, parts.size() - 1);
      QCOMPARE(uniteSolids(mesh, NumberType::Float64), parts.size() - 1);
      QCOMPARE(validate(mesh), std::string());
      QCOMPARE(test::pieces(buildMesh(mesh.compact().soup).mesh).size(), std::size_t{1});
      QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1000.0) < 1e-9);
    }
    // The part that is cut off inside if self-intersections are resolved one by one.
    HalfEdgeMesh cut = buildMesh(test::together({kTenCube, test::box({5, 5, 5}, {10, 10, 10})})).mesh;
    const auto pairs = findSelfIntersections(cut);
    QVERIFY(pairs && removeClusterIntersections(cut, *pairs, NumberType::Float64).clusters == 1);
    QCOMPARE(findNestedBodies(cut).size(), std::size_t{1});
    QCOMPARE(uniteSolids(cut, NumberType::Float64), std::size_t{1});
    QVERIFY(std::abs(test::volume(cut.compact().soup) - 1875.0) < 1e-9);
  }

  void againChangesNothing() {
    HalfEdgeMesh united = unionOf({kTenCube, test::box({5, 5, 5}, {10, 10, 10})});
    QCOMPARE(uniteSolids(united, NumberType::Float64), std::size_t{0});
  }

  void leftAsItIs_data() {
    QTest::addColumn<TriangleSoup>("soup");
    const TriangleSoup other = test::box({5, 5, 5}, {10, 10, 10});
    QTest::newRow("empty") << TriangleSoup();
    QTest::newRow("apart") << test::together({kTenCube, test::box({20, 0, 0}, {1, 1, 1})});
    QTest::newRow("a cavity") << test::together({kTenCube, insideOut(test::box({2, 2, 2}, {1, 1, 1}))});
    QTest::newRow("a body in a cavity") << test::together(
        {kTenCube, insideOut(test::box({2, 2, 2}, {6, 6, 6})), test::box({4, 4, 4}, {1, 1, 1})});
    QTest::newRow("one inside out") << test::together({kTenCube, insideOut(other)});
    TriangleSoup open = other;
    open.triangles.resize(6);
    QTest::newRow("one is open") << test::together({kTenCube, open});
  }
  void leftAsItIs() {
    QFETCH(TriangleSoup, soup);
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const TriangleSoup before = mesh.compact().soup;
    QCOMPARE(uniteSolids(mesh, NumberType::Float64), std::size_t{0});
    QVERIFY(mesh.compact().soup.triangles == before.triangles);
    QVERIFY(mesh.compact().soup.points == before.points);
  }

  void cancelled() {
    HalfEdgeMesh mesh = buildMesh(test::together({kTenCube, test::box({5, 5, 5}, {10, 10, 10})})).mesh;
    JobState state;
    state.cancelled = true;
    QCOMPARE(uniteSolids(mesh, NumberType::Float64, Progress(state)), std::size_t{0});
    QCOMPARE(mesh.liveFaceCount(), std::size_t{24});
  }

 private:
  static HalfEdgeMesh unionOf(const std::vector<TriangleSoup>& parts) {
    HalfEdgeMesh mesh = buildMesh(test::together(parts)).mesh;
    const std::size_t removed = uniteSolids(mesh, NumberType::Float64);
    [&] {
      QVERIFY(removed > 0);
      QCOMPARE(validate(mesh), std::string());
      QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
    }();
    return buildMesh(mesh.compact().soup).mesh;
  }
};

HANDWHEEL_TEST(SolidUnionTest)
#include "SolidUnionTest.moc"
