// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/IslandJoining.h"

#include "MeshShapes.h"
#include "RepairChecks.h"
#include "TestClass.h"
#include "mesh/boundary/Islands.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

namespace {

// A ball of radius 1 without the faces for which isRemoved(centre) is true. `turned` faces look inwards.
template <class IsRemoved, class IsTurned>
TriangleSoup ball(IsRemoved isRemoved, IsTurned isTurned, int levels = 4) {
  TriangleSoup s = test::icosphere(levels);
  std::vector<Triangle> kept;
  for (Triangle t : s.triangles) {
    const Vec3 centre = (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]) / 3.0;
    if (isRemoved(centre)) continue;
    if (isTurned(centre)) std::swap(t[1], t[2]);
    kept.push_back(t);
  }
  s.triangles = kept;
  return s;
}

bool isRing(const Vec3& centre, const Vec3& around, double inner, double outer) {
  const double d = (centre.normalized() - around.normalized()).norm();
  return d > inner && d < outer;
}

// A box of this depth below z = 1 with a top of n × n cells, without the faces for which isRemoved(centre) is true.
template <class IsRemoved>
TriangleSoup boxWithTop(std::uint32_t n, double depth, IsRemoved isRemoved) {
  TriangleSoup s =
      test::grid(n + 1, n + 1, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 1); });
  const auto centre = [](const TriangleSoup& of, const Triangle& t) {
    return Vec3((of.points[t[0]] + of.points[t[1]] + of.points[t[2]]) / 3.0);
  };
  std::erase_if(s.triangles, [&](const Triangle& t) { return isRemoved(centre(s, t)); });
  TriangleSoup rest = test::box({0, 0, 1.0 - depth}, {double(n), double(n), depth});
  std::erase_if(rest.triangles, [&](const Triangle& t) { return centre(rest, t).z() == 1.0; });
  test::append(s, rest);
  return s;
}

const Vec3 kSide(0.3, 0.5, 0.8);

}  // namespace

class IslandJoiningTest : public QObject {
  Q_OBJECT

 private slots:
  void oneIsland_data();
  void oneIsland();
  void severalIslands();
  void islandWithAHole();
  void keptOpen();
  void flatPlateWithAnIsland();
  void manyIslands();
  void flatIslandKeptOpen();
};

void IslandJoiningTest::oneIsland_data() {
  QTest::addColumn<double>("inner");
  QTest::addColumn<double>("outer");
  QTest::addColumn<bool>("isTurned");
  QTest::newRow("medium") << 0.3 << 0.6 << false;
  QTest::newRow("small in large") << 0.12 << 0.7 << false;
  QTest::newRow("narrow ring") << 0.4 << 0.52 << false;
  QTest::newRow("faces inwards") << 0.3 << 0.6 << true;
}

// A patch around the island continues a ball of volume 4π/3, whose faces enclose somewhat less.
void IslandJoiningTest::oneIsland() {
  QFETCH(double, inner);
  QFETCH(double, outer);
  QFETCH(bool, isTurned);
  const TriangleSoup soup =
      ball([&](const Vec3& c) { return isRing(c, kSide, inner, outer); },
           [&](const Vec3& c) { return isTurned && (c.normalized() - kSide.normalized()).norm() <= inner; });
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::size_t faces = mesh.liveFaceCount();
  const RepairReport report = repair(mesh, {});
  QVERIFY(report.openLoops.empty());
  QCOMPARE(test::count(report, LoopOutcome::Filled), std::size_t{2});
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(test::pieces(mesh).size(), std::size_t{1});
  QCOMPARE(test::intersections(mesh), std::size_t{0});
  QVERIFY(mesh.liveFaceCount() > faces);
  const double whole = test::volume(test::icosphere(4));
  QVERIFY2(std::abs(test::volume(mesh.compact().soup) / whole - 1.0) < 0.01,
           qPrintable(QString::number(test::volume(mesh.compact().soup) / whole)));
}

