// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryPick.h"

#include "HoleShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class BoundaryPickTest : public QObject {
  Q_OBJECT

 private slots:
  void nearestWithinReach();
  void notBehindTheSurface();
  void fromAnEye();
  void withoutOne();
  void unusable();
};

namespace {

struct Scene {
  HalfEdgeMesh mesh;
  std::vector<BoundaryLoop> loops;
  FaceHierarchy faces;

  explicit Scene(const TriangleSoup& soup) : mesh(buildMesh(soup).mesh), loops(findBoundaryLoops(mesh)), faces(mesh) {}

  std::optional<Vec3> pick(const PickRay& pickRay, const std::optional<Vec3>& without = {}) const {
    const auto point = pickBoundaryPoint(mesh, loops, faces, pickRay, without);
    if (!point) return std::nullopt;
    const auto& own = loops[point->loop].halfEdges;
    if (std::find(own.begin(), own.end(), point->at) == own.end()) qFatal("it is of another loop");
    return mesh.position(mesh.from(point->at));
  }
};

PickRay above(double x, double y, double pixel) {
  return {{Vec3(x, y, 100), -Vec3::UnitZ()}, std::nullopt, pixel};
}

}  // namespace

void BoundaryPickTest::nearestWithinReach() {
  const Scene scene(test::plateWithHole());
  QCOMPARE(scene.pick(above(-1.9, 0.2, 0.1)), Vec3(-2, 0, 0));
  QCOMPARE(scene.pick(above(-1.9, 0.7, 0.1)), Vec3(-2, 1, 0));
  QCOMPARE(scene.pick(above(-2.0 + 11.9 * 0.01, 0.0, 0.01)), Vec3(-2, 0, 0));
  QVERIFY(!scene.pick(above(-2.0 + 12.1 * 0.01, 0.0, 0.01)));
  QVERIFY(!scene.pick(above(-3.5, 0.0, 0.01)));  // inner vertices do not count
}

void BoundaryPickTest::notBehindTheSurface() {
  TriangleSoup soup = test::plateWithHole();
  test::append(soup, test::moved(test::disc(12, 2, 6.0), Vec3(0, 0, 5)));
  const Scene scene(soup);
  QVERIFY(!scene.pick(above(-2, 0, 0.05)));
  const PickRay below{{Vec3(-2, 0, -100), Vec3::UnitZ()}, std::nullopt, 0.05};
  QCOMPARE(scene.pick(below), Vec3(-2, 0, 0));
}

void BoundaryPickTest::fromAnEye() {
  const Scene scene(test::plateWithHole());
  const Vec3 eye(0, 0, 10);
  const PickRay pickRay{{eye, (Vec3(-2.1, 0, 0) - eye).normalized()}, eye, 0.05, 10.0};
  QCOMPARE(scene.pick(pickRay), Vec3(-2, 0, 0));
  const PickRay away{{eye, (eye - Vec3(-2, 0, 0)).normalized()}, eye, 0.05, 10.0};
  QVERIFY(!scene.pick(away));
}

void BoundaryPickTest::withoutOne() {
  const Scene scene(test::plateWithPinchedHole());
  QCOMPARE(scene.pick(above(0.1, 0.1, 0.2)), Vec3(0, 0, 0));
  QVERIFY(scene.pick(above(0.1, 0.1, 0.2), Vec3::Zero()) != std::optional(Vec3(0, 0, 0)));
  QVERIFY(!scene.pick(above(0, 0, 0.05), Vec3::Zero()));
}

void BoundaryPickTest::unusable() {
  const Scene scene(test::plateWithHole());
  for (const Vec3& direction : {Vec3(0, 0, 0), Vec3(NAN, 0, 1), Vec3(INFINITY, 0, 0)})
    QVERIFY(!scene.pick({{Vec3(0, 0, 9), direction}, std::nullopt, 0.1}));
  QVERIFY(!scene.pick(above(-2.5, 0, 0.0)));
  QVERIFY(!Scene({}).pick(above(0, 0, 1)));
}

HANDWHEEL_TEST(BoundaryPickTest)
#include "BoundaryPickTest.moc"
