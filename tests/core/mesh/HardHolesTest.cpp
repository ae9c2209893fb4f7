// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/HardHoles.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/MeshBuilder.h"
#include "mesh/MeshValidator.h"
#include "mesh/Uncrossing.h"

#include <QTest>

using namespace handwheel;

namespace {

// A ball without its top, and a closed rod that stands in it and out of the hole.
TriangleSoup ballWithRod() {
  TriangleSoup s = test::sphereWithoutCap(3, 0.5);
  test::append(s, test::moved(test::cylinder(12, 2, 0.1, 2.0, true), {0.03, 0.02, -0.2}));
  return s;
}

std::vector<HardHole> holesOf(const HalfEdgeMesh& mesh, bool back) {
  std::vector<HardHole> holes;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) holes.push_back({loop, back});
  return holes;
}

}  // namespace

class HardHolesTest : public QObject {
  Q_OBJECT

 private slots:
  void somethingStandsInTheHole();
  void manyAtOnce();
  void backs();
  void cancelled();
  void nothingToDo();
};

// Every patch crosses the rod; what is cut leaves all of the ball's and the rod's surface where it was.
void HardHolesTest::somethingStandsInTheHole() {
  const HalfEdgeMesh before = buildMesh(ballWithRod()).mesh;
  for (NumberType numbers : {NumberType::Float64, NumberType::Float32}) {
    FillOptions options;
    options.numbers = numbers;
    for (const BoundaryLoop& loop : findBoundaryLoops(before)) {
      QVERIFY(HoleFiller(before).propose(loop, options).failure == FillFailure::SelfIntersecting);
    }
    HalfEdgeMesh mesh = before;
    const HardClosings closings = closeHardHoles(mesh, holesOf(mesh, false), options, 0.01);
    QCOMPARE(closings.holes.size(), std::size_t{1});
    QVERIFY(closings.holes[0].closed);
    QVERIFY(closings.holes[0].newFaces > 0);
    QVERIFY(closings.cutFaces > 0);
    QVERIFY(test::countEdges(mesh).sound());
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(countCrossings(mesh, numbers) <= countCrossings(before, numbers));
    for (Vertex v = 0; v < before.vertexSlots(); ++v) QVERIFY((mesh.position(v) - before.position(v)).norm() < 1e-3);
  }
}

void HardHolesTest::manyAtOnce() {
  TriangleSoup s = ballWithRod();
  test::append(s, test::moved(ballWithRod(), {5, 0, 0}));
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  const HardClosings closings = closeHardHoles(mesh, holesOf(mesh, false), {}, 0.01);
  QCOMPARE(std::count_if(closings.holes.begin(), closings.holes.end(), [](const HardClosing& c) { return c.closed; }),
           2);
  QVERIFY(test::countEdges(mesh).sound());
}

void HardHolesTest::backs() {
  TriangleSoup s = test::annulus(24, 3, 1.0, 2.0);
  test::append(s, test::moved(test::disc(12, 3), {0, 0, 3}));
  test::append(s, TriangleSoup{{{9, 0, 0}, {9, 1, 0}, {9, 0, 1}}, {{0, 1, 2}}});
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  const HardClosings closings = closeHardHoles(mesh, holesOf(mesh, true), {}, 0.01);
  for (const HardClosing& c : closings.holes) {
    QVERIFY(c.closed);
    QVERIFY(c.method == FillMethod::Backed);
  }
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
}

void HardHolesTest::cancelled() {
  const HalfEdgeMesh before = buildMesh(ballWithRod()).mesh;
  HalfEdgeMesh mesh = before;
  JobState state;
  state.cancelled = true;
  closeHardHoles(mesh, holesOf(before, false), {}, 0.01, Progress(state));
  QVERIFY(test::sameMesh(mesh, before));
}

void HardHolesTest::nothingToDo() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(2)).mesh;
  QVERIFY(closeHardHoles(mesh, {}, {}, 0.01).holes.empty());
}

HANDWHEEL_TEST(HardHolesTest)
#include "HardHolesTest.moc"
