// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/VertexGoals.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <limits>

using namespace handwheel;

class VertexGoalsTest : public QObject {
  Q_OBJECT

 private slots:
  void reachesItsGoal();
  void stopsBeforeAFaceTurnsOver();
  void noFaceTurnsOver();
  void roundsToTheFile();
  void oddGoals();
  void cancelled();
  void facesWithoutAreaHoldNobodyBack();
  void sameInEverySizeAndPosition();
};

namespace {

HalfEdgeMesh vertexGoalsPlate() {
  return buildMesh(test::grid(5, 5, false, false, [](auto i, auto j) { return Vec3(i, j, 0); })).mesh;
}

HalfEdge leavingOf(const HalfEdgeMesh& mesh, Vertex v) {
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.isProper(HalfEdgeMesh::face(h)) && mesh.from(h) == v) return h;
  return kNone;
}

const Vertex kVertexGoalsMiddle = test::vertexAt(vertexGoalsPlate(), Vec3(2, 2, 0));

}  // namespace

void VertexGoalsTest::reachesItsGoal() {
  HalfEdgeMesh mesh = vertexGoalsPlate();
  const HalfEdgeMesh before = mesh;
  const MovedVertices moved =
      moveTowards(mesh, std::array{VertexGoal{leavingOf(mesh, kVertexGoalsMiddle), Vec3(2.2, 1.9, 1.5)}});
  QCOMPARE(moved.heldBack, std::size_t(0));
  QCOMPARE(moved.faces.size(), std::size_t(6));
  QCOMPARE(mesh.position(kVertexGoalsMiddle), Vec3(2.2, 1.9, 1.5));
  QCOMPARE(validate(mesh), std::string());
  moveTowards(mesh, std::array{VertexGoal{leavingOf(mesh, kVertexGoalsMiddle), before.position(kVertexGoalsMiddle)}});
  QVERIFY(test::sameMesh(mesh, before));
}

// The ring of the middle extends from 1 to 3: a vertex that would leave it moves only a part of the distance.
void VertexGoalsTest::stopsBeforeAFaceTurnsOver() {
  HalfEdgeMesh mesh = vertexGoalsPlate();
  const MovedVertices moved =
      moveTowards(mesh, std::array{VertexGoal{leavingOf(mesh, kVertexGoalsMiddle), Vec3(2, 6, 0)}});
  QCOMPARE(moved.heldBack, std::size_t(1));
  QVERIFY(mesh.position(kVertexGoalsMiddle).y() > 2.0 && mesh.position(kVertexGoalsMiddle).y() < 3.0);
  for (Face f = 0; f < mesh.faceSlots(); ++f) QVERIFY(unitNormal(mesh.points(f)).z() > 0.99);
}

void VertexGoalsTest::noFaceTurnsOver() {
  const HalfEdgeMesh whole = buildMesh(test::bumpySphere(2)).mesh;
  const bool ok = rc::check([&] {
    HalfEdgeMesh mesh = whole;
    const double size = *rc::gen::element(0.01, 0.1, 1.0, 100.0);
    std::vector<VertexGoal> moves;
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
      if (*rc::gen::inRange(0, 2) == 0) continue;
      const auto coordinate = [&] { return size * (*rc::gen::inRange(-1000, 1001)) / 1000.0; };
      const double x = coordinate(), y = coordinate(), z = coordinate();
      moves.push_back({leavingOf(mesh, v), mesh.position(v) + Vec3(x, y, z)});
    }
    moveTowards(mesh, moves);
    RC_ASSERT(validate(mesh) == std::string());
    for (Face f = 0; f < mesh.faceSlots(); ++f)
      RC_ASSERT(unitNormal(mesh.points(f)).dot(unitNormal(whole.points(f))) > 0.0);
  });
  QVERIFY(ok);
}

