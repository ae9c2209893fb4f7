// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/SchemeSubdivision.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;

class SchemeSubdivisionTest : public QObject {
  Q_OBJECT

 private slots:
  void counts_data();
  void counts();
  void openEdges();
  void limitsOfLoop();
  void limitsOfSqrt3();
  void butterflyInterpolates();
  void butterflyHasCubicPrecision();
  void midpointsLeaveTheSurface();
  void midpointsOfSeamsAndNeedles();
  void hubs();
  void tooMuch();
  void refused();
  void cancelled();
  void anyShape();
};

namespace {

constexpr SubdivisionScheme kLoop = SubdivisionScheme::Loop, kSqrt3 = SubdivisionScheme::Sqrt3,
                            kButterfly = SubdivisionScheme::Butterfly;

HalfEdgeMesh surfaceOf(const TriangleSoup& soup) {
  return buildMesh(soup).mesh;
}

// The weights w that p + (mean - p) · w has of the mean of n neighbours: the point of the limit surface that a vertex
// goes to. It must be the same before and after a step.
double limitWeightOfLoop(std::size_t n) {
  const double c = 0.375 + 0.25 * std::cos(2.0 * std::numbers::pi / double(n)), beta = (0.625 - c * c) / double(n);
  return double(n) / (3.0 / (8.0 * beta) + double(n));
}

double limitWeightOfSqrt3(std::size_t n) {
  const double alpha = (4.0 - 2.0 * std::cos(2.0 * std::numbers::pi / double(n))) / 9.0;
  return 3.0 * alpha / (1.0 + 3.0 * alpha);
}

// By vertex, of a closed mesh.
std::vector<Vec3> limitPositions(const HalfEdgeMesh& mesh, double (*weight)(std::size_t)) {
  std::vector<Vec3> result(mesh.vertexSlots(), Vec3::Zero());
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    const auto fan = mesh.fan(h);
    Vec3 mean = Vec3::Zero();
    for (const HalfEdge g : fan) mean += mesh.position(mesh.to(g)) / double(fan.size());
    const Vec3& p = mesh.position(mesh.from(h));
    result[mesh.from(h)] = p + weight(fan.size()) * (mean - p);
  }
  return result;
}

bool keepsLimits(SubdivisionScheme scheme, double (*weight)(std::size_t)) {
  for (const TriangleSoup& soup : {test::torus(12, 8), test::icosphere(0), test::bumpySphere(2), test::cube()}) {
    HalfEdgeMesh mesh = surfaceOf(soup);
    const auto before = limitPositions(mesh, weight);
    if (!subdivideAll(mesh, {scheme, 2}).isDone()) return false;
    const auto after = limitPositions(mesh, weight);
    for (std::size_t v = 0; v < before.size(); ++v)
      if (!((before[v] - after[v]).norm() < 1e-13)) return false;
  }
  return true;
}

}  // namespace

void SchemeSubdivisionTest::counts_data() {
  QTest::addColumn<int>("scheme");
  QTest::newRow("loop") << int(kLoop);
  QTest::newRow("sqrt3") << int(kSqrt3);
  QTest::newRow("butterfly") << int(kButterfly);
}

void SchemeSubdivisionTest::counts() {
  QFETCH(int, scheme);
  for (const TriangleSoup& soup : {test::tetrahedron(), test::cube(), test::torus(12, 8), test::icosphere(2)}) {
    const HalfEdgeMesh before = surfaceOf(soup);
    std::size_t faces = before.liveFaceCount();
    for (int times = 0; times < 4; ++times, faces *= SubdivisionScheme(scheme) == kSqrt3 ? 3 : 4) {
      HalfEdgeMesh mesh = before;
      QVERIFY(subdivideAll(mesh, {SubdivisionScheme(scheme), times}).isDone());
      QCOMPARE(mesh.liveFaceCount(), faces);
      QCOMPARE(validate(mesh), std::string());
      QVERIFY(test::countEdges(mesh).sound());
      QCOMPARE(test::eulerCharacteristic(mesh), test::eulerCharacteristic(before));
      if (times == 0) QVERIFY(test::sameMesh(mesh, before));
    }
  }
}

