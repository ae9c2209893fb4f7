// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/Tessellation.h"

#include "Profiles.h"
#include "TestClass.h"
#include "Triangles.h"
#include "nurbs/CylinderDistance.h"
#include "nurbs/StockCylinder.h"

#include <MeshChecks.h>
#include <QTest>
#include <limits>

using namespace handwheel;

class TessellationTest : public QObject {
  Q_OBJECT

 private slots:
  void cylinder_data();
  void cylinder();
  void cylinderOfAnySize();
  void trianglesAreShapely();
  void longBarsGetLongerTriangles();
  void coneToItsTip();
  void sphereKeepsTheTolerance();
  void flatShoulder();
  void anyProfileIsClosedAndNear();
  void refusesTolerancesThatAreNone();
  void refusesTooManyTriangles();
  void refusesLimitsThatNothingKeeps();
  void refusesAProfileOnTheAxis();
  void stopsWhenCancelled();
};

namespace {

TriangleSoup tessellated(const ProfileCurve& profile, double chord) {
  TessellationOptions options;
  options.chord = chord;
  auto soup = tessellate(profile, options);
  if (!soup) qFatal("no triangles");
  return std::move(soup.value());
}

ProfileCurve tessellationCurve(ProfileNurbs nurbs) {
  return ProfileCurve::make(std::move(nurbs)).value();
}

}  // namespace

void TessellationTest::cylinder_data() {
  QTest::addColumn<double>("diameter");
  QTest::addColumn<double>("length");
  QTest::addColumn<double>("position");
  QTest::addColumn<double>("chord");
  QTest::newRow("a bar") << 50.0 << 100.0 << 0.0 << 0.01;
  QTest::newRow("fine") << 50.0 << 100.0 << -30.0 << 1e-5;
  QTest::newRow("coarse") << 50.0 << 100.0 << 0.0 << 1.0;
  QTest::newRow("coarser than the bar") << 50.0 << 100.0 << 0.0 << 1000.0;
  QTest::newRow("tiny") << 1e-6 << 1e-6 << 0.0 << 1e-9;
  QTest::newRow("tiny, far finer") << 1e-6 << 1e-6 << 0.0 << 1e-15;
  QTest::newRow("huge") << 1e6 << 1e6 << 0.0 << 0.1;
  QTest::newRow("a wire") << 1.0 << 1e6 << 0.0 << 1e-3;
  QTest::newRow("a sheet") << 1e6 << 1.0 << 0.0 << 1.0;
  QTest::newRow("a hair") << 1e-6 << 1e6 << 0.0 << 1e-8;
  QTest::newRow("a foil") << 1e6 << 1e-6 << 0.0 << 10.0;
  QTest::newRow("far away") << 50.0 << 100.0 << 1e7 << 0.01;
  QTest::newRow("tiny and far away") << 1e-6 << 1e-6 << 1e7 << 1e-9;
}

void TessellationTest::cylinder() {
  QFETCH(double, diameter);
  QFETCH(double, length);
  QFETCH(double, position);
  QFETCH(double, chord);
  const StockCylinder stock{diameter, length, position};
  const TriangleSoup soup = tessellated(stock.profile(), chord);
  const test::Edges edges = test::countEdges(soup);
  QVERIFY(edges.sound());
  QCOMPARE(test::eulerCharacteristic(soup), 2L);

  const double rounding = 1e-15 * diameter, error = distanceToCylinder(soup, stock);
  QVERIFY(error <= chord + rounding);
  // On a foil, every point is near one of the ends.
  if (chord < 0.03 * diameter && chord < length) QVERIFY(error >= 0.75 * chord);
  for (const Vec3& p : soup.points) {
    const double r = p.head<2>().norm();
    const bool isOnMantle = std::abs(r - diameter / 2) <= rounding;
    QVERIFY(isOnMantle || p.z() == position || p.z() == position + length);
    QVERIFY(r <= diameter / 2 + rounding);
  }
}

void TessellationTest::cylinderOfAnySize() {
  QVERIFY(rc::check("closed, outwards, within the tolerance", [] {
    const StockCylinder stock{std::pow(10.0, test::between(-6, 6)), std::pow(10.0, test::between(-6, 6)), 0.0};
    const double chord = std::min(1e6, stock.diameter * std::pow(10.0, test::between(-6, 1)));
    TessellationOptions options;
    options.chord = chord;
    options.maxWellShapedTriangles = 5000;
    const TriangleSoup soup = *tessellate(stock.profile(), options);
    RC_ASSERT(test::isClosed(soup));
    RC_ASSERT(distanceToCylinder(soup, stock) <= chord + 1e-15 * stock.diameter);
    // A polygon inside the circle, never less than an octagon.
    const double volume = test::volume(soup) / stock.volume();
    RC_ASSERT(volume < 1.0 + 1e-12);
    RC_ASSERT(volume > std::max(0.9, 1.0 - 4.0 * chord / stock.diameter) - 1e-12);
  }));
}

