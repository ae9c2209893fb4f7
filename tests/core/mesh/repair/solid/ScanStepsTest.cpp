// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/repair/Repair.h"
#include "mesh/repair/solid/CrackStitching.h"
#include "mesh/repair/solid/DoubleLayers.h"
#include "mesh/repair/solid/FoldSmoothing.h"
#include "mesh/repair/solid/ScanCrumbs.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <random>

using namespace handwheel;

namespace {

// The triangles whose centre is on the given side of a plane through the origin.
TriangleSoup half(const TriangleSoup& soup, const Vec3& side) {
  TriangleSoup part{soup.points, {}};
  for (const Triangle& t : soup.triangles)
    if ((soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]).dot(side) > 0.0) part.triangles.push_back(t);
  return part;
}

// A ball whose halves came apart by a gap.
TriangleSoup crackedBall(double gap) {
  const TriangleSoup ball = test::icosphere(4);
  const Vec3 side = Vec3(0.3, -0.2, 1.0).normalized();
  TriangleSoup cracked = half(ball, -side);
  test::append(cracked, test::moved(half(ball, side), gap * side));
  return cracked;
}

// The part of a sphere around a point, moved outwards.
TriangleSoup patchOver(const TriangleSoup& ball, const Vec3& centre, double radius, double distance) {
  TriangleSoup patch{ball.points, {}};
  for (const Triangle& t : ball.triangles)
    if ((ball.points[t[0]] - centre).norm() < radius) patch.triangles.push_back(t);
  for (Vec3& p : patch.points) p *= 1.0 + distance;
  return patch;
}

double farthestFromUnitSphere(const HalfEdgeMesh& mesh) {
  double farthest = 0.0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vec3& p : mesh.points(f)) farthest = std::max(farthest, std::abs(p.norm() - 1.0));
  }
  return farthest;
}

}  // namespace

class ScanStepsTest : public QObject {
  Q_OBJECT

 private slots:
  void secondLayersAreFound();
  void layersThatWereTurnedOver();
  void thinWallsAreNoLayers();
  void cracksAreStitched();
  void whatIsNoCrack();
  void crumbsAreFoundAndIslandsStay();
  void foldsOfNoiseAreSmoothed();
  void whatDoesNotFoldStays();
  void aDamagedBallBecomesOne();
};

// Both layers have the reach between them, or less.
void ScanStepsTest::secondLayersAreFound() {
  const TriangleSoup ball = test::icosphere(4);
  for (const double distance : {0.002, -0.002, 0.01}) {
    TriangleSoup soup = ball;
    const TriangleSoup patch = patchOver(ball, Vec3::UnitZ(), 0.5, distance);
    test::append(soup, patch);
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const std::vector<Face> layers = findDoubleLayers(mesh, 0.011);
    QCOMPARE(layers.size(), patch.triangles.size());
    for (const Face f : layers) QVERIFY(f >= ball.triangles.size());
    QVERIFY(findDoubleLayers(mesh, 0.5 * std::abs(distance)).empty());
  }
}

// A layer whose triangles were turned over is found on either side; its boundary is far from that of the other.
void ScanStepsTest::layersThatWereTurnedOver() {
  const TriangleSoup ball = test::withHole(test::icosphere(4), -Vec3::UnitZ(), 0.3);
  for (const double distance : {0.004, -0.004}) {
    TriangleSoup soup = ball;
    const TriangleSoup patch = test::turnedOver(patchOver(test::icosphere(4), Vec3::UnitZ(), 0.5, distance));
    test::append(soup, patch);
    QCOMPARE(findDoubleLayers(buildMesh(soup).mesh, 0.011).size(), patch.triangles.size());
  }
}

// The other side of a plate is as near, and faces the opposite direction. A closed body inside is none either.
void ScanStepsTest::thinWallsAreNoLayers() {
  TriangleSoup plate = test::disc(32, 6);
  test::append(plate, test::moved(test::turnedOver(test::disc(32, 6)), Vec3(0, 0, -0.001)));
  QVERIFY(findDoubleLayers(buildMesh(plate).mesh, 0.01).empty());
  TriangleSoup balls = test::icosphere(3);
  test::append(balls, test::moved(test::icosphere(3), Vec3::Zero(), 0.999));
  QVERIFY(findDoubleLayers(buildMesh(balls).mesh, 0.01).empty());
  QVERIFY(findDoubleLayers({}, 0.01).empty());
}

// The gaps are narrower than the edges (0.07), or nearly as wide. The ball is closed by its own triangles.
void ScanStepsTest::cracksAreStitched() {
  for (const double gap : {0.002, 0.02, 0.06}) {
    HalfEdgeMesh mesh = buildMesh(crackedBall(gap)).mesh;
    const std::size_t faces = mesh.liveFaceCount();
    QVERIFY(test::countBorder(mesh) > 100);
    QVERIFY(!stitchCracks(mesh, 0.08).empty());
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(test::countBorder(mesh), std::size_t{0});
    QCOMPARE(mesh.liveFaceCount(), faces);
    QCOMPARE(test::eulerCharacteristic(mesh), 2l);
  }
}