// Loop and butterfly halve open edges; √3 cuts each in three at every other step. The straight sides of a square stay.
void SchemeSubdivisionTest::openEdges() {
  const HalfEdgeMesh before =
      surfaceOf(test::grid(6, 6, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.0); }));
  const std::size_t border = test::countBorder(before), faces = before.liveFaceCount();
  for (const auto& [scheme, open] :
       {std::pair(kLoop, 4 * border), std::pair(kSqrt3, 3 * border), std::pair(kButterfly, 4 * border)}) {
    HalfEdgeMesh mesh = before;
    QVERIFY(subdivideAll(mesh, {scheme, 2}).isDone());
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(test::countBorder(mesh), open);
    QCOMPARE(mesh.liveFaceCount(), faces * (scheme == kSqrt3 ? 9 : 16));
    QCOMPARE(test::eulerCharacteristic(mesh), 1l);
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) QCOMPARE(mesh.position(mesh.from(h)).z(), 0.0);
  }
}

void SchemeSubdivisionTest::limitsOfLoop() {
  QVERIFY(keepsLimits(kLoop, limitWeightOfLoop));
}

void SchemeSubdivisionTest::limitsOfSqrt3() {
  QVERIFY(keepsLimits(kSqrt3, limitWeightOfSqrt3));
}

void SchemeSubdivisionTest::butterflyInterpolates() {
  for (const TriangleSoup& soup : {test::bumpySphere(2), test::torus(12, 8), test::sphereWithHoles(3, 4, 0.3),
                                   test::cylinder(100, 1, 1.0, 1.0, true)}) {
    const HalfEdgeMesh before = surfaceOf(soup);
    HalfEdgeMesh mesh = before;
    QVERIFY(subdivideAll(mesh, {kButterfly, 2}).isDone());
    for (Vertex v = 0; v < before.vertexSlots(); ++v) QVERIFY(test::sameBits(mesh.position(v), before.position(v)));
  }
}

// The eight points of a regular edge reproduce cubic polynomials: odd ones vanish by symmetry, and the squares cancel.
void SchemeSubdivisionTest::butterflyHasCubicPrecision() {
  const auto f = [](double x, double y) {
    return 0.7 * x * x * x - 1.1 * x * x * y + 0.4 * x * y * y + 0.9 * y * y * y - x * x + 2.0 * x * y + y * y - x +
           3.0;
  };
  HalfEdgeMesh mesh = surfaceOf(test::grid(
      9, 9, false, false, [&](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, f(double(i), double(j))); }));
  QVERIFY(subdivideAll(mesh, {kButterfly, 1}).isDone());
  int inner = 0;
  for (Vertex v = 81; v < mesh.vertexSlots(); ++v) {
    const Vec3& p = mesh.position(v);
    if (p.head<2>().minCoeff() < 2.0 || p.head<2>().maxCoeff() > 6.0) continue;
    QVERIFY(std::abs(p.z() - f(p.x(), p.y())) < 1e-10);
    ++inner;
  }
  QCOMPARE(inner, 5 * 4 * 2 + 4 * 4);  // edges of the 4 × 4 cells: along x, along y, and diagonals
}

// Area, volume, openness and the positions of all vertices stay.
void SchemeSubdivisionTest::midpointsLeaveTheSurface() {
  for (const TriangleSoup& soup :
       {test::icosphere(2), test::bumpySphere(2), test::disc(12, 3), test::torus(12, 8), test::annulus(16, 3, 1, 2)}) {
    const HalfEdgeMesh before = surfaceOf(soup);
    HalfEdgeMesh mesh = before;
    QVERIFY(subdivideAll(mesh, {SubdivisionScheme::Midpoint, 2}).isDone());
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(mesh.liveFaceCount(), 16 * before.liveFaceCount());
    const TriangleSoup after = mesh.compact().soup;
    QVERIFY(std::abs(test::area(after) - test::area(soup)) < 1e-9 * test::area(soup));
    QVERIFY(std::abs(test::volume(after) - test::volume(soup)) < 1e-9 * test::area(soup));
    QCOMPARE(test::countBorder(mesh), 4 * test::countBorder(before));
    QCOMPARE(test::eulerCharacteristic(after), test::eulerCharacteristic(soup));
    for (Vertex v = 0; v < before.vertexSlots(); ++v) QVERIFY(mesh.position(v) == before.position(v));
  }
}

