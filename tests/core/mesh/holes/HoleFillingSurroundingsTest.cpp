// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

namespace {

constexpr FillMethod kMethods[] = {FillMethod::Fair, FillMethod::Refined, FillMethod::Ear, FillMethod::Minimal};

FillOptions only(FillMethod method) {
  FillOptions options;
  options.method = method;
  options.tryOthers = false;
  return options;
}

// A thin tetrahedron that stands on its tip.
TriangleSoup needleOn(const Vec3& tip, double height) {
  TriangleSoup s = test::tetrahedron();
  const double w = 0.1 * height;
  s.points = {tip, tip + Vec3(w, 0, height), tip + Vec3(0, w, height), tip + Vec3(-w, -w, height)};
  return s;
}

}  // namespace

// Tests the obstacles that a patch must avoid, and its joints with the surroundings.
class HoleFillingSurroundingsTest : public QObject {
  Q_OBJECT

 private slots:
  void poleThroughTheHole();
  void obstacleBeforeTheBulge();
  void patchesRespectEachOther();
  void roundsNewVertices();
  void touchesNoVertex();
  void pinchedLoops();
};

// The pole is five times as long as the hole is wide, so no disc over the hole avoids it without leaving the opening.
void HoleFillingSurroundingsTest::poleThroughTheHole() {
  TriangleSoup soup = test::annulus(24, 3, 1.0, 3.0);
  const TriangleSoup pole = test::cylinder(8, 10, 0.1, 20.0, true);
  test::append(soup, test::moved(pole, Vec3(0.05, 0.02, -10.0)));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  HoleFiller filler(mesh);
  BoundaryLoop hole;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh))
    if (loop.box.sizes().norm() < 4.0) hole = loop;
  QCOMPARE(hole.halfEdges.size(), std::size_t{24});
  for (FillMethod method : kMethods) {
    FillOptions options;
    options.method = method;
    QVERIFY(filler.propose(hole, options).failure == FillFailure::SelfIntersecting);
    options.tryOthers = false;
    const FillFailure failure = filler.propose(hole, options).failure;
    QVERIFY(failure == FillFailure::SelfIntersecting || failure == FillFailure::NoPatch);
  }
}

// A small solid obstructs the patch that continues the sphere; a membrane fits below it.
void HoleFillingSurroundingsTest::obstacleBeforeTheBulge() {
  TriangleSoup soup = test::sphereWithoutCap(3);
  test::append(soup, test::cube(0.1, Vec3(-0.05, -0.05, 0.95)));
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  HoleFiller filler(mesh);
  QVERIFY(filler.propose(loop, only(FillMethod::Fair)).failure == FillFailure::SelfIntersecting);
  const FillAttempt attempt = filler.propose(loop, {});
  QVERIFY(attempt.failure == FillFailure::None);
  QVERIFY(attempt.patch.continuity == Continuity::Position);
  filler.accept(loop, attempt.patch);
  QVERIFY(test::countEdges(filler.mesh()).sound());
  QCOMPARE(test::meetingPairs(filler.mesh()), std::size_t{0});
}

// Two spheres whose caps would overlap face each other without them.
void HoleFillingSurroundingsTest::patchesRespectEachOther() {
  TriangleSoup soup = test::sphereWithoutCap(3);
  TriangleSoup other = test::sphereWithoutCap(3);
  for (Vec3& p : other.points) p = Vec3(p.x(), -p.y(), 1.97 - p.z());
  test::append(soup, other);
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  HoleFiller filler(mesh);
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{2});
  for (const BoundaryLoop& loop : loops) {
    const FillAttempt attempt = filler.propose(loop, {});
    QVERIFY(attempt.failure == FillFailure::None);
    filler.accept(loop, attempt.patch);
  }
  QVERIFY(test::countEdges(filler.mesh()).sound());
  QCOMPARE(test::meetingPairs(filler.mesh()), std::size_t{0});
}

