// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/RegionGrowing.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>
#include <numeric>

using namespace handwheel;

class RegionGrowingTest : public QObject {
  Q_OBJECT

 private slots:
  void oneSideOfACube();
  void oneStripOfACylinder();
  void needlesNeitherStopNorCarry();
  void sameInEverySizeAndPosition();
  void isAnEquivalence();
  void connectedParts();
  void ringsAreThoseOfTheVertices();
  void shrinkingIsGrowingTheRest();
  void theBorderTakesNothingAway();
  void aFanOfTenThousand();
  void oddSeeds();
  void endsEarly();
};

namespace {

constexpr double kDegree = M_PI / 180.0;

// A cube of edge 1, each side n × n squares; side i has the triangles from 2 n² i on.
TriangleSoup cubeOfCells(std::uint32_t n) {
  TriangleSoup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double level : {0.0, 1.0}) {
      TriangleSoup side = test::grid(n + 1, n + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
        Vec3 p;
        p[axis] = level;
        p[(axis + 1) % 3] = double(i) / n;
        p[(axis + 2) % 3] = double(j) / n;
        return p;
      });
      test::append(soup, level == 1.0 ? side : test::turnedOver(side));
    }
  }
  return soup;
}

FaceSelection within(const HalfEdgeMesh& mesh, Face seed, double angle) {
  return *facesWithinAngle(mesh, std::array{seed}, angle);
}

FaceSelection randomSelection(const HalfEdgeMesh& mesh, std::mt19937& random, unsigned oneIn) {
  return FaceSelection::where(mesh.faceSlots(), [&](Face f) { return mesh.isLive(f) && random() % oneIn == 0; });
}

HalfEdgeMesh anyMesh(std::mt19937& random) {
  TriangleSoup soup =
      *rc::gen::element(test::bumpySphere(2), test::torus(12, 9), test::disc(14, 5), test::sphereWithHoles(3, 5, 0.3),
                        test::randomBlocks(random, 15, 3), test::moebiusStrip(20, 3), test::twoCubesSharingAVertex());
  return buildMesh(soup).mesh;
}

}  // namespace

void RegionGrowingTest::oneSideOfACube() {
  for (const std::uint32_t n : {1u, 2u, 7u}) {
    const HalfEdgeMesh mesh = buildMesh(cubeOfCells(n)).mesh;
    for (Face seed = 0; seed < mesh.faceSlots(); seed += 5) {
      const Face first = seed / (2 * n * n) * 2 * n * n;
      for (const double angle : {0.0, 30 * kDegree, 89.999 * kDegree}) {
        const FaceSelection side = within(mesh, seed, angle);
        QCOMPARE(side.count(), std::size_t(2 * n * n));
        QVERIFY(side.contains(first) && side.contains(first + 2 * n * n - 1));
      }
      QCOMPARE(within(mesh, seed, 90.001 * kDegree).count(), std::size_t(12 * n * n));
      QCOMPARE(within(mesh, seed, -1.0).count(), std::size_t(1));
      QCOMPARE(within(mesh, seed, std::nan("")).count(), std::size_t(1));
    }
  }
}

// The planes of a cylinder's strips differ by 360° / n.
void RegionGrowingTest::oneStripOfACylinder() {
  const std::uint32_t n = 24, m = 5;
  const HalfEdgeMesh mesh = buildMesh(test::cylinder(n, m, 3.0, 10.0, true)).mesh;
  QCOMPARE(within(mesh, 0, 14.99 * kDegree).count(), std::size_t(2 * m));
  QCOMPARE(within(mesh, 0, 15.01 * kDegree).count(), std::size_t(2 * m * n));
  QCOMPARE(within(mesh, 0, 90.01 * kDegree).count(), std::size_t(2 * m * n + 2 * n));
}

void RegionGrowingTest::needlesNeitherStopNorCarry() {
  TriangleSoup soup = test::cube();
  for (std::size_t f = 0; f < 12; ++f) test::addNeedles(soup, f, int(f % 3), {0.25, 0.5, 0.75});
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  for (Face seed = 0; seed < mesh.faceSlots(); ++seed) {
    if (isDegenerate(mesh.points(seed))) continue;
    TriangleSoup side;
    within(mesh, seed, 1 * kDegree).forEach([&](Face f) {
      const auto n = static_cast<std::uint32_t>(side.points.size());
      for (const Vec3& p : mesh.points(f)) side.points.push_back(p);
      side.triangles.push_back({n, n + 1, n + 2});
    });
    QVERIFY(std::abs(test::area(side) - 1.0) < 1e-12);
  }
}

void RegionGrowingTest::sameInEverySizeAndPosition() {
  const TriangleSoup soup = cubeOfCells(4);  // its coordinates are exact far away, too
  for (const double scale : {1e-150, 1e-6, 1.0, 1e6, 1e150})
    QCOMPARE(within(buildMesh(test::moved(soup, Vec3::Zero(), scale)).mesh, 9, 1 * kDegree).count(), std::size_t(32));
  for (const double far : {1e7, -1e12})
    QCOMPARE(within(buildMesh(test::moved(soup, Vec3(far, far, far))).mesh, 9, 1 * kDegree).count(), std::size_t(32));
}

