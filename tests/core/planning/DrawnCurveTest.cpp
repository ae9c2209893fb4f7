// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/DrawnCurve.h"

#include "Scenes.h"
#include "TestClass.h"
#include "robot/ShapeSurfaces.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A box with a corner of 100 x 60 x 40 mm around the origin.
std::shared_ptr<const PartSurface> block() {
  return std::make_shared<const PartSurface>(surfaceOf(BoxShape{{100.0, 60.0, 40.0}}));
}

Vec3 anyDirection() {
  const double z = evenly(-1.0, 1.0), angle = evenly(0.0, 2.0 * M_PI), across = std::sqrt(1.0 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

DrawnCurve drawn(const std::shared_ptr<const PartSurface>& surface, const std::vector<Vec3>& points) {
  DrawnCurve curve(surface, points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!curve.goOnTo(points[i])) qFatal("the curve is broken");
  }
  return curve;
}

}  // namespace

// Tests curves drawn on parts, whose positions follow from the shapes.
class DrawnCurveTest : public QObject {
  Q_OBJECT

 private slots:
  // On a flat face the curve is straight: as long as the distances of the points.
  void onAFace() {
    const SurfaceTrack track = drawn(block(), {{-40.0, -20.0, 20.0}, {0.0, 10.0, 25.0}, {30.0, 10.0, 20.0}}).track();
    QVERIFY(std::abs(track.length() - 80.0) < 1e-9);
    QVERIFY((track.points.front().position - Vec3(-40.0, -20.0, 20.0)).norm() < 1e-9);
    QVERIFY((track.points.back().position - Vec3(30.0, 10.0, 20.0)).norm() < 1e-9);
    for (const TrackPoint& point : track.points) QVERIFY((point.normal - Vec3::UnitZ()).norm() < 1e-9);
    QVERIFY((track.points.front().direction - Vec3(0.8, 0.6, 0.0)).norm() < 1e-9);
  }

  // Over an edge of the box, and back: the section across it is there and there.
  void overAnEdge() {
    DrawnCurve curve = drawn(block(), {{0.0, 5.0, 20.0}, {50.0, 5.0, 0.0}});
    QVERIFY(std::abs(curve.track().length() - 70.0) < 1e-9);
    QVERIFY(curve.goOnTo({0.0, 5.0, 20.0}));
    QVERIFY(std::abs(curve.track().length() - 140.0) < 1e-9);
    QVERIFY((curve.track().points.back().position - Vec3(0.0, 5.0, 20.0)).norm() < 1e-9);
  }

  // On a ball it is a great circle, except for the facets; the shorter arc of the two.
  void onABall() {
    constexpr double kRadius = 50.0;
    const auto ball = std::make_shared<const PartSurface>(surfaceOf(SphereShape{kRadius}, 96));
    QVERIFY(rc::check("arcs", [&] {
      const Vec3 a = kRadius * anyDirection(), b = kRadius * anyDirection();
      const double angle = std::acos(std::clamp(a.dot(b) / (kRadius * kRadius), -1.0, 1.0));
      RC_PRE(angle > 0.1 && angle < 2.8);
      DrawnCurve curve(ball, a);
      RC_ASSERT(curve.goOnTo(b));
      RC_ASSERT(std::abs(curve.track().length() - kRadius * angle) < 0.03 * kRadius * angle);
      for (const TrackPoint& point : curve.track().points) {
        RC_ASSERT(std::abs(point.position.norm() - kRadius) < 0.01 * kRadius);
        RC_ASSERT(point.normal.dot(point.position) > 0.98 * kRadius);
      }
    }));
  }

  // No surface leads straight through a part, or to another piece of it.
  void isBroken() {
    DrawnCurve curve(block(), {0.0, 0.0, 20.0});
    QVERIFY(!curve.goOnTo({0.0, 0.0, -20.0}));
    QVERIFY(!curve.goOnTo({std::nan(""), 0.0, 0.0}));
    QVERIFY(curve.track().points.empty());
    QVERIFY(curve.goOnTo({0.0, 0.0, 20.0}));  // the present point
    QVERIFY(curve.track().points.empty());
    TriangleSoup two = surfaceOf(BoxShape{{100.0, 60.0, 40.0}});
    const TriangleSoup one = two;
    const auto first = static_cast<std::uint32_t>(two.points.size());
    for (const Vec3& point : one.points) two.points.push_back(point + Vec3(200.0, 0.0, 0.0));
    for (const Triangle& t : one.triangles) two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    DrawnCurve across(std::make_shared<const PartSurface>(two), {0.0, 0.0, 20.0});
    QVERIFY(!across.goOnTo({200.0, 0.0, 20.0}));
    QVERIFY(across.goOnTo({40.0, 0.0, 20.0}));
  }

  void onNothing() {
    DrawnCurve curve(std::make_shared<const PartSurface>(TriangleSoup{}), {0.0, 0.0, 0.0});
    QVERIFY(!curve.goOnTo({1.0, 0.0, 0.0}));
  }
};

HANDWHEEL_TEST(DrawnCurveTest)
#include "DrawnCurveTest.moc"
