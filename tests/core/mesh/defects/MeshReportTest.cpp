// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/MeshReport.h"

#include "HoleShapes.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

MeshReport reportOn(const TriangleSoup& soup) {
  return handwheel::reportOn(soup, SelfIntersections::Count);
}

// The rings of the sphere with poles are regular n-gons, so it is a pile of frusta.
double volumeOfUvSphere(std::uint32_t n, std::uint32_t m) {
  const auto area = [&](std::uint32_t j) {
    const double r = std::cos(M_PI * j / m - M_PI / 2.0);
    return 0.5 * n * std::sin(2.0 * M_PI / n) * r * r;
  };
  double sum = 0.0;
  for (std::uint32_t j = 0; j < m; ++j) {
    const double height = std::sin(M_PI * (j + 1) / m - M_PI / 2.0) - std::sin(M_PI * j / m - M_PI / 2.0);
    sum += height / 3.0 * (area(j) + area(j + 1) + std::sqrt(area(j) * area(j + 1)));
  }
  return sum;
}

bool near(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

}  // namespace

class MeshReportTest : public QObject {
  Q_OBJECT

 private slots:
  void cubeHasItAll();
  void volumes();
  void volumeFarFromTheOrigin();
  void openShapes();
  void loops();
  void holesAreMeasured();
  void nonOrientable();
  void extremeSizes();
  void touchingCubes();
  void innerWall();
  void degenerateFaces();
  void duplicates();
  void reversedFace();
  void selfIntersections();
  void samePiecesAsTheListOfDefects();
  void cancelled();
  void empty();
  void soups();
  void sameStateAsTheListOfDefects();
};

void MeshReportTest::cubeHasItAll() {
  for (const TriangleSoup& soup : {test::cube(2.0, Vec3(1, 2, 3)), test::unshared(test::cube(2.0, Vec3(1, 2, 3)))}) {
    const MeshReport r = reportOn(soup);
    QCOMPARE(r.triangles, std::size_t{12});
    QCOMPARE(r.vertices, std::size_t{8});
    QCOMPARE(r.components, std::size_t{1});
    QVERIFY(r.closed && r.manifold && r.oriented && r.isSound());
    QVERIFY(r.loops.empty());
    QCOMPARE(r.boundaryEdges + r.nonManifoldEdges + r.nonManifoldVertices + r.inconsistentEdges, std::size_t{0});
    QCOMPARE(r.degenerateFaces + r.duplicateFaces, std::size_t{0});
    QVERIFY(r.selfIntersectingPairs == std::size_t{0});
    QVERIFY(r.volumeMm3 && near(*r.volumeMm3, 8.0));
    QVERIFY(r.box.min() == Vec3(1, 2, 3) && r.box.max() == Vec3(3, 4, 5));
  }
}

void MeshReportTest::volumes() {
  QVERIFY(near(reportOn(test::tetrahedron()).volumeMm3.value(), 1.0 / 6.0));
  QVERIFY(near(reportOn(test::uvSphere(24, 13)).volumeMm3.value(), volumeOfUvSphere(24, 13)));
  QVERIFY(near(reportOn(test::turnedOver(test::cube())).volumeMm3.value(), -1.0));
  QVERIFY(near(reportOn(test::cylinder(12, 3, 2.0, 5.0, true)).volumeMm3.value(), 5.0 * 6 * std::sin(M_PI / 6) * 4.0));
  TriangleSoup hollow = test::cube(3.0);
  test::append(hollow, test::turnedOver(test::cube(1.0, Vec3(1, 1, 1))));
  QVERIFY(near(reportOn(hollow).volumeMm3.value(), 26.0));
  QCOMPARE(reportOn(hollow).components, std::size_t{2});
}

// At 10^6 the coordinates of a unit cube are exact, so its volume is.
void MeshReportTest::volumeFarFromTheOrigin() {
  QVERIFY(std::abs(reportOn(test::cube(1.0, Vec3(1e6, -1e6, 1e6))).volumeMm3.value() - 1.0) < 1e-9);
}

void MeshReportTest::openShapes() {
  for (const auto& [soup, edges] :
       {std::pair{test::disc(16, 3), 16}, std::pair{test::cylinder(12, 2, 1, 1, false), 24}}) {
    const MeshReport r = reportOn(soup);
    QVERIFY(!r.closed && r.manifold && r.oriented && !r.isSound());
    QVERIFY(!r.volumeMm3);
    QCOMPARE(r.boundaryEdges, std::size_t(edges));
  }
}

