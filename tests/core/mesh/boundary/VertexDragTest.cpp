// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/VertexDrag.h"

#include "HoleShapes.h"
#include "MeshChecks.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class VertexDragTest : public QObject {
  Q_OBJECT

 private slots:
  void shapes();
  void goesWhereItMay();
  void stopsWhereTheFileCanHoldIt();
  void stopsBeforeAFaceTurns();
  void stopsBeforeAWall();
  void takesWhatLiesThere();
  void otherMeshes();
  void neverTurnsAFace();
};

namespace {

Vertex at(const HalfEdgeMesh& mesh, const Vec3& p) {
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
    if (mesh.position(v) == p) return v;
  return kNone;
}

std::shared_ptr<const FaceLocator> near(const HalfEdgeMesh& mesh) {
  return std::make_shared<const FaceLocator>(mesh, std::make_shared<FaceHierarchy>(mesh));
}

}  // namespace

void VertexDragTest::shapes() {
  const TrianglePoints flat = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  QVERIFY(std::abs(slimness(flat) - 0.5) < 1e-15);
  QVERIFY(mayBecome(flat, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 5)}));    // tilted by less than 90°
  QVERIFY(!mayBecome(flat, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0)}));  // turned over
  QVERIFY(!mayBecome(flat, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}));   // on one line
  QVERIFY(!mayBecome(flat, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1e-3, 0)}));
  QVERIFY(mayBecome({Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX()},
                    flat));  // a face without an orientation may get any
  const TrianglePoints slim = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1e-3, 0)};
  QVERIFY(mayBecome(slim, {slim[0], slim[1], Vec3(0.5, 0.9e-3, 0)}));
  QVERIFY(!mayBecome(slim, {slim[0], slim[1], Vec3(0.5, 0.4e-3, 0)}));
  for (const double scale : {1e-300, 1e-6, 1e6, 1e150})
    QVERIFY(std::abs(slimness({scale * flat[0], scale * flat[1], scale * flat[2]}) - 0.5) < 1e-15);
}

void VertexDragTest::goesWhereItMay() {
  HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const HalfEdgeMesh before = mesh;
  const Vertex v = at(mesh, Vec3(-2, 0, 0));
  const VertexDrag pull(near(mesh), v);
  QCOMPARE(pull.faces().size(), std::size_t(3));
  const Vec3 target(-1.2, 0.3, 0.4);
  QCOMPARE(pull.towards(target).problem, JoinProblem::None);
  QCOMPARE(pull.towards(target).point, target);
  QVERIFY(pull.apply(mesh, target));
  QCOMPARE(validate(mesh), std::string());
  for (Vertex u = 0; u < mesh.vertexSlots(); ++u)
    QVERIFY(u == v ? mesh.position(u) == target : test::sameBits(mesh.position(u), before.position(u)));
  const std::vector<TrianglePoints> shapes = pull.shapes(target);
  for (std::size_t i = 0; i < 3; ++i) QVERIFY(shapes[i] == mesh.points(pull.faces()[i]));
}

// 0.3 is no number of single precision; what stops before a wall must be one, too.
void VertexDragTest::stopsWhereTheFileCanHoldIt() {
  const HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const VertexDrag pull(near(mesh), at(mesh, Vec3(-2, 0, 0)));
  const auto isSingle = [](const Vec3& p) { return p == Vec3(p.cast<float>().cast<double>()); };
  for (const Vec3& target : {Vec3(-1.2, 0.3, 0.4), Vec3(-5.0, 0.1, 0.7)}) {
    HalfEdgeMesh moved = mesh;
    const Vec3 point = pull.towards(target, NumberType::Float32).point;
    QVERIFY(isSingle(point) && !isSingle(pull.towards(target).point));
    QVERIFY((point - pull.towards(target).point).norm() < 1e-6);
    QVERIFY(pull.apply(moved, point));
    QCOMPARE(validate(moved), std::string());
  }
}

