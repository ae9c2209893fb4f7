// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/Cleaning.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

std::size_t degenerateFaces(const HalfEdgeMesh& mesh) {
  std::size_t n = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) n += mesh.isLive(f) && isDegenerate(mesh.points(f));
  return n;
}

struct Case {
  const char* name;
  TriangleSoup soup;
};

// Closed shapes with needles; all coordinates are exact, so that the needles have no area at all.
std::vector<Case> needled() {
  std::vector<Case> cases;
  TriangleSoup one = test::cube();
  test::addNeedles(one, 4, 0, {0.5});
  cases.push_back({"one needle at an edge", one});
  TriangleSoup diagonal = test::cube();
  test::addNeedles(diagonal, 0, 2, {0.25});
  cases.push_back({"one needle inside a side", diagonal});
  TriangleSoup row = test::cube();
  test::addNeedles(row, 4, 0, {0.25, 0.5, 0.75});
  cases.push_back({"needles upon needles", row});
  TriangleSoup many = test::cube();
  // Edges that differ: two needles at one edge would lie in one another.
  for (const auto& [face, corner] : {std::pair{0, 0}, {3, 1}, {6, 0}, {9, 0}})
    test::addNeedles(many, face, corner, {0.5});
  cases.push_back({"needles in several places", many});
  return cases;
}

}  // namespace

class CleaningTest : public QObject {
  Q_OBJECT

 private slots:
  void bookOfLeavesStays();
  void needlesOfClosedShapes();
  void randomNeedles();
  void needleAtTheBorder();
  void facesWithoutExtent();
  void nothingToClean();
  void flaps();
  void debrisGoes();
};

// Taking away what has no area changes neither volume nor area, and opens nothing.
void CleaningTest::needlesOfClosedShapes() {
  for (const Case& c : needled()) {
    QVERIFY2(test::countEdges(c.soup).sound(), c.name);
    HalfEdgeMesh mesh = buildMesh(c.soup).mesh;
    const std::size_t needles = degenerateFaces(mesh);
    QVERIFY2(needles > 0, c.name);
    QCOMPARE(removeDegenerateFaces(mesh), needles);
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(degenerateFaces(mesh), std::size_t{0});
    const TriangleSoup left = mesh.compact().soup;
    QVERIFY2(test::countEdges(left).sound(), c.name);
    QCOMPARE(test::countBorder(mesh), std::size_t{0});
    QVERIFY2(std::abs(test::volume(left) - 1.0) < 1e-12, c.name);
    QVERIFY2(std::abs(test::area(left) - 6.0) < 1e-12, c.name);
    QCOMPARE(findSelfIntersections(mesh)->size(), std::size_t{0});
  }
}

// Needles at random, also at edges of needles and of triangles that others share; the coordinates stay exact.
void CleaningTest::randomNeedles() {
  int single = 0;
  QVERIFY(rc::check("needles at any edges of a closed shape", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    TriangleSoup soup = test::cube(1024.0);
    const int needles = *rc::gen::inRange(1, 8);
    for (int n = needles; n > 0; --n)
      test::addNeedles(soup, random() % soup.triangles.size(), int(random() % 3), {0.25 * (1 + random() % 3)});
    RC_PRE(test::countEdges(soup).sound());  // two points may have come to lie in one another
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    RC_ASSERT(removeDegenerateFaces(mesh) == degenerateFaces(buildMesh(soup).mesh));
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(degenerateFaces(mesh) == std::size_t{0});
    const TriangleSoup left = mesh.compact().soup;
    RC_ASSERT(std::abs(test::volume(left) - std::ldexp(1.0, 30)) < 1.0);
    RC_CLASSIFY(test::countEdges(left).sound(), "closed");
    if (needles > 1) return;
    ++single;
    RC_ASSERT(test::countEdges(left).sound());  // one can always be flipped away
  }));
  QVERIFY(single > 0);  // one in seven
}

void CleaningTest::needleAtTheBorder() {
  TriangleSoup s;
  s.points = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(1, 0, 0)};
  s.triangles = {{0, 3, 2}, {3, 1, 2}, {0, 1, 3}};  // the last has no area and a long edge that nobody shares
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  QCOMPARE(removeDegenerateFaces(mesh), std::size_t{1});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{2});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(std::abs(test::area(mesh.compact().soup) - 2.0) < 1e-12);
}

void CleaningTest::facesWithoutExtent() {
  TriangleSoup s = test::icosphere(1);
  s.triangles.push_back({3, 3, 4});
  s.triangles.push_back({5, 5, 5});
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  QCOMPARE(removeDegenerateFaces(mesh), std::size_t{2});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{80});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
}

void CleaningTest::nothingToClean() {
  for (const TriangleSoup& s : {test::cube(), test::torus(8, 6), test::disc(8, 3), test::boxWithInnerWall()}) {
    const HalfEdgeMesh before = buildMesh(s).mesh;
    HalfEdgeMesh mesh = before;
    QCOMPARE(removeDegenerateFaces(mesh) + removeFlaps(mesh), std::size_t{0});
    QVERIFY(test::sameMesh(mesh, before));
  }
}

// A small face that hangs on an edge of the closed surface goes; one on the border of a sheet, or a large one, stays.
void CleaningTest::flaps() {
  const auto withFlap = [](TriangleSoup s, double height) {
    const Triangle t = s.triangles[17];
    const auto tip = static_cast<std::uint32_t>(s.points.size());
    s.points.push_back((1.0 + height) * s.points[t[0]]);
    s.triangles.push_back({t[0], t[1], tip});
    return s;
  };
  const TriangleSoup fine = test::icosphere(6);  // edges of 0.02, so about 0.005 of the diagonal
  HalfEdgeMesh mesh = buildMesh(withFlap(fine, 0.01)).mesh;
  QCOMPARE(removeFlaps(mesh), std::size_t{1});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(mesh.liveFaceCount(), fine.triangles.size());

  HalfEdgeMesh large = buildMesh(withFlap(fine, 0.5)).mesh;
  QCOMPARE(removeFlaps(large), std::size_t{0});
  HalfEdgeMesh sheet = buildMesh(test::disc(200, 100)).mesh;
  QCOMPARE(removeFlaps(sheet), std::size_t{0});
}

void CleaningTest::debrisGoes() {
  TriangleSoup s = test::icosphere(4);  // 5120 faces, area about 4π
  test::append(s, test::moved(test::tetrahedron(), Vec3(3, 0, 0), 0.05));
  test::append(s, test::moved(test::icosphere(2), Vec3(-3, 0, 0), 0.05));  // small, but of 320 faces: a detail
  test::append(s, test::moved(test::cube(), Vec3(0, 5, 0)));               // few faces, but large: a part
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  QCOMPARE(removeDebris(mesh), std::size_t{4});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{5120 + 320 + 12});
  QCOMPARE(validate(mesh), std::string());
}

// Three small triangles at one edge hang on nothing but each other: a part, however small, that only the removal of
// debris may take.
void CleaningTest::bookOfLeavesStays() {
  TriangleSoup soup = test::icosphere(2);
  const TriangleSoup book{{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0)},
                          {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  test::append(soup, test::moved(book, Vec3(1, 1, 1), 0.001));
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(removeFlaps(mesh), std::size_t{0});
  QCOMPARE(mesh.liveFaceCount(), soup.triangles.size());
}

HANDWHEEL_TEST(CleaningTest)
#include "CleaningTest.moc"