void HoleFillingSurroundingsTest::roundsNewVertices() {
  const HalfEdgeMesh mesh = buildMesh(test::sphereWithoutCap(3)).mesh;
  FillOptions options;
  options.numbers = NumberType::Float32;
  const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
  const Patch patch = HoleFiller(mesh).propose(loop, options).patch;
  QVERIFY(patch.points.size() > patch.loopSize);
  for (std::size_t i = 0; i < patch.points.size(); ++i) {
    if (i < patch.loopSize) {
      QVERIFY(test::sameBits(patch.points[i], loopPoints(mesh, loop)[i]));
      continue;
    }
    for (double x : patch.points[i]) {
      volatile float single = static_cast<float>(x);
      QVERIFY(static_cast<double>(single) == x && !(x == 0.0 && std::signbit(x)));
    }
  }
}

// First it is learnt where the patch will have a vertex; then a needle's tip is put exactly there, outside. The part
// would hang together at one point if the patch came through it.
void HoleFillingSurroundingsTest::touchesNoVertex() {
  const TriangleSoup sphere = test::sphereWithoutCap(3);
  const HalfEdgeMesh alone = buildMesh(sphere).mesh;
  const Patch first = HoleFiller(alone).propose(findBoundaryLoops(alone).at(0), {}).patch;
  QVERIFY(first.points.size() > first.loopSize);
  for (std::size_t i = first.loopSize; i < first.points.size(); i += 5) {
    TriangleSoup soup = sphere;
    test::append(soup, needleOn(first.points[i], 0.3));
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const FillAttempt attempt = HoleFiller(mesh).propose(findBoundaryLoops(mesh).at(0), {});
    QVERIFY(attempt.failure == FillFailure::None);
    const std::set<test::Coordinates> taken = test::allCoordinates(soup);
    for (std::size_t k = attempt.patch.loopSize; k < attempt.patch.points.size(); ++k)
      QVERIFY2(!taken.contains(test::coordinates(attempt.patch.points[k])), "a new vertex lies on one of the part");
  }
}

// Two missing triangles that touch at a vertex: one border that passes it twice, two loops.
void HoleFillingSurroundingsTest::pinchedLoops() {
  TriangleSoup soup = test::icosphere(2);
  std::vector<std::size_t> around;  // the triangles at vertex 20, which has six
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    if (std::count(soup.triangles[i].begin(), soup.triangles[i].end(), 20u)) around.push_back(i);
  QCOMPARE(around.size(), std::size_t{6});
  const auto shared = [&](std::size_t i, std::size_t j) {
    return std::count_if(soup.triangles[i].begin(), soup.triangles[i].end(), [&](std::uint32_t v) {
      return std::count(soup.triangles[j].begin(), soup.triangles[j].end(), v) > 0;
    });
  };
  std::size_t across = 0;
  for (std::size_t i : around)
    if (shared(around[0], i) == 1) across = i;
  soup.triangles.erase(soup.triangles.begin() + std::ptrdiff_t(std::max(around[0], across)));
  soup.triangles.erase(soup.triangles.begin() + std::ptrdiff_t(std::min(around[0], across)));

  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{2});
  HoleFiller filler(mesh);
  for (const BoundaryLoop& loop : loops) {
    const FillAttempt attempt = filler.propose(loop, {});
    QVERIFY(attempt.failure == FillFailure::None);
    filler.accept(loop, attempt.patch);
    QCOMPARE(validate(filler.mesh()), std::string());
  }
  QCOMPARE(test::eulerCharacteristic(filler.mesh()), 2l);
  QCOMPARE(test::countBorder(filler.mesh()), std::size_t{0});
  QVERIFY(test::countEdges(filler.mesh()).sound());
}

HANDWHEEL_TEST(HoleFillingSurroundingsTest)
#include "HoleFillingSurroundingsTest.moc"