// The faces around (-2, 0) extend to x = -3; before that they lose their area.
void VertexDragTest::stopsBeforeAFaceTurns() {
  const HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const VertexDrag pull(near(mesh), at(mesh, Vec3(-2, 0, 0)));
  const VertexDrag::ReachablePoint reached = pull.towards(Vec3(-5, 0, 0));
  QCOMPARE(reached.problem, JoinProblem::FlippedFace);
  QVERIFY(reached.point.x() < -2.5 && reached.point.x() > -3.0);
  QCOMPARE(reached.point.y(), 0.0);
  for (const double gone : {std::nan(""), double(INFINITY)}) {
    QCOMPARE(pull.towards(Vec3(gone, 0, 0)).point, pull.start());
    HalfEdgeMesh same = mesh;
    QVERIFY(!pull.apply(same, Vec3(gone, 0, 0)));
  }
  HalfEdgeMesh same = mesh;
  QVERIFY(!pull.apply(same, Vec3(-5, 0, 0)));
  QVERIFY(test::sameMesh(same, mesh));
}

// A wall stands in the hole.
void VertexDragTest::stopsBeforeAWall() {
  TriangleSoup soup = test::plateWithHole();
  test::append(soup, {{Vec3(-1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, 0, 3)}, {{0, 1, 2}}});
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const VertexDrag pull(near(mesh), at(mesh, Vec3(-2, 0, 0)));
  QCOMPARE(pull.towards(Vec3(-1.1, 0, 0)).problem, JoinProblem::None);
  const VertexDrag::ReachablePoint reached = pull.towards(Vec3(0, 0, 0));
  QCOMPARE(reached.problem, JoinProblem::Crosses);
  QVERIFY(reached.point.x() < -1.0 && reached.point.x() > -1.01);
  HalfEdgeMesh moved = mesh;
  QVERIFY(!pull.apply(moved, Vec3(0, 0, 0)));
  QVERIFY(pull.apply(moved, reached.point));
  QCOMPARE(test::meetingPairs(moved), std::size_t(0));
}

void VertexDragTest::takesWhatLiesThere() {
  HalfEdgeMesh mesh = buildMesh(test::plateWithPinchedHole()).mesh;
  const VertexDrag pull(near(mesh), at(mesh, Vec3::Zero()));
  QVERIFY(pull.apply(mesh, Vec3(0.1, 0.1, 0.2)));
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(at(mesh, Vec3::Zero()), kNone);
  QCOMPARE(findBoundaryLoops(mesh).size(), std::size_t(3));  // two holes and the rim, as before
}

void VertexDragTest::otherMeshes() {
  const HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const Vertex v = at(mesh, Vec3(-2, 0, 0));
  const VertexDrag pull(near(mesh), v);
  HalfEdgeMesh moved = mesh;
  moved.setPosition(v, Vec3(-2, 0, 1));
  QVERIFY(!pull.apply(moved, Vec3(-2, 0, 0.5)));
  HalfEdgeMesh without = mesh;
  without.removeFace(pull.faces()[0]);
  QVERIFY(!pull.apply(without, Vec3(-2, 0, 0.5)));
  HalfEdgeMesh empty;
  QVERIFY(!pull.apply(empty, Vec3(-2, 0, 0.5)));
}

void VertexDragTest::neverTurnsAFace() {
  QVERIFY(rc::check([] {
    const double scale = *rc::gen::element(1e-6, 1.0, 1e6);
    const double offset = scale == 1.0 ? *rc::gen::element(0.0, 1e7) : 0.0;
    const TriangleSoup soup = test::moved(
        *rc::gen::element(test::sphereWithoutCap(2), test::moebiusStrip(16, 3), test::plateWithPinchedHole()),
        Vec3::Constant(offset), scale);
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const auto loops = findBoundaryLoops(mesh);
    const auto& loop = loops[*rc::gen::inRange<std::size_t>(0, loops.size())];
    const Vertex v = mesh.from(loop.halfEdges[*rc::gen::inRange<std::size_t>(0, loop.halfEdges.size())]);
    const VertexDrag pull(near(mesh), v);
    const auto part = [] { return *rc::gen::inRange(-300, 300) / 100.0; };
    const Vec3 target = mesh.position(v) + scale * Vec3(part(), part(), part());
    const HalfEdgeMesh before = mesh;
    const Vec3 position = pull.towards(target).point;
    RC_ASSERT(pull.apply(mesh, position));
    RC_ASSERT(validate(mesh) == "");
    RC_ASSERT(test::meetingPairs(mesh) <= test::meetingPairs(before));
    for (const Face f : pull.faces()) RC_ASSERT(unitNormal(before.points(f)).dot(unitNormal(mesh.points(f))) > 0.0);
  }));
}

HANDWHEEL_TEST(VertexDragTest)
#include "VertexDragTest.moc"
