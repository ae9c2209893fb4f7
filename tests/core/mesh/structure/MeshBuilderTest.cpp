// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/MeshBuilder.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

// True when face i has the corners of triangle i in the same turn, or the other one where the report says so.
bool everyTriangleIsThere(const TriangleSoup& soup, const BuiltMesh& built) {
  if (built.mesh.faceSlots() != soup.triangles.size()) return false;
  const std::set<Face> turned(built.report.reversedFaces.begin(), built.report.reversedFaces.end());
  for (Face f = 0; f < built.mesh.faceSlots(); ++f) {
    if (!built.mesh.isLive(f)) return false;
    std::array<test::Coordinates, 3> wanted, is;
    for (std::size_t k = 0; k < 3; ++k) {
      wanted[k] = test::coordinates(soup.points[soup.triangles[f][k]]);
      is[k] = test::coordinates(built.mesh.points(f)[k]);
    }
    if (turned.contains(f)) std::swap(wanted[1], wanted[2]);
    bool found = false;
    for (int k = 0; k < 3 && !found; ++k) {
      found = wanted == is;
      std::rotate(wanted.begin(), wanted.begin() + 1, wanted.end());
    }
    if (!found) return false;
  }
  return true;
}

}  // namespace

class MeshBuilderTest : public QObject {
  Q_OBJECT

 private slots:
  void manifolds_data();
  void manifolds();
  void nonOrientable_data();
  void nonOrientable();
  void touchingCubes();
  void threeFacesAtAnEdge();
  void manySolidsAtOneEdge();
  void facesWithoutExtent();
  void emptyAndSingle();
  void weldsOnlyEqualPositions();
  void soups();
  void relinkChangesNothingTwice();
  void relinkNeedsNoNewVertices();
  void singleFacesAreReversed();
};

// V - E + F = 2 · parts - 2 · handles - border loops, for orientable surfaces.
void MeshBuilderTest::manifolds_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::addColumn<long>("euler");
  QTest::newRow("cube") << test::cube() << 2l;
  QTest::newRow("tetrahedron") << test::tetrahedron() << 2l;
  QTest::newRow("icosphere") << test::icosphere(3) << 2l;
  QTest::newRow("sphere with poles") << test::uvSphere(17, 9) << 2l;
  QTest::newRow("bumpy sphere") << test::bumpySphere(3) << 2l;
  QTest::newRow("torus") << test::torus(20, 12) << 0l;
  QTest::newRow("closed cylinder") << test::cylinder(12, 3, 1, 2, true) << 2l;
  QTest::newRow("open cylinder") << test::cylinder(12, 3, 1, 2, false) << 0l;
  QTest::newRow("disc") << test::disc(16, 4) << 1l;
  QTest::newRow("annulus") << test::annulus(16, 3, 1, 2) << 0l;
  QTest::newRow("sphere with 5 holes") << test::sphereWithHoles(4, 5, 0.3) << -3l;
  TriangleSoup two = test::cube();
  test::append(two, test::torus(8, 6));
  QTest::newRow("two parts") << two << 2l;
}

void MeshBuilderTest::manifolds() {
  QFETCH(TriangleSoup, soup);
  QFETCH(long, euler);
  for (const TriangleSoup& s : {soup, test::unshared(soup)}) {
    const BuiltMesh built = buildMesh(s);
    QCOMPARE(validate(built.mesh), std::string());
    QVERIFY(everyTriangleIsThere(s, built));
    QVERIFY(built.report.reversedFaces.empty());
    QVERIFY(built.report.splitVertices.empty());
    QCOMPARE(built.report.nonManifoldEdges, std::size_t{0});
    QCOMPARE(built.report.unpairedHalfEdges, std::size_t{0});
    QCOMPARE(built.report.weldedPoints, s.points.size() - test::allCoordinates(s).size());
    QCOMPARE(built.mesh.vertexSlots(), test::allCoordinates(s).size());
    QCOMPARE(test::eulerCharacteristic(built.mesh), euler);
    QCOMPARE(test::countBorder(built.mesh), test::countEdges(s).border);
    QCOMPARE(test::countSeams(built.mesh), std::size_t{0});
  }
}