void MeshReportTest::loops() {
  const MeshReport r = reportOn(test::annulus(16, 2, 1.0, 2.0));
  QCOMPARE(r.loops.size(), std::size_t{2});
  for (std::size_t i = 0; i < 2; ++i) {  // the inner circle has the smaller vertices
    QCOMPARE(r.loops[i].id, int(i));
    QCOMPARE(r.loops[i].edges, std::size_t{16});
    QVERIFY(std::abs(r.loops[i].lengthMm - 16 * 2 * (i + 1.0) * std::sin(M_PI / 16)) < 1e-12);
    QVERIFY(r.loops[i].planarity < 1e-12);
  }
}

// A square hole of 4 encloses 16; an island lies in the round one, and two holes that touch have none.
void MeshReportTest::holesAreMeasured() {
  const auto holeOf = [](const TriangleSoup& soup) {
    const std::vector<LoopReport> loops = reportOn(soup).loops;
    const auto hole = std::max_element(loops.begin(), loops.end(), [](const LoopReport& a, const LoopReport& b) {
      return (a.isSheetBoundary ? 0.0 : a.areaMm2) < (b.isSheetBoundary ? 0.0 : b.areaMm2);
    });
    return *hole;
  };
  const LoopReport square = holeOf(test::plateWithHole());
  QVERIFY(near(square.areaMm2, 16.0) && near(square.lengthMm, 16.0));
  QCOMPARE(square.islands, std::size_t{0});
  const LoopReport round = holeOf(test::plateWithIsland());
  QCOMPARE(round.islands, std::size_t{1});
  QVERIFY(round.areaMm2 > 0.9 * M_PI * 36.0 && round.areaMm2 < 1.3 * M_PI * 36.0);
  QCOMPARE(holeOf(test::plateWithPinchedHole()).islands, std::size_t{0});
  // Moved apart, and one of its triangles turned over.
  TriangleSoup torn = test::unshared(test::plateWithHole());
  std::swap(torn.triangles[7][0], torn.triangles[7][1]);
  QCOMPARE(reportOn(torn).reversedFaces, std::size_t{1});
  TriangleSoup flake = test::sphereWithoutCap(3);
  test::append(flake, {{{9, 0, 0}, {9.001, 0, 0}, {9, 0.001, 0}}, {{0, 1, 2}}});
  QCOMPARE(reportOn(flake).debris, std::size_t{1});
}

void MeshReportTest::nonOrientable() {
  const MeshReport klein = reportOn(test::kleinBottle(20, 8));
  QVERIFY(klein.closed && klein.manifold && !klein.oriented && !klein.isSound());
  QVERIFY(klein.loops.empty());
  QVERIFY(*klein.selfIntersectingPairs > 0);  // no Klein bottle fits in space without
  QCOMPARE(klein.nonManifoldVertices, std::size_t{0});
  QCOMPARE(klein.oneSidedPieces, std::size_t{1});
  QCOMPARE(klein.eulerCharacteristic, 0l);
  QVERIFY(!klein.volumeMm3);  // it has no inside
  const MeshReport moebius = reportOn(test::moebiusStrip(24, 3));
  QVERIFY(!moebius.closed && moebius.manifold && !moebius.oriented);
  QCOMPARE(moebius.boundaryEdges, std::size_t{48});
  QCOMPARE(moebius.nonManifoldVertices, std::size_t{0});
  QCOMPARE(moebius.oneSidedPieces, std::size_t{1});
  QCOMPARE(moebius.eulerCharacteristic, 0l);
  QVERIFY(!moebius.volumeMm3);
  QCOMPARE(moebius.loops.size(), std::size_t{1});
  QCOMPARE(moebius.loops[0].edges, std::size_t{48});
  QVERIFY(moebius.loops[0].isSheetBoundary);  // no hole to be filled
  // The area of its parametrisation, by the midpoint rule.
  double area = 0.0;
  constexpr int kSteps = 1000;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double u = 2.0 * M_PI * (i + 0.5) / kSteps, v = 0.8 * (j + 0.5) / kSteps - 0.4;
      area += std::hypot(1.0 + v * std::cos(u / 2.0), 0.5 * v) * 2.0 * M_PI * 0.8 / kSteps / kSteps;
    }
  }
  QVERIFY(std::abs(reportOn(test::moebiusStrip(400, 40)).areaMm2 - area) < 1e-3 * area);
  TriangleSoup three = test::moebiusStrip(24, 3);  // with a ball, a sheet and the projective plane
  test::append(three, test::moved(test::icosphere(2), Vec3(5, 0, 0)));
  test::append(three, test::moved(test::disc(12, 3), Vec3(10, 0, 0)));
  test::append(three, test::moved(test::sphereWithCrossCap(2), Vec3(15, 0, 0)));
  const MeshReport several = reportOn(three);
  QCOMPARE(several.oneSidedPieces, std::size_t{2});
  QCOMPARE(several.loops.size(), std::size_t{2});
  QCOMPARE(several.eulerCharacteristic, 0l + 2l + 1l + 1l);
}

