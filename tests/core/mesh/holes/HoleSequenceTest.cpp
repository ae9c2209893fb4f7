// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/HoleSequence.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

namespace {

// Two balls of radius 1 without their tops, mouth to mouth.
HalfEdgeMesh balls(double gap) {
  const TriangleSoup lower = test::sphereWithoutCap(4, 0.9);
  TriangleSoup upper = test::turnedOver(lower);
  double mouth = -1.0;
  for (const test::Coordinates& p : test::allCoordinates(lower)) mouth = std::max(mouth, p[2]);
  for (Vec3& p : upper.points) p.z() = 2.0 * mouth + gap - p.z();
  TriangleSoup both = lower;
  test::append(both, upper);
  return buildMesh(both).mesh;
}

}  // namespace

class HoleSequenceTest : public QObject {
  Q_OBJECT

 private slots:
  void farFromEachOther();
  void oneInTheWayOfTheOther();
  void oneWithANeedleInTheWayOfTheOther();
  void nothingToFill();
  void cancelled();
};

void HoleSequenceTest::farFromEachOther() {
  HalfEdgeMesh mesh = balls(2.0);
  const auto loops = findBoundaryLoops(mesh);
  const auto fills = fillHoles(mesh, loops, {});
  QCOMPARE(fills.size(), std::size_t(2));
  for (const HoleFill& fill : fills) QCOMPARE(fill.attempt.patch.method, FillMethod::Fair);
  QVERIFY(test::countEdges(mesh).sound());
}

// The cap that continues one ball stands in the mouth of the other: after it no patch fits there.
void HoleSequenceTest::oneInTheWayOfTheOther() {
  HalfEdgeMesh mesh = balls(0.02);
  const auto loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t(2));
  HoleFiller oneByOne(mesh);
  const FillAttempt first = oneByOne.propose(loops[0], {});
  QCOMPARE(first.failure, FillFailure::None);
  oneByOne.accept(loops[0], first.patch);
  QCOMPARE(oneByOne.propose(loops[1], {}).failure, FillFailure::SelfIntersecting);

  const auto fills = fillHoles(mesh, loops, {});
  for (const HoleFill& fill : fills) QCOMPARE(fill.attempt.failure, FillFailure::None);
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(countSelfIntersections(mesh, NumberType::Float64), std::size_t(0));
  QCOMPARE(validate(mesh), std::string());
}

// A needle along the obstructing hole changes the reason, but the hole is tried again all the same.
void HoleSequenceTest::oneWithANeedleInTheWayOfTheOther() {
  HalfEdgeMesh mesh = balls(0.02);
  const HalfEdge h = findBoundaryLoops(mesh)[1].halfEdges[0];
  const Vec3 end = mesh.position(mesh.to(h));
  const Vertex tip = mesh.addVertex(end - 1e-6 * Vec3(end.x(), end.y(), 0.0));  // into the opening
  mesh.pair(h, 3 * mesh.addFace({mesh.to(h), mesh.from(h), tip}));
  QCOMPARE(validate(mesh), std::string());
  const auto loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t(2));
  HoleFiller oneByOne(mesh);
  oneByOne.accept(loops[0], oneByOne.propose(loops[0], {}).patch);
  QCOMPARE(oneByOne.propose(loops[1], {}).failure, FillFailure::NarrowTriangles);

  for (const HoleFill& fill : fillHoles(mesh, loops, {})) QCOMPARE(fill.attempt.failure, FillFailure::None);
  QVERIFY(test::countEdges(mesh).sound());
}

void HoleSequenceTest::nothingToFill() {
  HalfEdgeMesh mesh = buildMesh(test::cube(1.0)).mesh;
  QVERIFY(fillHoles(mesh, {}, {}).empty());
  QCOMPARE(mesh.liveFaceCount(), std::size_t(12));
}

void HoleSequenceTest::cancelled() {
  HalfEdgeMesh mesh = balls(0.02);
  const auto loops = findBoundaryLoops(mesh);
  JobState job;
  job.cancelled = true;
  fillHoles(mesh, loops, {}, Progress(job));
  QVERIFY(test::sameMesh(mesh, balls(0.02)));
}

HANDWHEEL_TEST(HoleSequenceTest)
#include "HoleSequenceTest.moc"