// OpenMesh refuses seams; here both sides get the same points. A mesh of edges that the numbers cannot halve is
// refused; one such edge stays whole, and all others are halved.
void SchemeSubdivisionTest::midpointsOfSeamsAndNeedles() {
  HalfEdgeMesh cubes = surfaceOf(test::twoCubesSharingAnEdge());
  QVERIFY(subdivideAll(cubes, {SubdivisionScheme::Midpoint, 1}).isDone());
  QCOMPARE(test::countEdges(cubes).border, std::size_t{0});
  QCOMPARE(test::countEdges(cubes).nonManifold, std::size_t{2});
  const double next = std::nextafter(1.0f, 2.0f);
  const HalfEdgeMesh before = surfaceOf({{{1, 1, 0}, {1, next, 0}, {next, next, 0}}, {{0, 1, 2}}});
  HalfEdgeMesh mesh = before;
  QVERIFY(subdivideAll(mesh, {SubdivisionScheme::Midpoint, 1}, {.numbers = NumberType::Float32}).failure ==
          SubdivisionFailure::TooFine);
  QVERIFY(test::sameMesh(mesh, before));
  QVERIFY(subdivideAll(mesh, {SubdivisionScheme::Midpoint, 1}).isDone());

  TriangleSoup ball = test::moved(test::icosphere(2), Vec3::Constant(3.0));
  for (Vec3& p : ball.points) p = rounded(p, NumberType::Float32);
  const Triangle t = ball.triangles.front();
  ball.points[t[1]] = ball.points[t[0]];
  ball.points[t[1]].x() = std::nextafter(float(ball.points[t[0]].x()), 10.0f);
  HalfEdgeMesh needle = surfaceOf(ball);
  const std::size_t faces = needle.liveFaceCount();
  QVERIFY(subdivideAll(needle, {SubdivisionScheme::Midpoint, 1}, {.numbers = NumberType::Float32}).isDone());
  QCOMPARE(validate(needle), std::string());
  QVERIFY(test::countEdges(needle).sound());
  QVERIFY(needle.liveFaceCount() <= 4 * faces - 2 && needle.liveFaceCount() >= 4 * (faces - 2));
  QVERIFY(std::abs(test::volume(needle.compact().soup) - test::volume(ball)) < 1e-5);
}

// OpenMesh has tables up to 50 neighbours, without a check.
void SchemeSubdivisionTest::hubs() {
  const HalfEdgeMesh before = surfaceOf(test::cylinder(5000, 1, 1.0, 1.0, true));
  const Box box = boundsOf(before);
  for (const SubdivisionScheme scheme : {kLoop, kSqrt3}) {
    HalfEdgeMesh mesh = before;
    QVERIFY(subdivideAll(mesh, {scheme, 1}).isDone());
    QCOMPARE(validate(mesh), std::string());
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) QVERIFY(box.contains(mesh.position(v)));  // convex weights
  }
  HalfEdgeMesh mesh = before;
  QCOMPARE(subdivideAll(mesh, {kButterfly, 1}).refusal, OpenMeshRefusal::Hub);
  QVERIFY(test::sameMesh(mesh, before));
}

