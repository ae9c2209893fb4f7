// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/FarthestRemovedVertex.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/repair/Repair.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

namespace {

// A cube of side 1 with an open flap of two triangles that stands out of the middle of its top.
TriangleSoup cubeWithFlap(double height) {
  TriangleSoup s = test::cube();
  const auto first = static_cast<std::uint32_t>(s.points.size());
  for (const Vec3& p : {Vec3(0.4, 0.5, 1), Vec3(0.6, 0.5, 1), Vec3(0.6, 0.5, 1 + height), Vec3(0.4, 0.5, 1 + height)})
    s.points.push_back(p);
  s.triangles.push_back({first, first + 1, first + 2});
  s.triangles.push_back({first, first + 2, first + 3});
  return s;
}

}  // namespace

class FarthestRemovedVertexTest : public QObject {
  Q_OBJECT

 private slots:
  void howFarItStoodOut();
  void fromTheToleranceOn();
  void whatIsInsideDoesNotCount();
  void whatHasOnlyMovedIsNotGone();
  void neitherDebrisNorWhatAUnionHides();
  void extremes();
  void stopsWhenCancelled();
};

void FarthestRemovedVertexTest::howFarItStoodOut() {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(1e7, -1e7, 1e7)}) {
      const HalfEdgeMesh before = buildMesh(test::moved(cubeWithFlap(0.7), shift, scale)).mesh;
      const HalfEdgeMesh after = buildMesh(test::moved(test::cube(), shift, scale)).mesh;
      const double digits = 1e-9 * (shift.norm() + scale);
      const auto removed = farthestRemovedVertex(before, after);
      if (scale < digits) continue;  // lost by the rounding of the coordinates
      QVERIFY(removed.has_value());
      QVERIFY(std::abs(removed->distance - 0.7 * scale) <= digits);
      QVERIFY(std::abs(removed->position.z() - (shift.z() + 1.7 * scale)) <= digits);
      QVERIFY(!farthestRemovedVertex(after, after));
    }
  }
}

void FarthestRemovedVertexTest::fromTheToleranceOn() {
  const HalfEdgeMesh after = buildMesh(test::cube()).mesh;
  for (const double share : {0.98, 1.02}) {
    // The diagonal is that of the cube with the flap.
    double height = 0.0;
    for (int i = 0; i < 50; ++i) height = share * tolerance::kRemovedPart * Vec3(1, 1, 1 + height).norm();
    QCOMPARE(farthestRemovedVertex(buildMesh(cubeWithFlap(height)).mesh, after).has_value(), share > 1.0);
  }
}

void FarthestRemovedVertexTest::whatIsInsideDoesNotCount() {
  TriangleSoup two = test::cube();
  test::append(two, test::moved(test::cube(), {0.5, 0.5, 0.5}, 0.25));
  QVERIFY(!farthestRemovedVertex(buildMesh(two).mesh, buildMesh(test::cube()).mesh));
}

// Merged or rounded vertices, and a surface that was made anew.
void FarthestRemovedVertexTest::whatHasOnlyMovedIsNotGone() {
  TriangleSoup moved = test::icosphere(3);
  for (Vec3& p : moved.points) p += 1e-7 * Vec3(1, 2, 3);
  QVERIFY(!farthestRemovedVertex(buildMesh(test::icosphere(3)).mesh, buildMesh(moved).mesh));
  std::reverse(moved.triangles.begin(), moved.triangles.end());
  QVERIFY(!farthestRemovedVertex(buildMesh(test::icosphere(3)).mesh, buildMesh(moved).mesh));
}

void FarthestRemovedVertexTest::neitherDebrisNorWhatAUnionHides() {
  // A stray flake is debris, which was asked for to be removed.
  TriangleSoup withFlake = test::icosphere(4);
  test::append(withFlake, {{{9, 0, 0}, {9.01, 0, 0}, {9, 0.01, 0}}, {{0, 1, 2}}});
  HalfEdgeMesh mesh = buildMesh(withFlake).mesh;
  RepairOptions options;
  options.removeDebris = true;
  const RepairReport clean = repair(mesh, options);
  QCOMPARE(clean.removedDebris, std::size_t{1});
  QVERIFY(!clean.removed);

  // The common part of two solids is inside their union.
  TriangleSoup two = test::cube();
  test::append(two, test::moved(test::cube(), {0.5, 0.4, 0.3}));
  HalfEdgeMesh both = buildMesh(two).mesh;
  options.cutCrossings = options.uniteSolids = true;
  const RepairReport united = repair(both, options);
  QVERIFY(united.innerFaces > 0);
  QVERIFY(!united.removed);
}

void FarthestRemovedVertexTest::extremes() {
  const HalfEdgeMesh nothing, cube = buildMesh(test::cube()).mesh;
  QVERIFY(!farthestRemovedVertex(nothing, nothing));
  QVERIFY(!farthestRemovedVertex(nothing, cube));
  QVERIFY(!farthestRemovedVertex(cube, nothing));
  TriangleSoup odd = cubeWithFlap(0.5);
  odd.points.back() = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  QVERIFY(!farthestRemovedVertex(buildMesh(odd).mesh, cube) ||
          farthestRemovedVertex(buildMesh(odd).mesh, cube)->distance <= 0.5 + 1e-12);
}

void FarthestRemovedVertexTest::stopsWhenCancelled() {
  JobState state;
  state.cancelled = true;
  QVERIFY(!farthestRemovedVertex(buildMesh(cubeWithFlap(0.7)).mesh, buildMesh(test::cube()).mesh, Progress(state)));
}

HANDWHEEL_TEST(FarthestRemovedVertexTest)
#include "FarthestRemovedVertexTest.moc"
