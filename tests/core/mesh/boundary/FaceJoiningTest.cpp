// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/FaceJoining.h"

#include "HandWorkChecks.h"
#include "HoleShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using Corners = std::array<handwheel::Vec3, 3>;
using namespace handwheel;

class FaceJoiningTest : public QObject {
  Q_OBJECT

 private slots:
  void closesATriangle();
  void fillsACorner();
  void refuses_data();
  void refuses();
  void twoAtOnce();
  void unitesAPinch();
  void olderHierarchy();
  void anyThreePoints();
};

namespace {

Triangle cornersAt(const HalfEdgeMesh& mesh, const std::array<Vec3, 3>& p) {
  return {test::vertexAt(mesh, p[0]), test::vertexAt(mesh, p[1]), test::vertexAt(mesh, p[2])};
}

JoinProblem add(HalfEdgeMesh& mesh, const std::vector<Triangle>& triangles) {
  return addFaces(mesh, triangles, test::nearFaces(mesh));
}

}  // namespace

void FaceJoiningTest::closesATriangle() {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    TriangleSoup soup = test::moved(test::icosphere(1), Vec3::Zero(), scale);
    const Triangle gone = soup.triangles.back();
    soup.triangles.pop_back();
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const Triangle t = cornersAt(mesh, {soup.points[gone[0]], soup.points[gone[1]], soup.points[gone[2]]});
    QCOMPARE(add(mesh, {{t[0], t[2], t[1]}}), JoinProblem::InconsistentOrientation);
    QCOMPARE(add(mesh, {t}), JoinProblem::None);
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(test::countEdges(mesh).sound());
    QCOMPARE(add(mesh, {t}), JoinProblem::NonManifoldEdge);
  }
}

void FaceJoiningTest::fillsACorner() {
  HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const HalfEdgeMesh before = mesh;
  const Triangle ear = cornersAt(mesh, {Vec3(-2, -2, 0), Vec3(-1, -2, 0), Vec3(-2, -1, 0)});
  QCOMPARE(add(mesh, {ear}), JoinProblem::None);
  QCOMPARE(test::worse(before, mesh), std::string());
  QVERIFY(test::othersStay(before, mesh, {}));
  QCOMPARE(test::countBorder(mesh), test::countBorder(before) - 1);
  QCOMPARE(mesh.triangle(static_cast<Face>(mesh.faceSlots() - 1)), ear);
}

void FaceJoiningTest::refuses_data() {
  QTest::addColumn<Corners>("corners");
  QTest::addColumn<JoinProblem>("problem");
  QTest::newRow("a corner twice") << Corners{Vec3(-2, -2, 0), Vec3(-1, -2, 0), Vec3(-2, -2, 0)}
                                  << JoinProblem::SamePoint;
  QTest::newRow("a line") << Corners{Vec3(-2, -2, 0), Vec3(-1, -2, 0), Vec3(0, -2, 0)} << JoinProblem::DegenerateFace;
  QTest::newRow("the wrong way") << Corners{Vec3(-2, -2, 0), Vec3(-2, -1, 0), Vec3(-1, -2, 0)}
                                 << JoinProblem::InconsistentOrientation;
  QTest::newRow("on a face") << Corners{Vec3(-5, -5, 0), Vec3(-4, -5, 0), Vec3(-4, -4, 0)}
                             << JoinProblem::NonManifoldEdge;
  QTest::newRow("one edge and a far corner")
      << Corners{Vec3(-1, -2, 0), Vec3(0, -2, 0), Vec3(0, 2, 0)} << JoinProblem::NonManifoldVertex;
  QTest::newRow("no edge") << Corners{Vec3(-2, 0, 0), Vec3(0, -2, 0), Vec3(2, 0, 0)} << JoinProblem::NonManifoldVertex;
  QTest::newRow("over faces") << Corners{Vec3(-2, -1, 0), Vec3(-1, -2, 0), Vec3(-5, -4, 0)} << JoinProblem::Crosses;
}

void FaceJoiningTest::refuses() {
  QFETCH(JoinProblem, problem);
  QFETCH(Corners, corners);
  HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const HalfEdgeMesh before = mesh;
  QCOMPARE(add(mesh, {cornersAt(mesh, corners)}), problem);
  QVERIFY(test::sameMesh(mesh, before));
}

