// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/IntersectionClusters.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;
using Pairs = std::vector<std::pair<Face, Face>>;

namespace {

// Two unit cubes each, far from each other: the second pair is shifted in its planes, so that faces lie on faces.
HalfEdgeMesh couples(const Vec3& second) {
  TriangleSoup s = test::cube();
  test::append(s, test::cube(1.0, {0.41, 0.27, 0.33}));
  test::append(s, test::cube(1.0, {10, 0, 0}));
  test::append(s, test::cube(1.0, Vec3(10, 0, 0) + second));
  return buildMesh(s).mesh;
}

}  // namespace

class IntersectionClustersTest : public QObject {
  Q_OBJECT

 private slots:
  void clusters();
  void oneOfTwo();
  void bothAtOnce();
  void whatWouldOpen();
  void cancelled();
};

void IntersectionClustersTest::clusters() {
  QVERIFY(intersectionClusters({}).empty());
  const Pairs pairs = {{7, 3}, {1, 2}, {3, 9}, {12, 7}, {2, 1}};
  const std::vector<std::vector<Face>> expected = {{1, 2}, {3, 7, 9, 12}};
  QVERIFY(intersectionClusters(pairs) == expected);
}

// Intersections that were not requested stay, bit for bit.
void IntersectionClustersTest::oneOfTwo() {
  const HalfEdgeMesh before = couples({0.5, 0.25, 0.125});
  const Pairs all = *findSelfIntersections(before);
  Pairs first;
  for (const auto& pair : all) {
    if (before.points(pair.first)[0].x() < 5.0) first.push_back(pair);
  }
  HalfEdgeMesh mesh = before;
  QCOMPARE(removeClusterIntersections(mesh, first, NumberType::Float64).clusters, intersectionClusters(first).size());
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(findSelfIntersections(mesh)->size(), all.size() - first.size());
  for (Face f = 0; f < before.faceSlots(); ++f) {
    if (before.points(f)[0].x() < 5.0) continue;
    QVERIFY(mesh.isLive(f));
    QVERIFY(mesh.points(f) == before.points(f));
  }
}

void IntersectionClustersTest::bothAtOnce() {
  HalfEdgeMesh mesh = couples({0.5, 0.25, 0.125});
  const Pairs all = *findSelfIntersections(mesh);
  QCOMPARE(removeClusterIntersections(mesh, all, NumberType::Float64).clusters, intersectionClusters(all).size());
  QCOMPARE(findSelfIntersections(mesh)->size(), std::size_t(0));
  QVERIFY(test::countEdges(mesh).sound());
}

// A face too many, on another one: cut, the two would not be closed any more.
void IntersectionClustersTest::whatWouldOpen() {
  TriangleSoup s = test::cube();
  test::append(s, test::cube(1.0, {0.41, 0.27, 0.33}));
  const HalfEdgeMesh good = buildMesh(s).mesh;
  s.triangles.push_back(s.triangles[findSelfIntersections(good)->front().first]);
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  const HalfEdgeMesh before = mesh;
  const std::size_t done = removeClusterIntersections(mesh, *findSelfIntersections(mesh), NumberType::Float64).clusters;
  QVERIFY(done > 0 || test::sameMesh(mesh, before));
  QVERIFY(test::countEdges(mesh).border <= test::countEdges(before).border);
}

void IntersectionClustersTest::cancelled() {
  HalfEdgeMesh mesh = couples({0.5, 0.25, 0.125});
  JobState job;
  job.cancelled = true;
  QCOMPARE(removeClusterIntersections(mesh, *findSelfIntersections(mesh), NumberType::Float64, Progress(job)).clusters,
           std::size_t(0));
}

HANDWHEEL_TEST(IntersectionClustersTest)
#include "IntersectionClustersTest.moc"
