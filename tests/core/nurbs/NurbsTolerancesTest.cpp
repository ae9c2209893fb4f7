// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/Tolerance.h"
#include "nurbs/ProfileCurve.h"
#include "nurbs/Tessellation.h"

using namespace handwheel;

// The tolerances of profiles: a case just below and one just above each.
class NurbsTolerancesTest : public QObject {
  Q_OBJECT

 private slots:
  void knotSpan();
  void onAxis();
};

// Two inner knots of a range of 4; the one at 0 lets the small distance be exact.
void NurbsTolerancesTest::knotSpan() {
  const auto isSound = [](double gap) {
    return bool(ProfileCurve::make({1, {-2, -2, 0, gap, 2, 2}, {{1, 0}, {1, 1}, {1, 2}, {1, 3}}, {1, 1, 1, 1}}));
  };
  QVERIFY(!isSound(0.98 * tolerance::kKnotSpan * 4.0));
  QVERIFY(isSound(1.02 * tolerance::kKnotSpan * 4.0));
}

// A cone of radius 10 with its tip so far from the axis: one vertex there, or a circle of them.
void NurbsTolerancesTest::onAxis() {
  const auto verticesAtTip = [](double radius) {
    const auto profile = ProfileCurve::polyline({{10, 0}, {radius, 20}});
    const auto soup = profile ? tessellate(*profile, {.chord = 0.1}) : Result<TriangleSoup>(profile.error());
    if (!soup) qFatal("a cone can be tessellated");
    return std::count_if(soup->points.begin(), soup->points.end(), [](const Vec3& p) { return p.z() == 20.0; });
  };
  QCOMPARE(verticesAtTip(0.98 * tolerance::kOnAxis * 10.0), 1);
  QVERIFY(verticesAtTip(1.02 * tolerance::kOnAxis * 10.0) >= 3);
}

HANDWHEEL_TEST(NurbsTolerancesTest)
#include "NurbsTolerancesTest.moc"
