// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/FaceHierarchy.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class FaceHierarchyTest : public QObject {
  Q_OBJECT

 private slots:
  void facesKeepTheirNumbers();
  void keepsItsVersion();
  void hidden();
  void oddRays();
  void projectionsOnThePlane();
  void pixels();
};

namespace {

const double kNan = std::nan("");

Ray rayDownAt(double x, double y) {
  return {Vec3(x, y, 10.0), -Vec3::UnitZ()};
}

// Two sheets of one square, face 0 and 1 at z = 0, 2 and 3 at z = 1.
HalfEdgeMesh twoSheets() {
  const auto sheet = [](double z) {
    return test::grid(2, 2, false, false, [&](std::uint32_t i, std::uint32_t j) { return Vec3(j, i, z); });
  };
  TriangleSoup soup = sheet(0.0);
  test::append(soup, sheet(1.0));
  return buildMesh(soup).mesh;
}

}  // namespace

void FaceHierarchyTest::facesKeepTheirNumbers() {
  HalfEdgeMesh mesh = twoSheets();
  const auto upper = FaceHierarchy(mesh).firstHit(rayDownAt(0.2, 0.6));
  QVERIFY(upper && upper->face >= 2 && upper->distance == 9.0 && upper->point == Vec3(0.2, 0.6, 1.0));
  mesh.removeFace(upper->face);
  const auto lower = FaceHierarchy(mesh).firstHit(rayDownAt(0.2, 0.6));
  QVERIFY(lower && lower->face == upper->face - 2 && lower->distance == 10.0);
}

void FaceHierarchyTest::keepsItsVersion() {
  HalfEdgeMesh mesh = twoSheets();
  const FaceHierarchy faces(mesh);
  mesh.removeFace(2);
  mesh.removeFace(3);
  QCOMPARE(faces.mesh().liveFaceCount(), std::size_t(4));
  QVERIFY(faces.firstHit(rayDownAt(0.2, 0.6))->face >= 2);
}

void FaceHierarchyTest::hidden() {
  const FaceHierarchy faces(twoSheets());
  const Vec3 low(0.2, 0.6, 0.0), high(0.2, 0.6, 1.0);
  for (const std::optional<Vec3>& eye : {std::optional<Vec3>(), std::optional<Vec3>(Vec3(0.3, 0.5, 1e3))}) {
    QVERIFY(faces.isHidden(low, eye, -Vec3::UnitZ()));
    QVERIFY(faces.isHidden(low, eye, -Vec3::UnitZ(), 0.9));
    QVERIFY(!faces.isHidden(low, eye, -Vec3::UnitZ(), 1.1));
    QVERIFY(!faces.isHidden(high, eye, -Vec3::UnitZ()));
  }
  QVERIFY(!faces.isHidden(low, std::nullopt, Vec3::UnitZ()));
  QVERIFY(faces.isHidden(high, std::nullopt, Vec3::UnitZ()));
  QVERIFY(faces.isHidden(low + Vec3(0, 0, -1e9), std::nullopt, -Vec3::UnitZ()));
  QVERIFY(!FaceHierarchy(HalfEdgeMesh()).isHidden(low, std::nullopt, -Vec3::UnitZ()));
}

void FaceHierarchyTest::oddRays() {
  const FaceHierarchy faces(twoSheets());
  QVERIFY(!faces.firstHit({Vec3(kNan, 0, 0), Vec3::UnitX()}));
  QVERIFY(!faces.firstHit({Vec3::Zero(), Vec3(0, kNan, 1)}));
  QVERIFY(!faces.firstHit({Vec3::Zero(), Vec3::Zero()}));
  QVERIFY(!faces.isHidden(Vec3(kNan, 0, 0), std::nullopt, Vec3::UnitX()));
  QVERIFY(!faces.isHidden(Vec3::Zero(), Vec3::Zero().eval(), Vec3::UnitX()));
  QVERIFY(!(Ray{Vec3::Zero(), Vec3::Zero()}).isUsable());
  QVERIFY(!(Ray{Vec3::Zero(), Vec3(0, kNan, 1)}).isUsable());
}

// Points on one line of sight have the same projection, and projections preserve lengths across the line of sight.
void FaceHierarchyTest::projectionsOnThePlane() {
  const Vec3 forward(1, -2, 3), eye(1e7, -5, 2), right = forward.unitOrthogonal();
  const PickRayPlane parallel(std::nullopt, eye, forward), perspective(eye, Vec3::Zero(), forward);
  const Vec3 p = eye + 2.0 * forward.normalized() + 0.5 * right;
  QVERIFY((*parallel.projected(p) - *parallel.projected(Vec3(p + 7.0 * forward))).norm() < 1e-8);
  QVERIFY(std::abs(parallel.projected(p)->norm() - 0.5) < 1e-8);
  QVERIFY(std::abs(perspective.projected(p)->norm() - 0.25) < 1e-8);
  QVERIFY((*perspective.projected(p) - *perspective.projected(Ray{eye, p - eye})).norm() < 1e-8);
  QVERIFY(std::abs(perspective.depth(p) - 2.0) < 1e-8);
  QVERIFY(!perspective.projected(Vec3(eye - forward)));
  QVERIFY(!perspective.projected(eye));
  QVERIFY(parallel.projected(Vec3(eye - forward)));
}

void FaceHierarchyTest::pixels() {
  PickRay pickRay{{Vec3::Zero(), Vec3::UnitZ()}, std::nullopt, 0.5, 100.0};
  QCOMPARE(pickRay.pixelAt(Vec3(3, 4, 200)), 0.5);
  pickRay.eye = Vec3::Zero();
  QCOMPARE(pickRay.pixelAt(Vec3(3, 4, 200)), 1.0);
  pickRay.focus = 0.0;
  QCOMPARE(pickRay.pixelAt(Vec3(3, 4, 200)), 0.5);
}

HANDWHEEL_TEST(FaceHierarchyTest)
#include "FaceHierarchyTest.moc"
