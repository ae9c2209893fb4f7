// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/QuadricDecimation.h"

#include "DoubledEdges.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/measure/Deviation.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <numbers>

using namespace handwheel;

class QuadricDecimationTest : public QObject {
  Q_OBJECT

 private slots:
  void toACount();
  void saysTheDistance();
  void flatFacesGoFirst();
  void anyPositionAndUnit();
  void bordersStay();
  void creasesStay();
  void sharedPositionsAndSeamsStay();
  void hubsStay();
  void refused();
  void cancelled();
  void anyShape();
};

namespace {

constexpr DecimationMethod kQuadric = DecimationMethod::Quadric;

HalfEdgeMesh meshOfSoup(const TriangleSoup& soup) {
  return buildMesh(soup).mesh;
}

double distanceBetween(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  const auto d = deviation(a, b, {.samples = 50'000});
  if (!d) qFatal("no deviation");
  return d->hausdorff();
}

// A cube of side n whose sides are n × n cells.
TriangleSoup cellCube(std::uint32_t n) {
  TriangleSoup s;
  for (int k = 0; k < 3; ++k) {
    for (const double side : {0.0, double(n)}) {
      const TriangleSoup sheet = test::grid(n + 1, n + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
        Vec3 p = Vec3::Constant(side);
        p[(k + 1) % 3] = i;
        p[(k + 2) % 3] = j;
        return p;
      });
      test::append(s, side > 0.0 ? sheet : test::turnedOver(sheet));
    }
  }
  return s;
}

std::set<test::Coordinates> positionsOf(const HalfEdgeMesh& mesh) {
  return test::allCoordinates(mesh.compact().soup);
}

}  // namespace

// It takes vertices away and moves none.
void QuadricDecimationTest::toACount() {
  const HalfEdgeMesh original = meshOfSoup(test::bumpySphere(4));
  for (std::size_t faces : {1000u, 321u, 60u}) {
    HalfEdgeMesh mesh = original;
    const DecimationReport report = decimate(mesh, {.faces = faces, .method = kQuadric});
    QCOMPARE(report.refusal, OpenMeshRefusal::None);
    QCOMPARE(report.facesAfter, faces - faces % 2);  // a closed surface loses two at a time
    QCOMPARE(mesh.liveFaceCount(), report.facesAfter);
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(test::countEdges(mesh).sound());
    QCOMPARE(test::eulerCharacteristic(mesh), 2l);
    for (Vertex v = 0; v < original.vertexSlots(); ++v) QVERIFY(test::sameBits(mesh.position(v), original.position(v)));
  }
}

// The distance agrees with a measurement with other samples; it is zero if only flat faces are joined.
void QuadricDecimationTest::saysTheDistance() {
  const HalfEdgeMesh before = meshOfSoup(test::bumpySphere(4));
  for (const DecimationMethod method : {kQuadric, DecimationMethod::Bounded}) {
    HalfEdgeMesh mesh = before;
    const DecimationReport silent = decimate(mesh, {.faces = 400, .method = method});
    QVERIFY(!silent.largestDistance);
    mesh = before;
    const DecimationReport report = decimate(mesh, {.faces = 400, .method = method, .measureDistance = true});
    QVERIFY(report.largestDistance);
    const double measured = distanceBetween(mesh, before);
    QVERIFY(measured > 0.0);
    QVERIFY(std::abs(*report.largestDistance - measured) < 0.05 * measured);
  }
  HalfEdgeMesh same = meshOfSoup(cellCube(4));
  const DecimationReport flat = decimate(same, {.faces = 12, .method = kQuadric, .measureDistance = true});
  QVERIFY(flat.largestDistance && *flat.largestDistance < 1e-12);
}

// Rounding must not hide that they cost nothing.
void QuadricDecimationTest::flatFacesGoFirst() {
  HalfEdgeMesh mesh = meshOfSoup(cellCube(12));
  decimate(mesh, {.faces = 60, .method = kQuadric});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{60});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1728.0) < 1e-9);
  QVERIFY(std::abs(test::area(mesh.compact().soup) - 864.0) < 1e-9);
}

