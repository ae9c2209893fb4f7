// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/WallThickness.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/search/SmoothNormal.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class WallThicknessTest : public QObject {
  Q_OBJECT

 private slots:
  void slab();
  void nearTheEdgeOfASlab();
  void sphereShell();
  void solidSphere();
  void wedge();
  void overlappingBodies();
  void ballFitsInside();
  void nothingBehind();
  void farFromTheOrigin();
  void smoothNormals();
};

namespace {

FaceHierarchy facesOf(const TriangleSoup& soup) {
  return FaceHierarchy(buildMesh(soup).mesh);
}

TriangleSoup box(const Vec3& size) {
  TriangleSoup s = test::cube();
  for (Vec3& p : s.points) p = p.cwiseProduct(size);
  return s;
}

// Below the point that a ray from above or outside meets first.
std::optional<WallThickness> at(const FaceHierarchy& faces, const Vec3& origin, const Vec3& direction) {
  const auto hit = faces.firstHit({origin, direction});
  if (!hit) qFatal("the ray misses");
  return wallThickness(faces, hit->face, hit->point);
}

}  // namespace

void WallThicknessTest::slab() {
  const FaceHierarchy faces = facesOf(box({100, 80, 3}));
  for (const Vec3& point : {Vec3(50, 40, 10), Vec3(20, 70, 10), Vec3(90.5, 11.25, 10)}) {
    const auto t = at(faces, point, -Vec3::UnitZ());
    QVERIFY(t && std::abs(t->alongNormal - 3.0) < 1e-9 && std::abs(t->ballDiameter - 3.0) < 0.03);
    QVERIFY((t->opposite - Vec3(point.x(), point.y(), 0.0)).norm() < 1e-9);
    QVERIFY((t->ballCentre - Vec3(point.x(), point.y(), 1.5)).norm() < 0.03);
  }
}

// A third wall is as near as d: the ball between them has that radius.
void WallThicknessTest::nearTheEdgeOfASlab() {
  const FaceHierarchy faces = facesOf(box({100, 80, 10}));
  for (const double d : {0.5, 1.0, 3.0}) {
    const auto t = at(faces, {d, 40, 20}, -Vec3::UnitZ());
    QVERIFY(t && std::abs(t->alongNormal - 10.0) < 1e-9);
    QVERIFY2(std::abs(t->ballDiameter - 2.0 * d) < 0.03 * d, qPrintable(QString::number(t->ballDiameter)));
  }
}

// By both measures the distance of two concentric spheres, to what chords cut off.
void WallThicknessTest::sphereShell() {
  TriangleSoup shell = test::moved(test::icosphere(4), Vec3::Zero(), 10.0);
  test::append(shell, test::turnedOver(test::moved(test::icosphere(4), Vec3::Zero(), 8.0)));
  const FaceHierarchy faces = facesOf(shell);
  for (const Vec3& direction : test::directions(60)) {
    for (const auto& t : {at(faces, 20.0 * direction, -direction), at(faces, Vec3::Zero(), direction)}) {
      QVERIFY(t && std::abs(t->alongNormal - 2.0) < 0.05);
      QVERIFY2(std::abs(t->ballDiameter - 2.0) < 0.07, qPrintable(QString::number(t->ballDiameter)));
    }
  }
}

void WallThicknessTest::solidSphere() {
  const FaceHierarchy faces = facesOf(test::icosphere(4));
  for (const Vec3& direction : test::directions(60)) {
    const auto t = at(faces, 2.0 * direction, -direction);
    QVERIFY(t && std::abs(t->alongNormal - 2.0) < 0.02);
    QVERIFY2(std::abs(t->ballDiameter - 2.0) < 0.05, qPrintable(QString::number(t->ballDiameter)));
  }
}

// Two walls at an angle of θ: straight inwards the other is s · tan θ away at the distance s from the edge; the ball
// that touches both has its centre on the half angle, so the radius s · tan θ/2.
void WallThicknessTest::wedge() {
  QVERIFY(rc::check("a wedge is as thick as its angle says", [] {
    const double angle = 0.1 + 1.2 * *rc::gen::inRange(0, 1000) / 1000.0;
    const double s = 1.0 + 7.0 * *rc::gen::inRange(0, 1000) / 1000.0;
    // A prism with the edge along y; its lower side in z = 0.
    const double h = 40.0 * std::tan(angle);
    const TriangleSoup prism{
        {Vec3(0, 0, 0), Vec3(40, 0, 0), Vec3(40, 0, h), Vec3(0, 60, 0), Vec3(40, 60, 0), Vec3(40, 60, h)},
        {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}}};
    const FaceHierarchy faces(buildMesh(prism).mesh);
    const auto hit = faces.firstHit({Vec3(s, 30.0, -1.0), Vec3::UnitZ()});
    RC_ASSERT(bool(hit));
    const auto t = wallThickness(faces, hit->face, hit->point);
    RC_ASSERT(bool(t));
    RC_ASSERT(std::abs(t->alongNormal - s * std::tan(angle)) < 1e-9 * h);
    const double ball = 2.0 * s * std::tan(0.5 * angle);
    RC_ASSERT(std::abs(t->ballDiameter - ball) < 0.02 * ball);
  }));
}