// A gap wider than the reach, a hole, and the two ends of a tube.
void ScanStepsTest::whatIsNoCrack() {
  HalfEdgeMesh wide = buildMesh(crackedBall(0.1)).mesh;
  const HalfEdgeMesh before = wide;
  QVERIFY(stitchCracks(wide, 0.05).empty());
  QVERIFY(test::sameMesh(wide, before));
  HalfEdgeMesh holed = buildMesh(test::sphereWithHoles(4, 3, 0.2)).mesh;
  QVERIFY(stitchCracks(holed, 0.05).empty());
  HalfEdgeMesh tube = buildMesh(test::cylinder(64, 8, 1.0, 0.04, false)).mesh;
  QVERIFY(stitchCracks(tube, 0.05).empty());
  HalfEdgeMesh none;
  QVERIFY(stitchCracks(none, 1.0).empty());
}

void ScanStepsTest::crumbsAreFoundAndIslandsStay() {
  const TriangleSoup ball = test::icosphere(4);
  TriangleSoup soup = test::withHole(ball, Vec3::UnitZ(), 0.4);
  const std::size_t own = soup.triangles.size();
  TriangleSoup island = patchOver(ball, Vec3::UnitZ(), 0.15, 0.0);
  test::append(soup, test::unshared(island));  // so that it touches nothing
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QVERIFY(island.triangles.size() >= tolerance::kCrumbFaces);
  QVERIFY(findCrumbs(mesh).empty());
  test::append(soup, test::moved(test::tetrahedron(), Vec3(1.2, 0, 0), 0.02));
  test::append(soup, {{{0.1, 0.2, 1.0}, {0.12, 0.2, 1.0}, {0.1, 0.22, 1.0}}, {{0, 1, 2}}});
  mesh = buildMesh(soup).mesh;
  const std::vector<Face> crumbs = findCrumbs(mesh);
  QCOMPARE(crumbs.size(), std::size_t{5});
  for (const Face f : crumbs) QVERIFY(f >= own + island.triangles.size());
}

// Noise of a third of the edges folds the surface. No vertex moves farther than the noise that is measured.
void ScanStepsTest::foldsOfNoiseAreSmoothed() {
  TriangleSoup noisy = test::icosphere(4);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (Vec3& p : noisy.points) p += Vec3(noise(random), noise(random), noise(random));
  HalfEdgeMesh mesh = buildMesh(noisy).mesh;
  const std::size_t pairs = test::meetingPairs(mesh);
  QVERIFY(pairs > 20);
  const HalfEdgeMesh before = mesh;
  const SmoothedFolds done = smoothFolds(mesh, NumberType::Float64);
  QVERIFY2(test::meetingPairs(mesh) * 20 < pairs, qPrintable(QString::number(test::meetingPairs(mesh))));
  QVERIFY(done.noise > 0.01 && done.noise < 0.06);
  QVERIFY(done.farthest <= 3.0 * done.noise * (1.0 + 1e-12));
  std::size_t moved = 0;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) moved += !test::sameBits(mesh.position(v), before.position(v));
  QCOMPARE(done.moved.size(), moved);
  QVERIFY(moved < mesh.vertexSlots() / 2);
}

// Two balls that overlap are no folds, and a smooth surface has none.
void ScanStepsTest::whatDoesNotFoldStays() {
  TriangleSoup balls = test::icosphere(3);
  test::append(balls, test::moved(test::icosphere(3), Vec3(1.2, 0.1, 0.2)));
  HalfEdgeMesh mesh = buildMesh(balls).mesh;
  const HalfEdgeMesh before = mesh;
  QVERIFY(smoothFolds(mesh, NumberType::Float64).moved.empty());
  QVERIFY(test::sameMesh(mesh, before));
}

// Noise, a hole, a second layer, a crack and crumbs at once. The result is one closed body within 5 % of the ball.
void ScanStepsTest::aDamagedBallBecomesOne() {
  TriangleSoup soup = test::withHole(crackedBall(0.01), Vec3(1, 0, 0), 0.3);
  test::append(soup, patchOver(test::icosphere(4), Vec3(0, 1, 0.3).normalized(), 0.4, 0.008));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (int i = 0; i < 12; ++i) {
    const Vec3 at = 1.05 * Vec3(place(random), place(random), place(random)).normalized();
    test::append(soup, test::moved(test::tetrahedron(), at, 0.02));
  }
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  RepairOptions options;
  options.goal = RepairGoal::Solid;
  const RepairReport report = repair(mesh, options);
  QVERIFY(!report.cancelled);
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QCOMPARE(test::pieces(buildMesh(mesh.compact().soup).mesh).size(), std::size_t{1});
  QVERIFY2(farthestFromUnitSphere(mesh) < 0.05, qPrintable(QString::number(farthestFromUnitSphere(mesh))));
}

HANDWHEEL_TEST(ScanStepsTest)
#include "ScanStepsTest.moc"
