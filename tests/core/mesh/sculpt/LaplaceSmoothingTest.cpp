// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/LaplaceSmoothing.h"

#include "DoubledEdges.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

class LaplaceSmoothingTest : public QObject {
  Q_OBJECT

 private slots:
  void halfwayToTheNeighbours();
  void linearStays_data();
  void linearStays();
  void spheresShrink();
  void onlyThePart();
  void refusedAndCancelled();
};

namespace {

HalfEdgeMesh builtMesh(const TriangleSoup& soup) {
  return buildMesh(soup).mesh;
}

HalfEdgeMesh flatGrid(std::uint32_t n) {
  return builtMesh(test::grid(n, n, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.0); }));
}

}  // namespace

// The damped Jacobi step of the umbrella operator: p + (mean - p) / 2, from the old positions only.
void LaplaceSmoothingTest::halfwayToTheNeighbours() {
  const HalfEdgeMesh before = builtMesh(test::bumpySphere(3));
  HalfEdgeMesh mesh = before;
  const auto done = smoothByLaplace(mesh, FaceSelection::all(mesh), {.passes = 1});
  QCOMPARE(done.refusal, OpenMeshRefusal::None);
  QCOMPARE(done.moved.heldBack, std::size_t{0});
  for (HalfEdge h = 0; h < before.halfEdgeSlots(); ++h) {
    Vec3 mean = Vec3::Zero();
    const auto fan = before.fan(h);
    for (const HalfEdge g : fan) mean += before.position(before.to(g)) / double(fan.size());
    const Vec3& p = before.position(before.from(h));
    QVERIFY((mesh.position(before.from(h)) - (p + 0.5 * (mean - p))).norm() < 1e-14);
  }
}

void LaplaceSmoothingTest::linearStays_data() {
  QTest::addColumn<bool>("isBending");
  QTest::newRow("area") << false;
  QTest::newRow("bending") << true;
}

// Each inner vertex of a regular grid is the mean of its neighbours.
void LaplaceSmoothingTest::linearStays() {
  QFETCH(bool, isBending);
  const HalfEdgeMesh before = flatGrid(9);
  HalfEdgeMesh mesh = before;
  smoothByLaplace(mesh, FaceSelection::all(mesh), {.isBending = isBending});
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) QVERIFY((mesh.position(v) - before.position(v)).norm() < 1e-13);
}

// Towards the least area a sphere shrinks; by bending energy it does so far less.
void LaplaceSmoothingTest::spheresShrink() {
  const HalfEdgeMesh before = builtMesh(test::icosphere(3));
  HalfEdgeMesh area = before, bending = before;
  smoothByLaplace(area, FaceSelection::all(before), {});
  smoothByLaplace(bending, FaceSelection::all(before), {.isBending = true});
  const double was = test::volume(before.compact().soup);
  const double lost = was - test::volume(area.compact().soup), bent = was - test::volume(bending.compact().soup);
  QVERIFY(lost > 0.0 && std::abs(bent) < 0.1 * lost);
  for (const HalfEdgeMesh& m : {area, bending}) QCOMPARE(validate(m), std::string());
}

void LaplaceSmoothingTest::onlyThePart() {
  HalfEdgeMesh before = flatGrid(9);
  for (Vertex v = 0; v < before.vertexSlots(); ++v)
    before.setPosition(v, before.position(v) + Vec3(0, 0, 0.1 * (v % 3)));
  const FaceSelection part = FaceSelection::where(before.faceSlots(), [](Face f) { return f < 64; });
  HalfEdgeMesh mesh = before;
  QVERIFY(!smoothByLaplace(mesh, part, {}).moved.faces.empty());
  std::set<Vertex> held;
  for (HalfEdge h = 0; h < before.halfEdgeSlots(); ++h)
    if (before.isBorder(h) || !part.contains(HalfEdgeMesh::face(h))) held.insert({before.from(h), before.to(h)});
  QVERIFY(held.size() < before.vertexSlots());
  for (Vertex v = 0; v < before.vertexSlots(); ++v)
    QCOMPARE(test::sameBits(mesh.position(v), before.position(v)), held.contains(v));
  // No vertex has all its faces in it: nothing moves.
  mesh = before;
  QVERIFY(smoothByLaplace(mesh, FaceSelection{40}, {}).moved.faces.empty());
  QVERIFY(smoothByLaplace(mesh, {}, {}).moved.faces.empty());
  QVERIFY(test::sameMesh(mesh, before));
}

void LaplaceSmoothingTest::refusedAndCancelled() {
  HalfEdgeMesh ring = test::doubledEdges();
  QCOMPARE(smoothByLaplace(ring, FaceSelection::all(ring), {}).refusal, OpenMeshRefusal::DoubleEdge);
  const HalfEdgeMesh before = builtMesh(test::bumpySphere(3));
  HalfEdgeMesh mesh = before;
  JobState job;
  job.cancelled = true;
  QVERIFY(smoothByLaplace(mesh, FaceSelection::all(mesh), {.progress = Progress(job)}).moved.faces.empty());
  QVERIFY(test::sameMesh(mesh, before));
  // In the midst of it, too: once so much work is done.
  std::size_t done = 0, midst = 0;
  for (std::size_t effort = 64; done < 3; effort += 64) {
    WorkBudget budget(effort);
    const Progress progress = Progress().within(budget);
    mesh = before;
    const auto moved = smoothByLaplace(mesh, FaceSelection::all(mesh), {.passes = 2, .progress = progress}).moved;
    QCOMPARE(test::sameMesh(mesh, before), moved.faces.empty());
    ++(moved.faces.empty() ? midst : done);
  }
  QVERIFY(midst > 10);
}

HANDWHEEL_TEST(LaplaceSmoothingTest)
#include "LaplaceSmoothingTest.moc"