// If one body starts inside another, the thickness extends to the far wall of both.
void WallThicknessTest::overlappingBodies() {
  TriangleSoup two = test::cube(4.0);
  test::append(two, test::cube(4.0, Vec3(0.5, 0.5, 2.0)));
  const auto t = at(facesOf(two), {2.0, 2.0, 20.0}, -Vec3::UnitZ());
  QVERIFY(t && std::abs(t->alongNormal - 6.0) < 1e-9);
  TriangleSoup within = test::cube(4.0);
  test::append(within, test::cube(1.0, Vec3(1.5, 1.5, 3.5)));
  const auto through = at(facesOf(within), {2.0, 2.0, 20.0}, -Vec3::UnitZ());
  QVERIFY(through && std::abs(through->alongNormal - 4.5) < 1e-9);
}

// On any closed body: no more than along the normal, touching at the point, and nothing of the surface inside.
void WallThicknessTest::ballFitsInside() {
  for (const TriangleSoup& shape : {test::bumpySphere(3), test::torus(40, 20), test::cube(), test::tetrahedron()}) {
    const FaceHierarchy faces = facesOf(shape);
    for (const Vec3& direction : test::directions(200)) {
      const auto hit = faces.firstHit({10.0 * direction + Vec3(0.01, 0.3, 0.2), -direction});
      if (!hit) continue;
      const auto t = wallThickness(faces, hit->face, hit->point);
      QVERIFY(t.has_value());
      QVERIFY(t->ballDiameter > 0.0 && t->ballDiameter <= t->alongNormal);
      const double radius = 0.5 * t->ballDiameter;
      QVERIFY(std::abs((t->ballCentre - hit->point).norm() - radius) < 1e-9);
      // Relative to the smooth normal, the faces around the point obstruct the ball by their tilt.
      const TrianglePoints corners = faces.mesh().points(hit->face);
      const Vec3 flat = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
      const double tilt = std::acos(std::min(1.0, flat.dot(smoothNormal(faces.mesh(), hit->face, hit->point))));
      QVERIFY((*faces.nearest(t->ballCentre) - t->ballCentre).norm() >= 0.989 * std::cos(2.0 * tilt) * radius);
    }
  }
}

void WallThicknessTest::nothingBehind() {
  const TriangleSoup sheet{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(2, 0, 0)}, {{0, 1, 2}, {0, 3, 1}}};
  const FaceHierarchy faces = facesOf(sheet);
  QVERIFY(!wallThickness(faces, 0, Vec3(0.2, 0.2, 0)));
  QVERIFY(!wallThickness(faces, 1, Vec3(1, 0, 0)));  // no area
}

void WallThicknessTest::farFromTheOrigin() {
  const Vec3 far(1e6, -2e6, 5e5);
  const FaceHierarchy faces = facesOf(test::moved(box({100, 80, 3}), far));
  const auto t = at(faces, far + Vec3(50, 40, 10), -Vec3::UnitZ());
  QVERIFY(t && std::abs(t->alongNormal - 3.0) < 1e-6 && std::abs(t->ballDiameter - 3.0) < 0.03);
}

void WallThicknessTest::smoothNormals() {
  const HalfEdgeMesh ball = buildMesh(test::icosphere(3)).mesh, die = buildMesh(test::cube()).mesh;
  for (Face f = 0; f < ball.faceSlots(); ++f) {
    const TrianglePoints t = ball.points(f);
    const Vec3 p = 0.2 * t[0] + 0.5 * t[1] + 0.3 * t[2];
    QVERIFY((smoothNormal(ball, f, p) - p.normalized()).norm() < 0.01);
  }
  for (Face f = 0; f < die.faceSlots(); ++f) {
    const TrianglePoints t = die.points(f);
    const Vec3 flat = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    for (const Vec3& p : {t[0], t[1], Vec3((t[0] + t[1] + t[2]) / 3.0)}) {
      QVERIFY((smoothNormal(die, f, p) - flat).norm() < 1e-12);
    }
  }
}

HANDWHEEL_TEST(WallThicknessTest)
#include "WallThicknessTest.moc"
