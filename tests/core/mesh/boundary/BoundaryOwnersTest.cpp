// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryOwners.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class BoundaryOwnersTest : public QObject {
  Q_OBJECT

 private slots:
  void sameMesh();
  void afterOthersWereFilled();
  void afterTurningOver();
  void newHoleHasNoOwner();
  void holesGrownTogether();
};

void BoundaryOwnersTest::sameMesh() {
  const HalfEdgeMesh mesh = buildMesh(test::sphereWithHoles(4, 5, 0.3)).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  const BoundaryOwners owners(mesh, loops);
  QCOMPARE(loops.size(), std::size_t{5});
  for (const BoundaryLoop& loop : loops) QVERIFY(owners.of(mesh, loop) == std::set<int>{loop.id});
}

// With loop 1 filled the later ones have other ids; they still belong to the loops they were.
void BoundaryOwnersTest::afterOthersWereFilled() {
  const HalfEdgeMesh mesh = buildMesh(test::sphereWithHoles(4, 5, 0.3)).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  const BoundaryOwners owners(mesh, loops);
  HoleFiller filler(mesh);
  filler.accept(loops[1], filler.propose(loops[1], {}).patch);
  const std::vector<BoundaryLoop> left = findBoundaryLoops(filler.mesh());
  QCOMPARE(left.size(), std::size_t{4});
  const int expected[] = {0, 2, 3, 4};
  for (std::size_t i = 0; i < 4; ++i) QVERIFY(owners.of(filler.mesh(), left[i]) == std::set<int>{expected[i]});
}

void BoundaryOwnersTest::afterTurningOver() {
  HalfEdgeMesh mesh = buildMesh(test::sphereWithHoles(3, 3, 0.4)).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  const BoundaryOwners owners(mesh, loops);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    const Triangle t = mesh.triangle(f);
    mesh.setTriangle(f, {t[0], t[2], t[1]});
  }
  relink(mesh);
  const std::vector<BoundaryLoop> turned = findBoundaryLoops(mesh);
  QCOMPARE(turned.size(), std::size_t{3});
  for (std::size_t i = 0; i < 3; ++i) QVERIFY(owners.of(mesh, turned[i]) == std::set<int>{int(i)});
}

void BoundaryOwnersTest::newHoleHasNoOwner() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(2)).mesh;
  const BoundaryOwners owners(mesh, findBoundaryLoops(mesh));
  mesh.removeFace(10);
  QVERIFY(owners.of(mesh, findBoundaryLoops(mesh).at(0)).empty());
}

// A face between two holes goes: one hole that belongs to both.
void BoundaryOwnersTest::holesGrownTogether() {
  TriangleSoup soup =
      test::grid(7, 7, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.1 * i * j); });
  const auto without = [&](Face low, Face high) {
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    for (Face f = low; f <= high; ++f) mesh.removeFace(f);
    return mesh;
  };
  HalfEdgeMesh mesh = without(28, 28);  // one triangle, and another two further on in the same line of cells
  mesh.removeFace(30);
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
  QCOMPARE(loops.size(), std::size_t{3});
  const BoundaryOwners owners(mesh, loops);
  mesh.removeFace(29);
  relink(mesh);
  const std::vector<BoundaryLoop> grown = findBoundaryLoops(mesh);
  QCOMPARE(grown.size(), std::size_t{2});
  for (const BoundaryLoop& loop : grown) QCOMPARE(owners.of(mesh, loop).size(), loop.halfEdges.size() == 24 ? 1u : 2u);
}

HANDWHEEL_TEST(BoundaryOwnersTest)
#include "BoundaryOwnersTest.moc"
