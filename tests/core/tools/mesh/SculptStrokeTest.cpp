// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/sculpt/SculptStroke.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class SculptStrokeTest : public QObject {
  Q_OBJECT

 private slots:
  void findsTheSurfaceWhereItIsNow();
  void findsTheSurfaceAfterSubdividing();
  void findsNothing();
  void dragsAcrossTheView();
};

namespace {

HalfEdgeMesh plate() {
  return buildMesh(test::grid(11, 11, false, false, [](auto i, auto j) { return Vec3(i, j, 0); })).mesh;
}

Ray down(double x, double y) {
  return {Vec3(x, y, 100), -Vec3::UnitZ()};
}

}  // namespace

// The faces were sorted before the plate became a ramp; seen aslant, the ray meets it elsewhere.
void SculptStrokeTest::findsTheSurfaceWhereItIsNow() {
  const FaceHierarchy sorted(plate());
  HalfEdgeMesh ramp = plate();
  for (Vertex v = 0; v < ramp.vertexSlots(); ++v)
    ramp.setPosition(v, ramp.position(v) + Vec3(0, 0, 0.2 * ramp.position(v).x()));
  const Ray aslant{Vec3(0.3, 5.4, 5.0), Vec3(1, 0, -1).normalized()};
  const auto hit = hitOn(ramp, sorted, aslant, 3.0);
  QVERIFY(hit);
  QVERIFY((hit->point - Vec3(5.3 / 1.2, 5.4, 0.2 * 5.3 / 1.2)).norm() < 1e-12);
  const auto [p, q, r] = ramp.points(hit->face);
  QVERIFY(std::abs((q - p).cross(r - p).normalized().dot(hit->point - p)) < 1e-12);
  const auto same = hitOn(plate(), sorted, down(3.2, 4.7), 3.0);
  QVERIFY(same && (same->point - Vec3(3.2, 4.7, 0)).norm() < 1e-12);
}

void SculptStrokeTest::findsTheSurfaceAfterSubdividing() {
  const HalfEdgeMesh mesh = plate();
  const FaceHierarchy sorted(mesh);
  PatchLevels levels(mesh, FaceSelection::all(mesh));
  levels.refine();
  for (double x = 1.07; x < 9.0; x += 0.61) {
    const auto hit = hitOn(levels.mesh(), sorted, down(x, 0.9 * x), 3.0);
    QVERIFY(hit && (hit->point - Vec3(x, 0.9 * x, 0)).norm() < 1e-12);
  }
}

void SculptStrokeTest::findsNothing() {
  const HalfEdgeMesh mesh = plate();
  const FaceHierarchy sorted(mesh);
  QVERIFY(!hitOn(mesh, sorted, down(20, 5), 3.0));
  QVERIFY(!hitOn(mesh, sorted, {Vec3(5, 5, 100), Vec3::Zero()}, 3.0));
  HalfEdgeMesh without = mesh;
  for (Face f = 0; f < mesh.faceSlots(); ++f) without.removeFace(f);
  QVERIFY(!hitOn(without, sorted, down(5, 5), 3.0));
  QVERIFY(!hitOn(HalfEdgeMesh(), sorted, down(5, 5), 3.0));
}

// The surface point under the pointer stays under it, in the plane across the line of sight.
void SculptStrokeTest::dragsAcrossTheView() {
  const HalfEdgeMesh mesh = plate();
  const Vertex middle = test::vertexAt(mesh, Vec3(5, 5, 0));
  const Ray first{Vec3(0, 5, 5), Vec3(1, 0, -1).normalized()};
  const auto hit = hitOn(mesh, FaceHierarchy(mesh), first, 2.0);
  SculptStroke::Settings settings;
  settings.radius = 2.5;
  SculptStroke stroke(PatchLevels(mesh, {}), settings, *hit, first);
  stroke.dragTo({Vec3(0, 5.5, 5.5), first.direction});
  const Vec3 moved = stroke.levels().mesh().position(middle);
  QVERIFY((moved - Vec3(5.25, 5.5, 0.25)).norm() < 1e-12);
  stroke.dragTo({Vec3(0, 5, 5), -first.direction});  // away from the plane
  stroke.dragTo({Vec3(0, 5, 5), Vec3(1, 0, 1).normalized()});
  QVERIFY((stroke.levels().mesh().position(middle) - moved).norm() < 1e-12);
  stroke.dragBy(Vec3::Zero());
  QVERIFY(test::sameMesh(stroke.levels().mesh(), mesh));
}

HANDWHEEL_TEST(SculptStrokeTest)
#include "SculptStrokeTest.moc"