void TessellationTest::trianglesAreShapely() {
  for (double chord : {1.0, 0.1, 0.03, 0.01, 0.001}) {
    const TriangleSoup soup = tessellated(StockCylinder{50, 100, 0}.profile(), chord);
    std::size_t inEnds = 0;
    for (const Triangle& t : soup.triangles) {
      const bool isInEnd =
          soup.points[t[0]].z() == soup.points[t[1]].z() && soup.points[t[1]].z() == soup.points[t[2]].z();
      inEnds += isInEnd;
      QVERIFY(test::leastAngle(soup, t) > (isInEnd ? 20.0 : 6.0));  // one in eight is 7°
    }
    // Both ends together take less than six triangles a chord.
    std::size_t chords = 0;
    for (const Vec3& p : soup.points) chords += p.z() == 0.0 && p.head<2>().norm() > 25.0 * (1 - 1e-12);
    QVERIFY(inEnds < 6 * chords);
  }
}

void TessellationTest::longBarsGetLongerTriangles() {
  const ProfileCurve wire = StockCylinder{1, 1e6, 0}.profile();
  TessellationOptions options;
  options.chord = 1e-3;
  options.maxWellShapedTriangles = 10'000;
  const auto soup = tessellate(wire, options);
  QVERIFY(soup.hasValue());
  QVERIFY(soup->triangles.size() <= 10'000);
  QVERIFY(soup->triangles.size() > 5'000);
  QVERIFY(test::isClosed(*soup));
}

void TessellationTest::coneToItsTip() {
  for (double height : {1e-3, 1.0, 20.0, 1e4}) {
    for (bool isUp : {true, false}) {
      const ProfileCurve cone = isUp ? ProfileCurve::polyline({{10, 0}, {0, height}}).value()
                                     : ProfileCurve::polyline({{0, -height}, {10, 0}}).value();
      const double chord = 0.004;
      const TriangleSoup soup = tessellated(cone, chord);
      QVERIFY(test::countEdges(soup).sound());
      QCOMPARE(test::eulerCharacteristic(soup), 2L);
      // The radius of the cone at a height, less that of a sample, is its distance along the radius.
      for (const Triangle& t : soup.triangles) {
        for (const Vec3& p : test::samples(soup, t, 4)) {
          const double gap = 10.0 * (1.0 - std::abs(p.z()) / height) - p.head<2>().norm();
          QVERIFY(gap >= -1e-12 * std::max(1.0, height));
          QVERIFY(gap <= chord * (1 + 1e-9) + 1e-12 || p.z() == 0.0);
        }
      }
      const double exact = M_PI * 100 * height / 3;
      QVERIFY(std::abs(test::volume(soup) / exact - 1.0) < 4 * chord / 10);
    }
  }
}

void TessellationTest::sphereKeepsTheTolerance() {
  for (double chord : {3.0, 0.3, 0.01, 1e-4}) {
    const TriangleSoup soup = tessellated(tessellationCurve(test::sphere(10.0, 3.0)), chord);
    QVERIFY(test::countEdges(soup).sound());
    QCOMPARE(test::eulerCharacteristic(soup), 2L);
    double error = 0.0;
    for (const Triangle& t : soup.triangles) {
      for (const Vec3& p : test::samples(soup, t, 2))
        error = std::max(error, std::abs((p - Vec3(0, 0, 3)).norm() - 10.0));
    }
    QVERIFY(error <= chord);
    if (chord < 1.0) QVERIFY(error >= 0.3 * chord);
    QVERIFY(test::volume(soup) > 0.0);
    QVERIFY(test::volume(soup) > 4.0 / 3.0 * M_PI * 1000 - 4.0 * M_PI * 100 * 1.01 * chord);
  }
}

void TessellationTest::flatShoulder() {
  const auto profile = ProfileCurve::polyline({{10, 0}, {10, 10}, {4, 10}, {4, 30}}).value();
  const TriangleSoup soup = tessellated(profile, 0.01);
  QVERIFY(test::countEdges(soup).sound());
  QCOMPARE(test::eulerCharacteristic(soup), 2L);
  const double exact = M_PI * (100 * 10 + 16 * 20);
  QVERIFY(test::volume(soup) < exact);
  QVERIFY(test::volume(soup) > exact * (1 - 4 * 0.01 / 8));
  for (const Vec3& p : soup.points) {  // the corners stay where they are
    const double r = p.head<2>().norm();
    QVERIFY(p.z() > 10.0 ? r < 4 + 1e-12 : r < 10 + 1e-12);
    QVERIFY(p.z() <= 10.0 || p.z() == 30.0 || r > 4 - 1e-12);
  }
}

void TessellationTest::anyProfileIsClosedAndNear() {
  QVERIFY(rc::check("random splines", [] {
    const ProfileCurve profile = tessellationCurve(test::randomNurbs());
    const double chord = std::pow(10.0, test::between(-2, 1));
    TessellationOptions options;
    options.chord = chord;
    const auto made = tessellate(profile, options);
    RC_PRE(made.hasValue());  // all poles may be on the axis
    const TriangleSoup& soup = *made;
    RC_ASSERT(test::isClosed(soup));
    std::vector<ProfilePoint> line;
    for (const BezierArc& arc : profile.arcs())
      for (int i = 0; i <= 200; ++i) line.push_back(arc.derivatives(i / 200.0)[0]);
    const ProfilePoint first = line.front(), last = line.back();
    for (std::size_t n = 0; n < 50; ++n) {
      const Triangle& t = soup.triangles[*rc::gen::inRange<std::size_t>(0, soup.triangles.size())];
      for (const Vec3& p : test::samples(soup, t, 3)) {
        const ProfilePoint q(p.head<2>().norm(), p.z());
        double distance = HUGE_VAL;
        for (const ProfilePoint& end : {first, last})
          distance = std::min(distance, std::hypot(std::max(0.0, q.x() - end.x()), q.y() - end.y()));
        for (std::size_t i = 1; i < line.size() && distance > chord; ++i) {
          const ProfilePoint side = line[i] - line[i - 1];
          const double along =
              side.squaredNorm() > 0 ? std::clamp((q - line[i - 1]).dot(side) / side.squaredNorm(), 0.0, 1.0) : 0.0;
          distance = std::min(distance, (q - line[i - 1] - along * side).norm());
        }
        RC_ASSERT(distance <= chord + 5e-3);  // deviation of 200 chords per arc
      }
    }
  }));
}

void TessellationTest::refusesTolerancesThatAreNone() {
  const ProfileCurve profile = StockCylinder{}.profile();
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (double chord : {0.0, -1.0, nan, inf, 2e6}) {
    TessellationOptions options;
    options.chord = chord;
    const auto soup = tessellate(profile, options);
    QVERIFY(!soup);
    QCOMPARE(soup.error().code, ErrorCode::ValueOutOfRange);
    QCOMPARE(soup.error().arguments.size(), std::size_t{4});
  }
}

void TessellationTest::refusesTooManyTriangles() {
  for (const ProfileCurve& profile :
       {StockCylinder{1e6, 1e6, 0}.profile(), tessellationCurve(test::sphere(1e6, 0.0))}) {
    for (double chord : {1e-7, 1e-300}) {
      TessellationOptions options;
      options.chord = chord;
      options.mostTriangles = 200'000;
      const auto refused = tessellate(profile, options);
      QVERIFY(!refused);
      QCOMPARE(refused.error().code, ErrorCode::ValueOutOfRange);
      // The least tolerance that the error names works, and is not far above the true limit.
      options.chord = std::stod(refused.error().arguments[2]) * 1.00001;
      const auto soup = tessellate(profile, options);
      QVERIFY(soup.hasValue());
      QVERIFY(soup->triangles.size() <= options.mostTriangles);
      QVERIFY(soup->triangles.size() > options.mostTriangles / 4);
    }
  }
}

void TessellationTest::refusesLimitsThatNothingKeeps() {
  TessellationOptions options;
  options.mostTriangles = 10;  // even eight sides take more
  const auto soup = tessellate(StockCylinder{}.profile(), options);
  QVERIFY(!soup);
  QCOMPARE(soup.error().code, ErrorCode::FileTooLarge);
}

void TessellationTest::refusesAProfileOnTheAxis() {
  const auto soup = tessellate(ProfileCurve::polyline({{0, 0}, {0, 5}}).value(), {});
  QVERIFY(!soup);
  QCOMPARE(soup.error().code, ErrorCode::ElementMalformed);
}

void TessellationTest::stopsWhenCancelled() {
  JobState state;
  state.cancelled = true;
  const auto soup = tessellate(StockCylinder{}.profile(), {}, Progress(state));
  QVERIFY(!soup);
  QCOMPARE(soup.error().code, ErrorCode::Cancelled);
}

HANDWHEEL_TEST(TessellationTest)
#include "TessellationTest.moc"
