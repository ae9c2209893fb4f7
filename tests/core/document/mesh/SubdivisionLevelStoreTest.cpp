// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/SubdivisionLevelStore.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class SubdivisionLevelStoreTest : public QObject {
  Q_OBJECT

 private slots:
  void sameVersions();
  void findsWhatItKept();
  void forgetsTheOldest();
};

namespace {

PatchLevels subdivided(double x) {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  mesh.setPosition(0, mesh.position(0) + Vec3(x, 0, 0));
  PatchLevels levels(mesh, FaceSelection::all(mesh));
  levels.refine();
  return levels;
}

}  // namespace

void SubdivisionLevelStoreTest::sameVersions() {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh, another = buildMesh(test::icosphere(1)).mesh;
  QVERIFY(isSameVersion(mesh, another));
  HalfEdgeMesh changed = mesh;
  changed.setPosition(5, Vec3(0, 0, 7));
  QVERIFY(!isSameVersion(mesh, changed));
  changed.setPosition(5, mesh.position(5));
  QVERIFY(isSameVersion(mesh, changed));
  changed.addVertex(Vec3::Zero());
  QVERIFY(!isSameVersion(mesh, changed));
}

void SubdivisionLevelStoreTest::findsWhatItKept() {
  SubdivisionLevelStore memory;
  const PatchLevels one = subdivided(0.0), two = subdivided(0.1);
  memory.keep(one);
  memory.keep(two);
  QVERIFY(memory.of(one.mesh()) && isSameVersion(memory.of(one.mesh())->mesh(0), one.mesh(0)));
  QVERIFY(memory.of(two.mesh()) && isSameVersion(memory.of(two.mesh())->mesh(0), two.mesh(0)));
  QVERIFY(!memory.of(one.mesh(0)));
  memory.keep(PatchLevels(one.mesh(), one.patch()));  // its levels are no more
  QVERIFY(!memory.of(one.mesh()));
}

void SubdivisionLevelStoreTest::forgetsTheOldest() {
  SubdivisionLevelStore memory;
  for (int i = 0; i < 30; ++i) memory.keep(subdivided(0.01 * i));
  QVERIFY(!memory.of(subdivided(0.0).mesh()));
  QVERIFY(memory.of(subdivided(0.29).mesh()));
}

HANDWHEEL_TEST(SubdivisionLevelStoreTest)
#include "SubdivisionLevelStoreTest.moc"
