// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Extremes.h"
#include "MeshChecks.h"
#include "TestClass.h"
#include "mesh/boundary/BoundarySmoothing.h"
#include "mesh/boundary/BoundaryWelding.h"
#include "mesh/boundary/Islands.h"
#include "mesh/boundary/Peninsulas.h"
#include "mesh/boundary/VertexDrag.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

// Manual changes of edges, on every extreme mesh.
class HandWorkExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void neverWorse_data();
  void neverWorse();
  void sizeChangesNoSmoothing_data();
  void sizeChangesNoSmoothing();
};

namespace {

constexpr std::size_t kMostFaces = 500;  // all pairs of faces are looked at
constexpr int kChanges = 15;

// Makes one manual change at a position that the numbers choose; returns true if it changed something.
bool work(HalfEdgeMesh& mesh, int change, std::mt19937& random) {
  const auto loops = findBoundaryLoops(mesh);
  if (loops.empty()) return false;
  const BoundaryLoop& loop = loops[random() % loops.size()];
  const auto near = std::make_shared<const FaceLocator>(mesh, std::make_shared<FaceHierarchy>(mesh));
  const std::size_t n = loop.halfEdges.size(), at = random() % n;
  const BoundaryPair ends{loop.halfEdges[at], loop.halfEdges[(at + 1 + random() % 4) % n]};
  switch (change % 5) {
    case 0:
      return moveVertices(mesh, smoothBoundary(*near, loop).moves);
    case 1: {
      const VertexDrag pull(near, mesh.from(ends.a));
      const Vec3 target = 0.5 * pull.start() + 0.5 * mesh.position(static_cast<Vertex>(random() % mesh.vertexSlots()));
      return pull.apply(mesh, pull.towards(target).point);
    }
    case 2: {
      BoundaryWeld weld = weldBoundary(*near, ends);
      if (weld.problem != JoinProblem::None) return false;
      mesh = std::move(weld.mesh);
      return true;
    }
    case 3: {
      const Bridge bridge = findBridge(*near, ends);
      return bridge.problem == JoinProblem::None && addFaces(mesh, bridge.triangles, *near) == JoinProblem::None;
    }
    default: {
      FaceSelection gone = findIslands(mesh, loop, loops);
      gone.add(findPeninsulas(mesh, loop));
      return removeFaces(mesh, gone) > 0;
    }
  }
}

}  // namespace

void HandWorkExtremesTest::neverWorse_data() {
  QTest::addColumn<QString>("name");
  for (const test::ExtremeMesh& mesh : test::allMeshes())
    QTest::newRow(mesh.name.c_str()) << QString(mesh.name.c_str());
}

void HandWorkExtremesTest::neverWorse() {
  QFETCH(QString, name);
  static const std::vector<test::ExtremeMesh> all = test::allMeshes();
  const auto own = std::find_if(all.begin(), all.end(), [&](const auto& m) { return name == m.name.c_str(); });
  HalfEdgeMesh mesh = buildMesh(own->soup()).mesh;
  std::mt19937 random(11);
  const bool isSmall = mesh.faceSlots() <= kMostFaces;
  std::size_t crossings = isSmall ? test::meetingPairs(mesh) : 0;
  test::Edges was = test::countEdges(mesh);
  for (int change = 0; change < kChanges; ++change) {
    const HalfEdgeMesh before = mesh;
    if (!work(mesh, change, random)) {
      QVERIFY(test::sameMesh(mesh, before));
      continue;
    }
    QCOMPARE(validate(mesh), std::string());
    const auto is = test::countEdges(mesh);
    QVERIFY(is.nonManifold <= was.nonManifold);
    QVERIFY(is.inconsistent <= was.inconsistent);
    was = is;
    if (!isSmall) continue;
    const std::size_t now = test::meetingPairs(mesh);
    QVERIFY2(now <= crossings, qPrintable(QString("change %1: %2 after %3").arg(change).arg(now).arg(crossings)));
    crossings = now;
  }
}

void HandWorkExtremesTest::sizeChangesNoSmoothing_data() {
  QTest::addColumn<double>("scale");
  for (int power : {-20, -10, 10, 20}) QTest::addRow("2^%d", power) << std::exp2(power);
}

// Scaling by a power of two is exact, so it must scale every move of a border to the bit; and none is farther than the
// border is wide.
void HandWorkExtremesTest::sizeChangesNoSmoothing() {
  QFETCH(double, scale);
  const TriangleSoup soup = test::sphereWithHoles(4, 3, 0.35);
  const HalfEdgeMesh plain = buildMesh(soup).mesh, scaled = buildMesh(test::moved(soup, Vec3::Zero(), scale)).mesh;
  const FaceLocator near(plain, std::make_shared<FaceHierarchy>(plain)),
      other(scaled, std::make_shared<FaceHierarchy>(scaled));
  const auto loops = findBoundaryLoops(plain), others = findBoundaryLoops(scaled);
  QCOMPARE(loops.size(), others.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const SmoothedBoundary a = smoothBoundary(near, loops[i]), b = smoothBoundary(other, others[i]);
    QVERIFY(!a.moves.empty());
    QCOMPARE(a.moves.size(), b.moves.size());
    for (std::size_t k = 0; k < a.moves.size(); ++k) {
      QCOMPARE(a.moves[k].vertex, b.moves[k].vertex);
      QVERIFY(Vec3(scale * a.moves[k].to) == b.moves[k].to);
      QVERIFY((a.moves[k].to - a.moves[k].from).norm() < loops[i].box.diagonal().norm());
    }
  }
}

HANDWHEEL_TEST(HandWorkExtremesTest)
#include "HandWorkExtremesTest.moc"