void QuadricDecimationTest::anyPositionAndUnit() {
  const auto found = [](double shift, double scale) {
    const HalfEdgeMesh original = meshOfSoup(test::moved(test::icosphere(4), Vec3::Constant(shift), scale));
    HalfEdgeMesh mesh = original;
    decimate(mesh, {.faces = 500, .method = kQuadric});
    return mesh.liveFaceCount() == 500 ? distanceBetween(mesh, original) / scale : INFINITY;
  };
  const double plain = found(0.0, 1.0);
  // Half an edge of an even tessellation, squared, over the radius; no vertex is placed best, so twice that.
  QVERIFY(plain < 16.0 * std::numbers::pi / (std::sqrt(3.0) * 500.0));
  for (const auto& [shift, scale] : {std::pair(1e6, 1.0), std::pair(0.0, 1e-9), std::pair(0.0, 1e12)})
    QVERIFY(found(shift, scale) < 1.2 * plain);
}

void QuadricDecimationTest::bordersStay() {
  const HalfEdgeMesh original = meshOfSoup(test::sphereWithHoles(4, 3, 0.3));
  HalfEdgeMesh mesh = original;
  decimate(mesh, {.faces = 800, .keepBorders = true, .method = kQuadric});
  QVERIFY(mesh.liveFaceCount() <= 800);
  QCOMPARE(validate(mesh), std::string());
  const auto rims = [](const HalfEdgeMesh& m) {
    std::set<std::pair<test::Coordinates, test::Coordinates>> edges;
    for (HalfEdge h = 0; h < m.halfEdgeSlots(); ++h)
      if (m.isBorder(h))
        edges.insert({test::coordinates(m.position(m.from(h))), test::coordinates(m.position(m.to(h)))});
    return edges;
  };
  QVERIFY(rims(mesh) == rims(original));
}

// All edges of a cube of side 8 stay: corners, 96 of length, and nothing else is sharp.
void QuadricDecimationTest::creasesStay() {
  HalfEdgeMesh mesh = meshOfSoup(cellCube(8));
  decimate(mesh, {.faces = 12, .creaseAngle = std::numbers::pi / 4.0, .method = kQuadric});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(mesh.liveFaceCount() < 100);
  double length = 0.0;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!mesh.isProper(HalfEdgeMesh::face(h)) || h > mesh.opposite(h)) continue;
    const auto normal = [&](HalfEdge g) {
      const TrianglePoints t = mesh.points(HalfEdgeMesh::face(g));
      return Vec3((t[1] - t[0]).cross(t[2] - t[0]).normalized());
    };
    const double cosine = normal(h).dot(normal(mesh.opposite(h)));
    QVERIFY(std::abs(cosine) < 1e-12 || std::abs(cosine - 1.0) < 1e-12);
    if (cosine < 0.5) length += (mesh.position(mesh.from(h)) - mesh.position(mesh.to(h))).norm();
  }
  QVERIFY(std::abs(length - 96.0) < 1e-9);
  const auto positions = positionsOf(mesh);
  for (int i = 0; i < 8; ++i) QVERIFY(positions.contains({8.0 * (i & 1), 8.0 * ((i >> 1) & 1), 8.0 * ((i >> 2) & 1)}));
}

void QuadricDecimationTest::sharedPositionsAndSeamsStay() {
  for (const TriangleSoup& soup : {test::twoCubesSharingAnEdge(), test::twoCubesSharingAVertex(),
                                   test::boxWithInnerWall(), test::moebiusStrip(30, 6), test::kleinBottle(30, 20)}) {
    HalfEdgeMesh mesh = meshOfSoup(soup);
    const auto count = [](const HalfEdgeMesh& m) {
      std::map<test::Coordinates, int> positions;
      std::set<Vertex> used;
      for (Face f = 0; f < m.faceSlots(); ++f)
        if (m.isProper(f)) used.insert(m.triangle(f).begin(), m.triangle(f).end());
      for (Vertex v : used) ++positions[test::coordinates(m.position(v))];
      return positions;
    };
    const auto seams = test::countSeams(mesh);
    const auto before = count(mesh);
    const DecimationReport report = decimate(mesh, {.method = kQuadric});
    QCOMPARE(report.refusal, OpenMeshRefusal::None);
    const auto after = count(mesh);
    QCOMPARE(validate(mesh), std::string());
    QCOMPARE(test::countSeams(mesh), seams);
    for (const auto& [position, n] : before)
      if (n > 1) QCOMPARE(after.at(position), n);
  }
}