void VertexGoalsTest::roundsToTheFile() {
  HalfEdgeMesh mesh = vertexGoalsPlate();
  moveTowards(mesh, std::array{VertexGoal{leavingOf(mesh, kVertexGoalsMiddle), Vec3(2.1, 2.1, 0.1)}},
              NumberType::Float32);
  QCOMPARE(mesh.position(kVertexGoalsMiddle), Vec3(double(2.1f), double(2.1f), double(0.1f)));
}

void VertexGoalsTest::oddGoals() {
  const HalfEdgeMesh before = vertexGoalsPlate();
  HalfEdgeMesh mesh = before;
  constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();
  const HalfEdge h = leavingOf(mesh, kVertexGoalsMiddle);
  moveTowards(mesh, {});
  moveTowards(mesh, std::array{VertexGoal{h, Vec3(kNan, 0, 0)}});
  moveTowards(mesh, std::array{VertexGoal{h, Vec3(0, kInfinity, 0)}});
  moveTowards(mesh, std::array{VertexGoal{h, Vec3(0, 0, 1e300)}}, NumberType::Float32);
  moveTowards(mesh, std::array{VertexGoal{h, mesh.position(kVertexGoalsMiddle)}}, NumberType::Float32);
  QVERIFY(test::sameMesh(mesh, before));
}

// The last of the polls is before anything moves.
void VertexGoalsTest::cancelled() {
  const HalfEdgeMesh before = buildMesh(test::bumpySphere(5)).mesh;
  std::vector<HalfEdge> leaving(before.vertexSlots());
  for (HalfEdge h = 0; h < before.halfEdgeSlots(); ++h) leaving[before.from(h)] = h;
  std::vector<VertexGoal> moves;
  for (const HalfEdge h : leaving) moves.push_back({h, 1.5 * before.position(before.from(h))});
  std::size_t midst = 0;
  for (std::size_t effort = 0;; effort += 256) {
    WorkBudget budget(effort);
    HalfEdgeMesh mesh = before;
    const bool isDone = !moveTowards(mesh, moves, NumberType::Float64, Progress().within(budget)).faces.empty();
    QCOMPARE(test::sameMesh(mesh, before), !isDone);
    if (isDone) break;
    ++midst;
  }
  QVERIFY(midst > 3);
}

void VertexGoalsTest::facesWithoutAreaHoldNobodyBack() {
  TriangleSoup soup = test::cube();
  test::addNeedles(soup, 0, 0, {0.5});
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const Vertex middle = test::vertexAt(mesh, soup.points.back());
  const Vec3 to = mesh.position(middle) + 0.1 * Vec3(0.5 - mesh.position(middle).x(), 0.5 - mesh.position(middle).y(),
                                                     0.5 - mesh.position(middle).z());
  QCOMPARE(moveTowards(mesh, std::array{VertexGoal{leavingOf(mesh, middle), to}}).heldBack, std::size_t(0));
  QCOMPARE(validate(mesh), std::string());
}

void VertexGoalsTest::sameInEverySizeAndPosition() {
  for (const auto& [scale, shift] : {std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1.0, 1e7)}) {
    HalfEdgeMesh mesh = vertexGoalsPlate();
    const Vec3 far(shift, shift, shift);
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) mesh.setPosition(v, scale * mesh.position(v) + far);
    const Vec3 to = scale * Vec3(2.5, 6, 0.25) + far;
    QCOMPARE(moveTowards(mesh, std::array{VertexGoal{leavingOf(mesh, kVertexGoalsMiddle), to}}).heldBack,
             std::size_t(1));
    HalfEdgeMesh plain = vertexGoalsPlate();
    moveTowards(plain, std::array{VertexGoal{leavingOf(plain, kVertexGoalsMiddle), Vec3(2.5, 6, 0.25)}});
    QVERIFY((mesh.position(kVertexGoalsMiddle) - scale * plain.position(kVertexGoalsMiddle) - far).norm() <=
            1e-8 * scale);
  }
}

HANDWHEEL_TEST(VertexGoalsTest)
#include "VertexGoalsTest.moc"
