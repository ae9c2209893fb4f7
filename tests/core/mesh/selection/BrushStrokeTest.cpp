// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/BrushStroke.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/ClosestPoint.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class BrushStrokeTest : public QObject {
  Q_OBJECT

 private slots:
  void aDiscOnAPlane();
  void aStrokeOnAPlane();
  void notThroughAThinWall();
  void aroundTheRimOfAThinWall();
  void aStrokeOverASphereHangsTogether();
  void anIslandOnThePath();
  void toASurfaceBehind();
  void eachFaceOnce();
  void extremes();
};

namespace {

// n × n squares with corners on whole numbers, in z = 0.
TriangleSoup sheet(std::uint32_t n) {
  return test::grid(n + 1, n + 1, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(j, i, 0.0); });
}

std::shared_ptr<const FaceHierarchy> hierarchyOf(const TriangleSoup& soup) {
  return std::make_shared<FaceHierarchy>(buildMesh(soup).mesh);
}

Ray downAt(double x, double y, double z = 100.0) {
  return {Vec3(x, y, z), -Vec3::UnitZ()};
}

FaceSelection painted(const std::shared_ptr<const FaceHierarchy>& faces, const std::vector<BrushStroke::Touch>& path) {
  BrushStroke stroke(faces);
  FaceSelection result;
  for (const BrushStroke::Touch& touch : path)
    for (const Face f : stroke.moveTo(touch)) result.add(f);
  return result;
}

double distance(const HalfEdgeMesh& mesh, Face f, const Vec3& p) {
  const auto [a, b, c] = mesh.points(f);
  return (closestOnTriangle(p, a, b, c) - p).norm();
}

}  // namespace

void BrushStrokeTest::aDiscOnAPlane() {
  for (const double far : {0.0, 1e7}) {
    const auto faces = hierarchyOf(test::moved(sheet(20), Vec3(far, -far, far)));
    for (const double radius : {1e-9, 0.3, 1.0, 4.7, 100.0}) {
      const Vec3 p = Vec3(9.3, 11.6, 0.0) + Vec3(far, -far, far);
      const FaceSelection disc = painted(faces, {{downAt(p.x(), p.y(), far + 50.0), radius}});
      for (Face f = 0; f < faces->mesh().faceSlots(); ++f)
        QCOMPARE(disc.contains(f), distance(faces->mesh(), f, p) <= radius);
    }
  }
}

// A moved disc covers the points within its radius of the path.
void BrushStrokeTest::aStrokeOnAPlane() {
  const auto faces = hierarchyOf(sheet(15));
  QVERIFY(rc::check([&] {
    const auto coordinate = [] { return 0.01 * *rc::gen::inRange(1, 1499); };
    const double radius = *rc::gen::element(0.02, 0.5, 2.0);
    const Vec3 a(coordinate(), coordinate(), 0.0), b(coordinate(), coordinate(), 0.0);
    const FaceSelection result = painted(faces, {{downAt(a.x(), a.y()), radius}, {downAt(b.x(), b.y()), radius}});
    const int steps = 500;
    const double step = (b - a).norm() / steps;
    for (Face f = 0; f < faces->mesh().faceSlots(); ++f) {
      double least = 1e9;
      for (int i = 0; i <= steps && (i == 0 || least > radius); ++i)
        least = std::min(least, distance(faces->mesh(), f, a + (b - a) * i / steps));
      if (least <= radius - 1e-9) RC_ASSERT(result.contains(f));
      if (result.contains(f)) RC_ASSERT(least <= radius + step);
    }
  }));
}

void BrushStrokeTest::notThroughAThinWall() {
  TriangleSoup wall = sheet(20);
  test::append(wall, test::moved(test::turnedOver(sheet(20)), Vec3(0, 0, -0.01)));
  const auto apart = hierarchyOf(wall);  // two sheets
  const std::size_t one = apart->mesh().faceSlots() / 2;
  const FaceSelection faces = painted(apart, {{downAt(3, 3), 5.0}, {downAt(17, 15), 5.0}});
  QVERIFY(faces.count() > one / 4);
  faces.forEach([&](Face f) { QVERIFY(f < one); });
}

// A box: beyond its edge the ball meets the side and the lower face as well, but in its middle only the upper one.
void BrushStrokeTest::aroundTheRimOfAThinWall() {
  TriangleSoup box = test::cube();
  for (Vec3& p : box.points) p = Vec3(10 * p.x(), 10 * p.y(), 0.1 * p.z());
  const auto faces = hierarchyOf(box);
  QCOMPARE(painted(faces, {{downAt(5, 5.5), 0.5}}).count(), std::size_t(2));
  const auto lowest = [&](const FaceSelection& s) {
    double z = 1.0;
    s.forEach([&](Face f) {
      const auto p = faces->mesh().points(f);
      z = std::min(z, std::max({p[0].z(), p[1].z(), p[2].z()}));
    });
    return z;
  };
  QCOMPARE(lowest(painted(faces, {{downAt(5, 5.5), 1.0}})), 0.1);
  QCOMPARE(lowest(painted(faces, {{downAt(9.95, 5.0), 0.04}})), 0.1);
  QCOMPARE(lowest(painted(faces, {{downAt(9.95, 5.0), 1.0}})), 0.0);
}