// Sizes at which squares of areas vanish or overflow. Powers of two, so that all digits stay.
void MeshReportTest::extremeSizes() {
  TriangleSoup soup = test::withHole(test::cylinder(24, 9, 2.0, 5.0, true), Vec3(2, 0, 2.5), 0.9);
  test::append(soup, test::moved(test::moebiusStrip(24, 3), Vec3(10, 0, 0)));
  const MeshReport here = reportOn(soup);
  for (const int exponent : {-332, -100, 100, 332}) {
    const MeshReport there = reportOn(test::moved(soup, Vec3::Zero(), std::ldexp(1.0, exponent)));
    QCOMPARE(there.loops.size(), here.loops.size());
    for (std::size_t i = 0; i < here.loops.size(); ++i) {
      QCOMPARE(there.loops[i].isSheetBoundary, here.loops[i].isSheetBoundary);
      QVERIFY(near(there.loops[i].lengthMm, std::ldexp(here.loops[i].lengthMm, exponent)));
      QVERIFY(near(there.loops[i].areaMm2, std::ldexp(here.loops[i].areaMm2, 2 * exponent)));
    }
    QVERIFY(near(there.areaMm2, std::ldexp(here.areaMm2, 2 * exponent)));
    QCOMPARE(there.selfIntersectingPairs, here.selfIntersectingPairs);
    QCOMPARE(there.degenerateFaces, here.degenerateFaces);
    QVERIFY(near(reportOn(test::cube(std::ldexp(3.0, exponent))).volumeMm3.value(), std::ldexp(27.0, 3 * exponent)));
  }
}

void MeshReportTest::touchingCubes() {
  const MeshReport edge = reportOn(test::twoCubesSharingAnEdge());
  QCOMPARE(edge.vertices, std::size_t{14});
  QCOMPARE(edge.components, std::size_t{1});
  QVERIFY(edge.closed && !edge.manifold && edge.oriented);
  QCOMPARE(edge.nonManifoldEdges, std::size_t{1});
  QCOMPARE(edge.nonManifoldVertices, std::size_t{0});  // the cubes hang together through the edge
  QCOMPARE(edge.inconsistentEdges, std::size_t{2});    // used twice in either direction
  QVERIFY(near(edge.volumeMm3.value(), 2.0));
  const MeshReport vertex = reportOn(test::twoCubesSharingAVertex());
  QCOMPARE(vertex.vertices, std::size_t{15});
  QCOMPARE(vertex.components, std::size_t{1});
  QVERIFY(vertex.closed && !vertex.manifold && vertex.oriented && !vertex.isSound());
  QCOMPARE(vertex.nonManifoldVertices, std::size_t{1});
}

void MeshReportTest::innerWall() {
  const MeshReport r = reportOn(test::boxWithInnerWall());
  QVERIFY(r.closed && !r.manifold && !r.isSound());
  QCOMPARE(r.nonManifoldEdges, std::size_t{4});
  QVERIFY(r.loops.empty());
}

void MeshReportTest::degenerateFaces() {
  TriangleSoup s = test::cube();
  s.points.push_back(Vec3(0.5, 0, 0));
  s.triangles.push_back({0, 8, 1});  // a needle
  s.triangles.push_back({2, 2, 3});
  s.triangles.push_back({5, 5, 5});
  const MeshReport r = reportOn(s);
  QCOMPARE(r.triangles, std::size_t{15});
  QCOMPARE(r.degenerateFaces, std::size_t{3});
  QCOMPARE(r.boundaryEdges, std::size_t{2});     // the needle's short edges
  QCOMPARE(r.nonManifoldEdges, std::size_t{1});  // its long one
}

void MeshReportTest::duplicates() {
  TriangleSoup s = test::cube();
  s.triangles.push_back(s.triangles[3]);
  s.triangles.push_back({s.triangles[3][1], s.triangles[3][0], s.triangles[3][2]});
  s.triangles.push_back(s.triangles[5]);
  const MeshReport r = reportOn(s);
  QCOMPARE(r.duplicateFaces, std::size_t{3});
  QCOMPARE(r.nonManifoldEdges, test::countEdges(s).nonManifold);
  QCOMPARE(*r.selfIntersectingPairs, test::meetingPairs(s));
}

