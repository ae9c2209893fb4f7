// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/HolePick.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>

using namespace handwheel;

class HolePickTest : public QObject {
  Q_OBJECT

 private slots:
  void throughTheMiddleOfAHole_data();
  void throughTheMiddleOfAHole();
  void nearTheEdgeOfAHole_data() { throughTheMiddleOfAHole_data(); }
  void nearTheEdgeOfAHole();
  void notThroughTheSurface();
  void theSmallestOfThoseInSight();
  void rims();
  void extremes();
};

namespace {

struct HoledModel {
  HalfEdgeMesh mesh;
  std::vector<BoundaryLoop> loops;
  FaceHierarchy faces;

  explicit HoledModel(const TriangleSoup& soup)
      : mesh(buildMesh(soup).mesh), loops(findBoundaryLoops(mesh)), faces(mesh) {}
  std::optional<std::size_t> pick(const PickRay& pickRay) const { return pickHole(mesh, loops, faces, pickRay); }
  std::optional<std::size_t> loopAt(const Vec3& p) const {
    for (std::size_t i = 0; i < loops.size(); ++i)
      if ((loops[i].centre - p).norm() < 0.2) return i;
    return std::nullopt;
  }
};

// Returns a pick ray from the given position to p. The size of a pixel at p is 1/100.
PickRay lookingAt(const Vec3& p, const Vec3& from, bool perspective) {
  PickRay pickRay{{from, (p - from).normalized()}, std::nullopt, 0.01, 0.0};
  if (perspective) {
    pickRay.eye = from;
    pickRay.focus = 2.0 * (p - from).norm();
    pickRay.pixel = 0.02;
  }
  return pickRay;
}

}  // namespace

void HolePickTest::throughTheMiddleOfAHole_data() {
  QTest::addColumn<bool>("perspective");
  QTest::newRow("parallel") << false;
  QTest::newRow("perspective") << true;
}

// Through a hole one sees the inside of the far wall, or another hole; it is the near one that is meant.
void HolePickTest::throughTheMiddleOfAHole() {
  QFETCH(bool, perspective);
  const HoledModel model(test::sphereWithHoles(4, 6, 0.3));
  QCOMPARE(model.loops.size(), std::size_t(6));
  for (const Vec3& d : test::directions(6)) {
    PickRay pickRay = lookingAt(d, 5.0 * d, perspective);
    pickRay.pixel *= 0.1;  // so that no other edge is near
    const auto loop = model.pick(pickRay);
    QVERIFY(loop && loop == model.loopAt(d));
  }
}

void HolePickTest::nearTheEdgeOfAHole() {
  QFETCH(bool, perspective);
  const HoledModel model(test::sphereWithHoles(4, 6, 0.3));
  QCOMPARE(model.loops.size(), std::size_t{6});
  for (const BoundaryLoop& loop : model.loops) {
    const Vec3 out = loop.centre.normalized();
    const auto pick = [&](const Vec3& p, double aside) {
      // Away from the middle of the hole, on the surface as one sees it from far outside.
      const Vec3 away = (p - out * p.dot(out)).normalized();
      return model.pick(lookingAt(p + aside * away, p + aside * away + 50.0 * out, perspective));
    };
    const auto points = loopPoints(model.mesh, loop);
    for (std::size_t i = 0; i < points.size(); ++i) {
      // An edge's middle, so that no other edge is much nearer.
      const Vec3 p = 0.5 * (points[i] + points[(i + 1) % points.size()]);
      QCOMPARE(pick(p, 0.03), model.loopAt(loop.centre));
      QVERIFY(pick(p, 0.25) != model.loopAt(loop.centre));
    }
  }
}

// The hole, seen from behind through the closed side.
void HolePickTest::notThroughTheSurface() {
  const HoledModel model(test::sphereWithHoles(4, 1, 0.3));
  const Vec3 d = test::directions(1)[0];
  const Vec3 behind = -5.0 * d + 4.0 * d.unitOrthogonal();
  for (const bool perspective : {false, true}) {
    QVERIFY(!model.pick(lookingAt(d, behind, perspective)));
    for (const Vec3& p : loopPoints(model.mesh, model.loops[0])) {
      QVERIFY(!model.pick(lookingAt(p, behind, perspective)));
      QVERIFY(model.pick(lookingAt(p, -behind, perspective)));
    }
  }
}

// A wall with a small hole behind one with a large hole.
void HolePickTest::theSmallestOfThoseInSight() {
  TriangleSoup soup = test::annulus(24, 3, 0.5, 3.0);
  test::append(soup, test::moved(test::annulus(24, 3, 1.0, 3.0), Vec3(0, 0, 1)));
  HoledModel model(soup);
  for (BoundaryLoop& loop : model.loops) loop.isSheetBoundary = loop.length > 10.0;
  const auto pick = [&](double x) { return model.pick(lookingAt(Vec3(x, 0.01, 0), Vec3(x, 0.01, 9), false)); };
  const auto depthOf = [&](const std::optional<std::size_t>& i) { return i ? model.loops[*i].centre.z() : -1.0; };
  QCOMPARE(depthOf(pick(0.2)), 0.0);
  QCOMPARE(depthOf(pick(0.75)), 1.0);
  QVERIFY(!pick(2.0));
}

void HolePickTest::rims() {
  HoledModel model(test::disc(24, 4));
  QCOMPARE(model.loops.size(), std::size_t(1));
  model.loops[0].isSheetBoundary = true;
  QVERIFY(!model.pick(lookingAt(Vec3(0.1, 0.1, 0), Vec3(0.1, 0.1, 9), false)));
  QVERIFY(model.pick(lookingAt(Vec3(1.02, 0, 0), Vec3(1.02, 0, 9), false)));
  QVERIFY(!model.pick(lookingAt(Vec3(1.2, 0, 0), Vec3(1.2, 0, 9), false)));
}

void HolePickTest::extremes() {
  const double nan = std::nan("");
  const HoledModel model(test::sphereWithHoles(3, 2, 0.4));
  const Vec3 d = test::directions(2)[0];
  for (const bool perspective : {false, true}) {
    const PickRay good = lookingAt(d, 5.0 * d, perspective);
    for (const Ray& ray : {Ray{Vec3(nan, 0, 0), d}, Ray{5.0 * d, Vec3(0, nan, 0)}, Ray{5.0 * d, Vec3::Zero()}}) {
      PickRay pickRay = good;
      pickRay.ray = ray;
      QVERIFY(!model.pick(pickRay));
    }
    for (const double pixel : {0.0, nan}) {
      PickRay pickRay = good;
      pickRay.pixel = pixel;
      pickRay.focus = 0.0;
      model.pick(pickRay);  // any result is accepted without a scale
    }
    QVERIFY(!HoledModel(TriangleSoup()).pick(good));
    QVERIFY(!HoledModel(test::icosphere(2)).pick(good));
  }
  PickRay pickRay = lookingAt(d, 5.0 * d, true);
  pickRay.eye = Vec3(nan, nan, nan);
  QVERIFY(!model.pick(pickRay));
  const Vec3 far(1e7, -1e7, 1e7);
  const HoledModel distant(test::moved(test::sphereWithHoles(3, 2, 0.4), far));
  for (const bool perspective : {false, true}) {
    const auto loop = distant.pick(lookingAt(far + d, far + 5.0 * d, perspective));
    QVERIFY(loop && loop == distant.loopAt(far + d));
  }
}

HANDWHEEL_TEST(HolePickTest)
#include "HolePickTest.moc"
