// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/SubdivisionLevelStore.h"

#include "MeshDocuments.h"
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
  void editsElsewhereKeepTheLevels();
  void patchesApartFromOneAnother();
};

namespace {

PatchLevels subdivided(double x) {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  mesh.setPosition(0, mesh.position(0) + Vec3(x, 0, 0));
  PatchLevels levels(mesh, FaceSelection::all(mesh));
  levels.refine();
  return levels;
}

// Returns the faces of a sphere of radius 1 around a point on it.
FaceSelection around(const HalfEdgeMesh& mesh, const Vec3& centre) {
  return FaceSelection::where(mesh.faceSlots(), [&](Face f) {
    const auto [p, q, r] = mesh.points(f);
    return mesh.isLive(f) && ((p + q + r) / 3.0 - centre).norm() < 0.5;
  });
}

void commitLevels(MeshDocument& document, const PatchLevels& levels) {
  document.commit("Subdivide", inspected(levels.mesh()));
  document.keepLevels(levels);
}

void commitMove(MeshDocument& document, const Vec3& from) {
  HalfEdgeMesh mesh = document.mesh();
  const Vertex v = mesh.triangle(around(mesh, from).faces().front())[0];
  mesh.setPosition(v, 1.01 * mesh.position(v));
  document.commit("Move", inspected(mesh));
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

// Also when there have been more edits than the store has entries.
void SubdivisionLevelStoreTest::editsElsewhereKeepTheLevels() {
  const auto document = test::meshDocument(test::icosphere(3));
  PatchLevels levels(document->mesh(), around(document->mesh(), Vec3::UnitZ()));
  levels.refine();
  levels.refine();
  commitLevels(*document, levels);
  constexpr int kEdits = 50;
  for (int i = 0; i < kEdits; ++i) {
    commitMove(*document, -Vec3::UnitZ());
    QVERIFY(document->levels() && document->levels()->finest() == 2);
    QVERIFY(isSameVersion(document->levels()->mesh(), document->mesh()));
  }
  commitMove(*document, Vec3::UnitZ());
  QVERIFY(!document->levels());
  for (int i = 0; i <= kEdits; ++i) {
    document->history()->undo();
    QVERIFY(document->levels() && document->levels()->finest() == 2);
  }
  for (std::size_t i = 0; i <= 2; ++i) QVERIFY(isSameVersion(document->levels()->mesh(i), levels.mesh(i)));
  document->history()->undo();
  QVERIFY(!document->levels());
  document->history()->redo();
  document->history()->redo();
  QVERIFY(document->levels() && document->levels()->finest() == 2);
}

// To subdivide one is an edit elsewhere for the other.
void SubdivisionLevelStoreTest::patchesApartFromOneAnother() {
  const auto document = test::meshDocument(test::icosphere(3));
  PatchLevels upper(document->mesh(), around(document->mesh(), Vec3::UnitZ()));
  upper.refine();
  commitLevels(*document, upper);
  PatchLevels lower(document->mesh(), around(document->mesh(), -Vec3::UnitZ()));
  lower.refine();
  lower.refine();
  commitLevels(*document, lower);
  QVERIFY(document->levels()->patch() == lower.patch());  // the newest
  QCOMPARE(document->levels(lower.patch())->finest(), std::size_t(2));
  QCOMPARE(document->levels(upper.patch())->finest(), std::size_t(1));
  QVERIFY(!document->levels(around(upper.mesh(), Vec3::UnitX())));
  document->history()->undo();
  QVERIFY(document->levels()->patch() == upper.patch());
  QVERIFY(!document->levels(lower.patch()));
  document->history()->redo();
  QVERIFY(document->levels(lower.patch()) && document->levels(upper.patch()));
  document->keepLevels(PatchLevels(document->mesh(), {}));  // levels of a stroke on the whole surface
  QVERIFY(document->levels(lower.patch()) && document->levels(upper.patch()));
}

HANDWHEEL_TEST(SubdivisionLevelStoreTest)
#include "SubdivisionLevelStoreTest.moc"