void MeshBuilderTest::nonOrientable_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::addColumn<long>("euler");
  QTest::addColumn<int>("border");
  QTest::newRow("Möbius strip") << test::moebiusStrip(24, 3) << 0l << 48;
  QTest::newRow("narrow Möbius strip") << test::moebiusStrip(9, 1) << 0l << 18;
  QTest::newRow("Klein bottle") << test::kleinBottle(20, 8) << 0l << 0;
}

// A one-sided surface is cut open along seams. A vertex inside it with s seams has s fans then, one on the border s
// + 1.
void MeshBuilderTest::nonOrientable() {
  QFETCH(TriangleSoup, soup);
  QFETCH(long, euler);
  QFETCH(int, border);
  QCOMPARE(test::eulerCharacteristic(soup), euler);
  const BuiltMesh built = buildMesh(soup);
  const HalfEdgeMesh& mesh = built.mesh;
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(everyTriangleIsThere(soup, built));
  QCOMPARE(built.report.nonManifoldEdges, std::size_t{0});
  QCOMPARE(test::countBorder(mesh), std::size_t(border));
  QVERIFY(test::countSeams(mesh) > 0);
  QCOMPARE(test::countSeams(mesh), built.report.unpairedHalfEdges);

  std::map<test::Coordinates, int> seamsAt, bordersAt;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    for (Vertex v : {mesh.from(h), mesh.to(h)}) {
      seamsAt[test::coordinates(mesh.position(v))] += mesh.isSeam(h);
      bordersAt[test::coordinates(mesh.position(v))] += mesh.isBorder(h);
    }
  }
  std::size_t fans = 0;
  for (const auto& [p, halves] : seamsAt) {
    QCOMPARE(halves % 2, 0);  // both sides of each seam
    fans += bordersAt[p] > 0 ? halves / 2 + 1 : std::max(1, halves / 2);
  }
  QCOMPARE(mesh.vertexSlots(), fans);
}

void MeshBuilderTest::touchingCubes() {
  for (const auto& [soup, split] : {std::pair{test::twoCubesSharingAnEdge(), std::size_t{2}},
                                    std::pair{test::twoCubesSharingAVertex(), std::size_t{1}}}) {
    const BuiltMesh built = buildMesh(soup);
    QCOMPARE(validate(built.mesh), std::string());
    QVERIFY(everyTriangleIsThere(soup, built));
    QVERIFY(built.report.reversedFaces.empty());
    QCOMPARE(built.report.splitVertices.size(), split);
    QCOMPARE(built.report.nonManifoldEdges, split - 1);
    QCOMPARE(built.report.unpairedHalfEdges, std::size_t{0});
    QCOMPARE(built.mesh.vertexSlots(), std::size_t{16});
    QCOMPARE(test::countBorder(built.mesh), std::size_t{0});
    QCOMPARE(test::eulerCharacteristic(built.mesh), 4l);
    const std::vector<TriangleSoup> parts = test::pieces(built.mesh);
    QCOMPARE(parts.size(), std::size_t{2});
    for (const TriangleSoup& part : parts) {
      QVERIFY(test::countEdges(part).sound());
      QVERIFY(std::abs(test::volume(part) - 1.0) < 1e-12);
    }
  }
}

// Three faces meet where a wall meets the box: two are paired, one is left with a seam. There are no holes.
void MeshBuilderTest::threeFacesAtAnEdge() {
  const TriangleSoup soup = test::boxWithInnerWall();
  QCOMPARE(test::countEdges(soup).nonManifold, std::size_t{4});
  const BuiltMesh built = buildMesh(soup);
  QCOMPARE(validate(built.mesh), std::string());
  QVERIFY(everyTriangleIsThere(soup, built));
  QCOMPARE(built.report.nonManifoldEdges, std::size_t{4});
  QCOMPARE(test::countBorder(built.mesh), std::size_t{0});
  QCOMPARE(test::countSeams(built.mesh), std::size_t{4});
  QCOMPARE(built.report.unpairedHalfEdges, std::size_t{4});
}