void MeshReportTest::reversedFace() {
  TriangleSoup s = test::icosphere(1);
  std::swap(s.triangles[9][0], s.triangles[9][1]);
  const MeshReport r = reportOn(s);
  QVERIFY(r.closed && r.manifold && !r.oriented);
  QCOMPARE(r.inconsistentEdges, std::size_t{3});
  QVERIFY(!r.volumeMm3);  // neighbours disagree about the inside
}

void MeshReportTest::selfIntersections() {
  TriangleSoup s = test::icosphere(1);
  test::append(s, test::moved(test::icosphere(1), Vec3(0.7, 0.1, 0.2)));
  QVERIFY(test::meetingPairs(s) > 0);
  QCOMPARE(reportOn(s).selfIntersectingPairs.value(), test::meetingPairs(s));
  QVERIFY(!handwheel::reportOn(s, SelfIntersections::Skip).selfIntersectingPairs);
}

// With a vertex that two bodies share, a degenerate triangle apart, and a point that no triangle uses.
void MeshReportTest::samePiecesAsTheListOfDefects() {
  TriangleSoup soup = test::twoCubesSharingAVertex();
  test::append(soup, test::cube(1.0, Vec3(9, 0, 0)));
  test::append(soup, TriangleSoup{{{20, 0, 0}, {21, 0, 0}, {30, 0, 0}}, {{0, 0, 1}}});
  const std::size_t pieces = reportOn(soup).components;
  QCOMPARE(pieces, std::size_t{3});
  QCOMPARE(findDefects(buildMesh(soup).mesh).components.size(), pieces);
}

void MeshReportTest::cancelled() {
  JobState job;
  job.cancelled = true;
  const MeshReport r = handwheel::reportOn(test::icosphere(4), SelfIntersections::Count, Progress(job));
  QVERIFY(!r.selfIntersectingPairs);
}

void MeshReportTest::empty() {
  const MeshReport r = reportOn(TriangleSoup{});
  QCOMPARE(r.triangles + r.vertices + r.components, std::size_t{0});
  QVERIFY(!r.closed && !r.isSound());
  QVERIFY(!r.volumeMm3);
}

void MeshReportTest::soups() {
  QVERIFY(rc::check("figures of any soup", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const TriangleSoup s =
        test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 40), *rc::gen::inRange<std::uint32_t>(1, 6));
    const MeshReport r = reportOn(s);
    const test::Edges edges = test::countEdges(s);
    RC_ASSERT(r.triangles == s.triangles.size());
    RC_ASSERT(r.vertices == test::allCoordinates(s).size());
    RC_ASSERT(r.boundaryEdges == edges.border);
    RC_ASSERT(r.nonManifoldEdges == edges.nonManifold);
    RC_ASSERT(r.inconsistentEdges == edges.inconsistent);
    RC_ASSERT(r.closed == (edges.border == 0));
    RC_ASSERT(r.manifold == (edges.nonManifold == 0 && r.nonManifoldVertices == 0));
    RC_ASSERT(r.oriented || edges.inconsistent > 0);
    if (edges.nonManifold == 0) RC_ASSERT(r.oriented == (edges.inconsistent == 0));
    RC_ASSERT(r.selfIntersectingPairs == test::meetingPairs(s));
    std::size_t inLoops = 0;
    for (const LoopReport& loop : r.loops) inLoops += loop.edges;
    RC_ASSERT(inLoops == edges.border);
  }));
}

// The window takes the state from the list of defects, where opening has reversed faces so that neighbours agree; the
// command line takes it from the report, with the directions of the file.
void MeshReportTest::sameStateAsTheListOfDefects() {
  QVERIFY(rc::check("state of any soup", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const TriangleSoup s =
        test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 40), *rc::gen::inRange<std::uint32_t>(1, 6));
    const MeshReport report = reportOn(s);
    const MeshState state = findDefects(buildMesh(s).mesh).state(report.selfIntersectingPairs);
    RC_ASSERT(state.closed == report.closed);
    RC_ASSERT(state.manifold == report.manifold);
    RC_ASSERT(state.oriented || !report.oriented);
    RC_ASSERT(state.components == report.components);
  }));
}

HANDWHEEL_TEST(MeshReportTest)
#include "MeshReportTest.moc"