void BrushStrokeTest::aStrokeOverASphereHangsTogether() {
  const auto faces = hierarchyOf(test::icosphere(5));
  QVERIFY(rc::check([&] {
    const auto coordinate = [] { return 0.001 * *rc::gen::inRange(-950, 950); };
    const double radius = *rc::gen::element(0.001, 0.02, 0.3);
    const Vec3 eye(0, 0, 3);
    const auto at = [&](double x, double y) {
      return BrushStroke::Touch{{eye, (Vec3(x, y, 0.0) - eye).normalized()}, radius};
    };
    const auto a = at(coordinate(), coordinate()), b = at(coordinate(), coordinate());
    if (!faces->firstHit(a.ray) || !faces->firstHit(b.ray)) return;
    const FaceSelection result = painted(faces, {a, b});
    // All faces that the pointer passed over are painted.
    for (int i = 0; i <= 1000; ++i) {
      const Vec3 direction = (1000 - i) * a.ray.direction + i * b.ray.direction;
      if (const auto hit = faces->firstHit({eye, direction})) RC_ASSERT(result.contains(hit->face));
    }
    // In one piece: growing from one of its faces inside it reaches all.
    FaceSelection reached{result.faces().front()};
    for (std::size_t before = 0; before != reached.count();) {
      before = reached.count();
      FaceSelection ring = grownByRing(faces->mesh(), reached);
      ring.remove(result.inverted(faces->mesh()));
      reached = ring;
    }
    RC_ASSERT(reached == result);
  }));
}

void BrushStrokeTest::anIslandOnThePath() {
  TriangleSoup soup = sheet(2);
  test::append(soup, test::moved(sheet(2), Vec3(30.0, 0.0, 5.0)));
  test::append(soup, test::moved(sheet(2), Vec3(98.0, 0.0, 0.0)));
  const auto faces = hierarchyOf(soup);
  QCOMPARE(painted(faces, {{downAt(1, 1), 3.0}, {downAt(99, 1), 3.0}}).count(), std::size_t(24));
  // From nothing to nothing, too.
  QCOMPARE(painted(faces, {{downAt(-20, 1), 3.0}, {downAt(20, 1), 3.0}}).count(), std::size_t(8));
  QCOMPARE(painted(faces, {{downAt(20, 1), 3.0}}).count(), std::size_t(0));
}

// The pointer slides off the upper sheet onto the lower one: the brush does not go through the air between them.
void BrushStrokeTest::toASurfaceBehind() {
  TriangleSoup soup = sheet(10);
  test::append(soup, test::moved(sheet(10), Vec3(10.0, 0.0, -50.0)));
  test::append(soup, test::moved(sheet(1), Vec3(9.5, 4.5, -25.0)));  // hidden by the upper one, half of it
  const auto faces = hierarchyOf(soup);
  const FaceSelection result = painted(faces, {{downAt(8, 5), 0.2}, {downAt(12, 5), 0.2}});
  const auto hitAt = [&](double x) { return faces->firstHit(downAt(x, 5.1))->face; };
  for (const double x : {8.0, 9.0, 9.4, 9.95, 10.9, 12.0}) QVERIFY(result.contains(hitAt(x)));
  QVERIFY(!result.contains(hitAt(2.0)) && !result.contains(hitAt(15.0)));
}

void BrushStrokeTest::eachFaceOnce() {
  const auto faces = hierarchyOf(sheet(10));
  BrushStroke stroke(faces);
  FaceSelection all;
  for (const double x : {1.0, 2.0, 2.0, 9.0, 1.0})
    for (const Face f : stroke.moveTo({downAt(x, 5.0), 1.5})) QVERIFY(all.add(f));
  QVERIFY(stroke.lastHit() && stroke.lastHit()->point.isApprox(Vec3(1, 5, 0)));
}

void BrushStrokeTest::extremes() {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const auto faces = hierarchyOf(sheet(4));
  QVERIFY(painted(faces, {{{Vec3(nan, 0, 1), -Vec3::UnitZ()}, 1.0}}).empty());
  QVERIFY(painted(faces, {{{Vec3(1, 1, 1), Vec3::Zero()}, 1.0}}).empty());
  for (const double radius : {0.0, -1e-300, nan}) QCOMPARE(painted(faces, {{downAt(1.2, 1.7), radius}}).count(), 1u);
  QCOMPARE(painted(faces, {{downAt(1.2, 1.7), inf}}).count(), std::size_t(32));
  QVERIFY(painted(faces, {{downAt(0.5, 0.2), 0.0}, {downAt(3.5, 3.2), 0.0}}).count() >= 7);
  QVERIFY(painted(hierarchyOf({}), {{downAt(0, 0), 1.0}, {downAt(9, 9), 1.0}}).empty());
  // A direction that turns round has no middle.
  QCOMPARE(painted(faces, {{downAt(1.2, 1.7), 0.1}, {{Vec3(1.2, 1.7, -5.0), Vec3::UnitZ()}, 0.1}}).count(), 1u);
  // A thin needle and a folded face on the path.
  TriangleSoup soup = sheet(4);
  test::addNeedles(soup, 10, 2, {0.5});
  soup.triangles.push_back({3, 3, 4});
  const auto needles = hierarchyOf(soup);
  QCOMPARE(painted(needles, {{downAt(2.2, 1.7), 50.0}}).count(), std::size_t(34));
}

HANDWHEEL_TEST(BrushStrokeTest)
#include "BrushStrokeTest.moc"