// Wedges around the z axis, like slices of a cake with gaps: each must stay one closed solid, whatever the axis'
// direction.
void MeshBuilderTest::manySolidsAtOneEdge() {
  for (int flip = 0; flip < 2; ++flip) {
    for (int n = 2; n <= 7; ++n) {
      TriangleSoup soup;
      const Vec3 low(0, 0, flip ? 1 : 0), high(0, 0, flip ? 0 : 1);
      for (int i = 0; i < n; ++i) {
        const double u = 2 * M_PI * i / n, v = 2 * M_PI * (i + 0.6) / n;
        TriangleSoup wedge = test::tetrahedron();
        wedge.points = {low, Vec3(std::cos(u), std::sin(u), 0.5), Vec3(std::cos(v), std::sin(v), 0.5), high};
        test::append(soup, flip ? test::turnedOver(wedge) : wedge);
      }
      const BuiltMesh built = buildMesh(soup);
      QCOMPARE(validate(built.mesh), std::string());
      QCOMPARE(test::countBorder(built.mesh) + test::countSeams(built.mesh), std::size_t{0});
      const std::vector<TriangleSoup> parts = test::pieces(built.mesh);
      QCOMPARE(parts.size(), std::size_t(n));
      for (const TriangleSoup& part : parts) QVERIFY(test::countEdges(part).sound());
    }
  }
}

void MeshBuilderTest::facesWithoutExtent() {
  TriangleSoup soup = test::cube();
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({3, 3, 3});
  const auto copy = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back(Vec3(soup.points[0]));
  soup.triangles.push_back({0, 2, copy});  // degenerate only once welded
  const BuiltMesh built = buildMesh(soup);
  QCOMPARE(validate(built.mesh), std::string());
  QCOMPARE(built.mesh.faceSlots(), soup.triangles.size());
  QCOMPARE(built.mesh.vertexSlots(), std::size_t{8});
  QCOMPARE(test::countBorder(built.mesh), std::size_t{0});
  for (Face f = 12; f < 15; ++f) {
    QVERIFY(built.mesh.isLive(f));
    QVERIFY(!built.mesh.isProper(f));
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      QVERIFY(!built.mesh.hasOpposite(h));
      QVERIFY(!built.mesh.isBorder(h));
      QVERIFY(!built.mesh.isSeam(h));
    }
  }
  QCOMPARE(test::eulerCharacteristic(built.mesh), 2l);
}

void MeshBuilderTest::emptyAndSingle() {
  QCOMPARE(buildMesh({}).mesh.faceSlots(), std::size_t{0});
  const BuiltMesh one = buildMesh({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}});
  QCOMPARE(validate(one.mesh), std::string());
  QCOMPARE(test::countBorder(one.mesh), std::size_t{3});
}

void MeshBuilderTest::weldsOnlyEqualPositions() {
  TriangleSoup soup = test::unshared(test::cube());
  soup.points[0].x() = std::nextafter(soup.points[0].x(), 1.0);
  const BuiltMesh built = buildMesh(soup);
  QCOMPARE(built.mesh.vertexSlots(), std::size_t{9});
  QCOMPARE(test::countBorder(built.mesh), test::countEdges(soup).border);
  QVERIFY(test::countBorder(built.mesh) > 0);
}