// Two triangles across the hole hold each other.
void FaceJoiningTest::twoAtOnce() {
  HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const HalfEdgeMesh before = mesh;
  const Triangle one = cornersAt(mesh, {Vec3(-1, -2, 0), Vec3(0, -2, 0), Vec3(0, 2, 0)});
  const Triangle two = cornersAt(mesh, {Vec3(0, 2, 0), Vec3(-1, 2, 0), Vec3(-1, -2, 0)});
  QCOMPARE(add(mesh, {one, two}), JoinProblem::None);
  QCOMPARE(test::worse(before, mesh), std::string());
  QCOMPARE(findBoundaryLoops(mesh).size(), std::size_t(3));
  HalfEdgeMesh other = before;
  QCOMPARE(add(other, {one, one}), JoinProblem::NonManifoldEdge);
  QVERIFY(test::sameMesh(other, before));
}

// Over the corner of a hole that is pinched there, the two fans become one vertex.
void FaceJoiningTest::unitesAPinch() {
  HalfEdgeMesh mesh = buildMesh(test::plateWithPinchedHole()).mesh;
  const HalfEdgeMesh before = mesh;
  QCOMPARE(add(mesh, {cornersAt(mesh, {Vec3::Zero(), Vec3(1, 0, 0), Vec3(0, 1, 0)})}), JoinProblem::None);
  QCOMPARE(test::worse(before, mesh), std::string());
  std::set<Vertex> used;
  for (const HalfEdge h : test::nearFaces(mesh).leaving(Vec3::Zero())) used.insert(mesh.from(h));
  QCOMPARE(used.size(), std::size_t(1));
}

// Changes since the construction of the hierarchy are respected.
void FaceJoiningTest::olderHierarchy() {
  HalfEdgeMesh mesh = buildMesh(test::plateWithHole()).mesh;
  const auto older = std::make_shared<FaceHierarchy>(mesh);
  const Triangle ear = cornersAt(mesh, {Vec3(-2, -2, 0), Vec3(-1, -2, 0), Vec3(-2, -1, 0)});
  QCOMPARE(addFaces(mesh, {&ear, 1}, FaceLocator(mesh, older)), JoinProblem::None);
  QCOMPARE(addFaces(mesh, {&ear, 1}, FaceLocator(mesh, older)), JoinProblem::NonManifoldEdge);
  const Vec3 raised(-1, -2, 0.5);
  mesh.setPosition(test::vertexAt(mesh, Vec3(-1, -2, 0)), raised);
  const Triangle next = cornersAt(mesh, {Vec3(-2, -1, 0), raised, Vec3(0, -2, 0)});
  const HalfEdgeMesh before = mesh;
  QCOMPARE(addFaces(mesh, {&next, 1}, FaceLocator(mesh, older)), JoinProblem::None);
  QCOMPARE(test::worse(before, mesh), std::string());
  // By the box it is the same.
  HalfEdgeMesh other = before;
  Box box;
  for (const Vertex v : next) box.extend(other.position(v));
  QCOMPARE(addFaces(other, {&next, 1}, FaceLocator(other, box)), JoinProblem::None);
  QVERIFY(test::sameMesh(mesh, other));
}

void FaceJoiningTest::anyThreePoints() {
  QVERIFY(rc::check([] {
    HalfEdgeMesh mesh = buildMesh(*rc::gen::element(test::plateWithPinchedHole(), test::plateWithIsland(),
                                                    test::sphereWithHoles(2, 4, 0.4), test::moebiusStrip(12, 1)))
                            .mesh;
    std::vector<HalfEdge> border;
    for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
      if (mesh.isBorder(h)) border.push_back(h);
    for (int i = 0; i < 40; ++i) {
      const HalfEdge h = border[*rc::gen::inRange<std::size_t>(0, border.size())];
      if (!mesh.isBorder(h)) continue;
      // Most often two edges that follow each other, else any three points.
      const HalfEdge next = mesh.nextOpen(h), any = border[*rc::gen::inRange<std::size_t>(0, border.size())];
      const Vertex third = *rc::gen::inRange(0, 3) ? mesh.to(next) : mesh.from(any);
      const HalfEdgeMesh before = mesh;
      const Triangle t = {mesh.to(h), mesh.from(h), third};
      if (add(mesh, {t}) == JoinProblem::None) {
        RC_ASSERT(test::worse(before, mesh) == "");
        RC_ASSERT(mesh.liveFaceCount() == before.liveFaceCount() + 1);
        RC_ASSERT(test::othersStay(before, mesh, {}));
      } else {
        RC_ASSERT(test::sameMesh(before, mesh));
      }
    }
  }));
}

HANDWHEEL_TEST(FaceJoiningTest)
#include "FaceJoiningTest.moc"