// The result does not depend on the face of a region from which it starts: the regions are the classes of faces that
// flat edges join, found here by union-find and an arc cosine.
void RegionGrowingTest::isAnEquivalence() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const HalfEdgeMesh mesh = anyMesh(random);
    const double angle = *rc::gen::inRange(1, 179) * kDegree + 0.123 * kDegree;
    std::vector<Face> root(mesh.faceSlots());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&](Face f) {
      while (root[f] != f) f = root[f];
      return f;
    };
    const auto normal = [&](Face f) {
      const auto p = mesh.points(f);
      return Vec3((p[1] - p[0]).cross(p[2] - p[0]).normalized());
    };
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
      if (!mesh.hasOpposite(h)) continue;
      const Face f = h / 3, g = mesh.opposite(h) / 3;
      if (std::acos(std::clamp(normal(f).dot(normal(g)), -1.0, 1.0)) <= angle) root[find(f)] = find(g);
    }
    const Face seed = static_cast<Face>(random() % mesh.faceSlots());
    const FaceSelection region = within(mesh, seed, angle);
    for (Face f = 0; f < mesh.faceSlots(); ++f) RC_ASSERT(region.contains(f) == (find(f) == find(seed)));
  }));
}

void RegionGrowingTest::connectedParts() {
  TriangleSoup soup = test::icosphere(2);
  test::append(soup, test::moved(test::torus(8, 6), Vec3(10, 0, 0)));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(connectedFaces(mesh, std::array<Face, 1>{5})->count(), std::size_t(320));
  QCOMPARE(connectedFaces(mesh, std::array<Face, 1>{320})->count(), std::size_t(96));
  QCOMPARE(connectedFaces(mesh, std::array<Face, 2>{0, 320})->count(), std::size_t(416));
  // Parts that touch only at a vertex or an edge are separate.
  for (const TriangleSoup& cubes : {test::twoCubesSharingAVertex(), test::twoCubesSharingAnEdge()})
    QCOMPARE(connectedFaces(buildMesh(cubes).mesh, std::array<Face, 1>{3})->count(), std::size_t(12));
}

void RegionGrowingTest::ringsAreThoseOfTheVertices() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const HalfEdgeMesh mesh = anyMesh(random);
    const FaceSelection some = randomSelection(mesh, random, *rc::gen::element(2u, 10u, 100u));
    std::set<Vertex> vertices;
    some.forEach([&](Face f) { vertices.insert(mesh.triangle(f).begin(), mesh.triangle(f).end()); });
    const FaceSelection grown = grownByRing(mesh, some);
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      const Triangle& t = mesh.triangle(f);
      const bool touches = std::any_of(t.begin(), t.end(), [&](Vertex v) { return vertices.count(v) != 0; });
      RC_ASSERT(grown.contains(f) == touches);
    }
  }));
}

void RegionGrowingTest::shrinkingIsGrowingTheRest() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const HalfEdgeMesh mesh = anyMesh(random);
    FaceSelection some = randomSelection(mesh, random, 10);
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) some = grownByRing(mesh, some);
    RC_ASSERT(shrunkByRing(mesh, some) == grownByRing(mesh, some.inverted(mesh)).inverted(mesh));
  }));
}

void RegionGrowingTest::theBorderTakesNothingAway() {
  const HalfEdgeMesh mesh = buildMesh(test::disc(12, 4)).mesh;
  QVERIFY(shrunkByRing(mesh, FaceSelection::all(mesh)) == FaceSelection::all(mesh));
}

void RegionGrowingTest::aFanOfTenThousand() {
  const std::uint32_t n = 10'000;
  const HalfEdgeMesh mesh = buildMesh(test::disc(n, 1)).mesh;
  QCOMPARE(grownByRing(mesh, FaceSelection{0}).count(), std::size_t(n));
  QVERIFY(shrunkByRing(mesh, FaceSelection{0}).empty());
}

void RegionGrowingTest::oddSeeds() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  mesh.removeFace(7);
  QVERIFY(connectedFaces(mesh, std::array<Face, 3>{7, 80, kNone})->empty());
  QVERIFY(connectedFaces(mesh, {})->empty());
  QVERIFY(facesWithinAngle(HalfEdgeMesh(), std::array<Face, 1>{0}, 1.0)->empty());
  QCOMPARE(connectedFaces(mesh, std::array<Face, 2>{8, 8})->count(), std::size_t(79));
  QVERIFY(grownByRing(mesh, FaceSelection{7, 500}) == (FaceSelection{7, 500}));

  TriangleSoup folded = test::cube();
  folded.triangles.push_back({0, 0, 1});  // joins nothing
  const HalfEdgeMesh withFolded = buildMesh(folded).mesh;
  QCOMPARE(connectedFaces(withFolded, std::array<Face, 1>{12})->count(), std::size_t(1));
  QCOMPARE(connectedFaces(withFolded, std::array<Face, 1>{0})->count(), std::size_t(12));
}

void RegionGrowingTest::endsEarly() {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(4)).mesh;
  JobState state;
  GrowthLimit limit{100, Progress(state)};
  const auto some = connectedFaces(mesh, std::array<Face, 1>{0}, limit);
  QVERIFY(some && some->count() >= 100 && some->count() < 110);
  state.cancelled = true;
  QVERIFY(!connectedFaces(mesh, std::array<Face, 1>{0}, limit));
  QVERIFY(!facesWithinAngle(mesh, std::array<Face, 1>{0}, 1.0, limit));
}

HANDWHEEL_TEST(RegionGrowingTest)
#include "RegionGrowingTest.moc"