void QuadricDecimationTest::hubsStay() {
  HalfEdgeMesh wheel = meshOfSoup(test::cylinder(3000, 1, 1.0, 1.0, true));
  decimate(wheel, {.faces = 200, .method = kQuadric});
  QCOMPARE(validate(wheel), std::string());
  QVERIFY(positionsOf(wheel).contains({0.0, 0.0, 0.0}) && positionsOf(wheel).contains({0.0, 0.0, 1.0}));
  QVERIFY2(wheel.liveFaceCount() <= 200, qPrintable(QString::number(wheel.liveFaceCount())));
}

void QuadricDecimationTest::refused() {
  const HalfEdgeMesh original = test::doubledEdges();
  HalfEdgeMesh mesh = original;
  const DecimationReport report = decimate(mesh, {.faces = 1, .method = kQuadric});
  QCOMPARE(report.refusal, OpenMeshRefusal::DoubleEdge);
  QCOMPARE(report.facesAfter, report.facesBefore);
  QVERIFY(test::sameMesh(mesh, original));
}

void QuadricDecimationTest::cancelled() {
  const HalfEdgeMesh original = meshOfSoup(test::bumpySphere(3));
  HalfEdgeMesh mesh = original;
  JobState job;
  job.cancelled = true;
  QVERIFY(decimate(mesh, {.faces = 10, .method = kQuadric}, Progress(job)).cancelled);
  QVERIFY(test::sameMesh(mesh, original));
  // In the midst of it, too: once so much work is done.
  std::size_t done = 0, midst = 0;
  for (std::size_t effort = 1024; done < 3; effort += effort / 8) {
    WorkBudget budget(effort);
    mesh = original;
    const bool isCancelled = decimate(mesh, {.faces = 10, .method = kQuadric}, Progress().within(budget)).cancelled;
    QCOMPARE(test::sameMesh(mesh, original), isCancelled);
    ++(isCancelled ? midst : done);
  }
  QVERIFY(midst > 10);
}

void QuadricDecimationTest::anyShape() {
  QVERIFY(rc::check("valid, of the same topology, with no new degenerate face", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const std::vector<TriangleSoup> shapes{test::bumpySphere(2),           test::torus(20, 10),
                                           test::moebiusStrip(20, 4),      test::sphereWithHoles(3, 4, 0.3),
                                           test::annulus(20, 4, 1.0, 2.0), test::randomBlocks(random, 12, 3),
                                           test::randomSoup(random, 60, 4)};
    const HalfEdgeMesh original = meshOfSoup(*rc::gen::elementOf(shapes));
    HalfEdgeMesh mesh = original;
    const auto flag = [] { return *rc::gen::arbitrary<bool>(); };
    DecimationOptions options{.faces = *rc::gen::inRange<std::size_t>(0, 200), .keepBorders = flag()};
    options.method = kQuadric;
    if (flag()) options.creaseAngle = 0.7;
    const auto degenerate = [](const HalfEdgeMesh& m) {
      std::size_t n = 0;
      for (Face f = 0; f < m.faceSlots(); ++f) n += m.isLive(f) && isDegenerate(m.points(f));
      return n;
    };
    const DecimationReport report = decimate(mesh, options);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(report.facesAfter == mesh.liveFaceCount());
    RC_ASSERT(test::eulerCharacteristic(mesh) == test::eulerCharacteristic(original));
    RC_ASSERT(degenerate(mesh) <= degenerate(original));
    if (report.refusal != OpenMeshRefusal::None) RC_ASSERT(test::sameMesh(mesh, original));
  }));
}

HANDWHEEL_TEST(QuadricDecimationTest)
#include "QuadricDecimationTest.moc"