void IslandJoiningTest::severalIslands() {
  const std::vector<Vec3> at{{0.25, 0.0, 1.0}, {-0.25, 0.1, 1.0}, {0.0, -0.3, 1.0}};
  const TriangleSoup soup = ball(
      [&](const Vec3& c) {
        const bool isIsland =
            std::any_of(at.begin(), at.end(), [&](const Vec3& p) { return isRing(c, p, -1.0, 0.12); });
        return isRing(c, Vec3(0, 0, 1), -1.0, 0.6) && !isIsland;
      },
      [](const Vec3&) { return false; });
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(findBoundaryLoops(mesh).size(), std::size_t{4});
  QVERIFY(repair(mesh, {}).openLoops.empty());
  QCOMPARE(test::pieces(mesh).size(), std::size_t{1});
  QCOMPARE(test::intersections(mesh), std::size_t{0});
}

// The hole in the island is filled on its own.
void IslandJoiningTest::islandWithAHole() {
  const TriangleSoup soup =
      ball([&](const Vec3& c) { return isRing(c, kSide, 0.4, 0.6) || isRing(c, kSide, -1.0, 0.15); },
           [](const Vec3&) { return false; });
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(findBoundaryLoops(mesh).size(), std::size_t{3});
  QVERIFY(repair(mesh, {}).openLoops.empty());
  QCOMPARE(test::pieces(mesh).size(), std::size_t{1});
  QCOMPARE(test::intersections(mesh), std::size_t{0});
}

// A hole or an island that the user keeps open is not joined.
void IslandJoiningTest::keptOpen() {
  const TriangleSoup soup =
      ball([&](const Vec3& c) { return isRing(c, kSide, 0.3, 0.6); }, [](const Vec3&) { return false; });
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  for (const BoundaryLoop& loop : findBoundaryLoops(input)) {
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.keepOpen.insert(loop.id);
    const RepairReport report = repair(mesh, options);
    QCOMPARE(report.lostLoops.size(), std::size_t{0});
    QCOMPARE(test::pieces(mesh).size(), std::size_t{2});
  }
}

// Many islands make the boundary as long as that of a frayed sheet.
void IslandJoiningTest::manyIslands() {
  const double side = 34.0;
  const TriangleSoup soup = boxWithTop(34, side, [&](const Vec3& c) {
    const auto isRim = [&](double x) { return x < 1.0 || x > side - 1.0; };
    const auto isIsland = [](double x) { return std::fmod(x, 4.0) > 2.0; };
    return !isRim(c.x()) && !isRim(c.y()) && !(isIsland(c.x()) && isIsland(c.y()));
  });
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QVERIFY(repair(mesh, {}).openLoops.empty());
  QCOMPARE(test::pieces(mesh).size(), std::size_t{1});
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - side * side * side) < 1e-6);
}

// The top of a plate with a square ring missing: the patch is flat, so that the volume is that of the plate.
void IslandJoiningTest::flatPlateWithAnIsland() {
  const TriangleSoup soup = boxWithTop(12, 1.0, [](const Vec3& c) {
    const double d = (c - Vec3(6, 6, 1)).cwiseAbs().maxCoeff();
    return d > 1.0 && d < 4.0;
  });
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QVERIFY(repair(mesh, {}).openLoops.empty());
  QCOMPARE(test::pieces(mesh).size(), std::size_t{1});
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - 144.0) < 1e-6);
}

// One of two flat islands is to stay open: the hole and both islands stay open, and nothing is removed.
void IslandJoiningTest::flatIslandKeptOpen() {
  const TriangleSoup soup = boxWithTop(12, 12.0, [](const Vec3& c) {
    const bool isIsland = std::abs(c.y() - 6.0) < 1.0 && (std::abs(c.x() - 4.0) < 1.0 || std::abs(c.x() - 8.0) < 1.0);
    return (c - Vec3(6, 6, 1)).cwiseAbs().maxCoeff() < 4.0 && !isIsland;
  });
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  int tried = 0;
  for (const BoundaryLoop& loop : findBoundaryLoops(input)) {
    if (loop.length > 10.0) continue;  // the outline of an island has 8 mm
    ++tried;
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.keepOpen.insert(loop.id);
    const RepairReport report = repair(mesh, options);
    QVERIFY(report.lostLoops.empty());
    QCOMPARE(report.openLoops.size(), std::size_t{3});
    QVERIFY(mesh.liveFaceCount() >= input.liveFaceCount());  // T-junctions at the rim of the top divide faces
  }
  QCOMPARE(tried, 2);
}

HANDWHEEL_TEST(IslandJoiningTest)
#include "IslandJoiningTest.moc"