void MeshBuilderTest::soups() {
  QVERIFY(rc::check("any soup builds, nothing is lost, and a border is what has one face in the file", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto steps = *rc::gen::inRange<std::uint32_t>(1, 6);
    const TriangleSoup soup = test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 60), steps);
    const BuiltMesh built = buildMesh(soup);
    RC_ASSERT(validate(built.mesh) == std::string());
    RC_ASSERT(everyTriangleIsThere(soup, built));
    RC_ASSERT(test::countBorder(built.mesh) == test::countEdges(soup).border);
    RC_ASSERT(built.report.nonManifoldEdges == test::countEdges(soup).nonManifold);
    RC_ASSERT(built.report.unpairedHalfEdges == test::countSeams(built.mesh));
    RC_ASSERT(built.mesh.vertexSlots() == test::allCoordinates(soup).size() + built.report.splitVertices.size());
  }));
}

void MeshBuilderTest::relinkChangesNothingTwice() {
  QVERIFY(rc::check("relinking a built mesh changes nothing", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HalfEdgeMesh mesh = buildMesh(test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 60), 4)).mesh;
    HalfEdgeMesh again = mesh;
    relink(again);
    RC_ASSERT(test::sameMesh(mesh, again));
  }));
}

// Two cubes at one corner have two vertices there. Without the first cube's first faces there are still two fans.
void MeshBuilderTest::relinkNeedsNoNewVertices() {
  HalfEdgeMesh mesh = buildMesh(test::twoCubesSharingAVertex()).mesh;
  const std::size_t before = mesh.vertexSlots();
  std::vector<Face> firstFan;
  for (Face f = 0; f < 12; ++f) {
    const TrianglePoints p = mesh.points(f);
    if (std::find(p.begin(), p.end(), Vec3(1, 1, 1)) != p.end()) firstFan.push_back(f);
  }
  // Moved behind the second cube, so that the fan's faces come last.
  for (Face f : firstFan) {
    const Triangle t = mesh.triangle(f);
    mesh.removeFace(f);
    mesh.addFace(t);
  }
  const Vertex theirs = [&] {
    for (Face f = 12; f < 24; ++f)
      for (Vertex v : mesh.triangle(f))
        if (mesh.position(v) == Vec3(1, 1, 1)) return v;
    return kNone;
  }();
  relink(mesh);
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(mesh.vertexSlots(), before);
  for (Face f = 12; f < 24; ++f)
    for (Vertex v : mesh.triangle(f)) QVERIFY(mesh.position(v) != Vec3(1, 1, 1) || v == theirs);
}

// With the reversed faces as the soup has them, every corner stands where it stood in the soup; an edge at which two of
// its triangles disagree is no border. relink() turns the same faces once more.
void MeshBuilderTest::singleFacesAreReversed() {
  QVERIFY(rc::check("what building reverses can be reversed back", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    TriangleSoup soup = *rc::gen::arbitrary<bool>()
                            ? test::sphereWithHoles(2, 2, 0.4)
                            : test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 60), 4);
    for (Triangle& t : soup.triangles)
      if (random() % 4 == 0) std::swap(t[1], t[2]);
    const BuiltMesh built = buildMesh(soup);
    HalfEdgeMesh mesh = built.mesh;
    reverseFaces(mesh, built.report.reversedFaces);
    RC_ASSERT(validate(mesh) == std::string());
    for (Face f = 0; f < mesh.faceSlots(); ++f)
      for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(mesh.points(f)[k] == soup.points[soup.triangles[f][k]]);
    RC_ASSERT(test::countBorder(mesh) == test::countEdges(soup).border);
    RC_ASSERT(relink(mesh).reversedFaces == built.report.reversedFaces);
    for (Face f = 0; f < mesh.faceSlots(); ++f) RC_ASSERT(mesh.points(f) == built.mesh.points(f));
  }));
  HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  const Face one[] = {4};
  reverseFaces(mesh, one);
  QCOMPARE(test::countSeams(mesh), std::size_t{6});  // three edges, both sides
  JobState state;
  state.cancelled = true;
  reverseFaces(mesh, one, Progress(state));
  QCOMPARE(test::countSeams(mesh), std::size_t{6});
}

HANDWHEEL_TEST(MeshBuilderTest)
#include "MeshBuilderTest.moc"