void SchemeSubdivisionTest::tooMuch() {
  const HalfEdgeMesh before = surfaceOf(test::cube());
  for (const SubdivisionScheme scheme : {kLoop, kSqrt3, kButterfly}) {
    HalfEdgeMesh mesh = before;
    const std::size_t after = 12 * (scheme == kSqrt3 ? 27 : 64);
    QCOMPARE(subdivideAll(mesh, {scheme, 3}, {.mostFaces = after - 1}).failure, SubdivisionFailure::TooManyFaces);
    QCOMPARE(subdivideAll(mesh, {scheme, 1000}).failure, SubdivisionFailure::TooManyFaces);
    QVERIFY(test::sameMesh(mesh, before));
    QVERIFY(subdivideAll(mesh, {scheme, 3}, {.mostFaces = after}).isDone());
  }
  // No float lies between these, and no double beyond those.
  HalfEdgeMesh fine = surfaceOf(test::moved(test::cube(0x1p-23), Vec3::Constant(1.0)));
  QCOMPARE(subdivideAll(fine, {kButterfly, 1}, {.numbers = NumberType::Float32}).failure, SubdivisionFailure::TooFine);
  HalfEdgeMesh huge = surfaceOf(test::cube(1.7e308));
  QCOMPARE(subdivideAll(huge, {kLoop, 1}).failure, SubdivisionFailure::TooFine);
}

void SchemeSubdivisionTest::refused() {
  const HalfEdgeMesh before = surfaceOf(test::boxWithInnerWall());
  QVERIFY(test::countSeams(before) > 0);
  HalfEdgeMesh mesh = before;
  QCOMPARE(subdivideAll(mesh, {kLoop, 1}).refusal, OpenMeshRefusal::Seam);
  QVERIFY(test::sameMesh(mesh, before));
}

void SchemeSubdivisionTest::cancelled() {
  const HalfEdgeMesh before = surfaceOf(test::icosphere(3));
  HalfEdgeMesh mesh = before;
  JobState job;
  job.cancelled = true;
  for (const SubdivisionScheme scheme : {kLoop, kSqrt3, kButterfly}) {
    QCOMPARE(subdivideAll(mesh, {scheme, 1}, {.progress = Progress(job)}).failure, SubdivisionFailure::Cancelled);
    QVERIFY(test::sameMesh(mesh, before));
  }
  // In the midst of a scheme, too: once so much work is done.
  for (const SubdivisionScheme scheme : {kLoop, kSqrt3, kButterfly}) {
    std::size_t done = 0, midst = 0;
    for (std::size_t effort = 1024; done == 0; effort += effort / 8) {
      WorkBudget budget(effort);
      mesh = before;
      const SchemeOutcome outcome = subdivideAll(mesh, {scheme, 2}, {.progress = Progress().within(budget)});
      QVERIFY(outcome.isDone() || outcome.failure == SubdivisionFailure::Cancelled);
      QCOMPARE(test::sameMesh(mesh, before), !outcome.isDone());
      ++(outcome.isDone() ? done : midst);
    }
    QVERIFY(midst > 10);
  }
}

void SchemeSubdivisionTest::anyShape() {
  QVERIFY(rc::check("valid and of the same topology, or unchanged", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const std::vector<TriangleSoup> shapes{test::bumpySphere(1),           test::torus(8, 5),
                                           test::moebiusStrip(20, 4),      test::sphereWithHoles(2, 3, 0.3),
                                           test::annulus(20, 2, 1.0, 2.0), test::randomBlocks(random, 8, 3),
                                           test::randomSoup(random, 30, 4)};
    const HalfEdgeMesh before = surfaceOf(*rc::gen::elementOf(shapes));
    HalfEdgeMesh mesh = before;
    const auto scheme = *rc::gen::element(kLoop, kSqrt3, kButterfly);
    const int times = *rc::gen::inRange(0, 4);
    const SchemeOutcome outcome = subdivideAll(mesh, {scheme, times});
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::eulerCharacteristic(mesh) == test::eulerCharacteristic(before));
    if (!outcome.isDone()) RC_ASSERT(test::sameMesh(mesh, before));
    if (outcome.isDone())
      RC_ASSERT(mesh.liveFaceCount() == before.liveFaceCount() * std::size_t(std::pow(facesOfOne(scheme), times)));
  }));
}

HANDWHEEL_TEST(SchemeSubdivisionTest)
#include "SchemeSubdivisionTest.moc"
