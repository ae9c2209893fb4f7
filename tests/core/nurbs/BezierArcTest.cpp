// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/BezierArc.h"

#include "Profiles.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

class BezierArcTest : public QObject {
  Q_OBJECT

 private slots:
  void arcsStayWithinTheirChordError();
  void halvesAreTheSameCurve();
};

namespace {

ProfileCurve curve(ProfileNurbs nurbs) {
  return ProfileCurve::make(std::move(nurbs)).value();
}

double distanceToSegment(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * (b - a)).norm();
}

}  // namespace

void BezierArcTest::arcsStayWithinTheirChordError() {
  QVERIFY(rc::check("sampled", [] {
    const ProfileCurve c = curve(test::randomNurbs());
    for (const BezierArc& arc : c.arcs()) {
      for (int i = 0; i <= 20; ++i) {
        const ProfilePoint p = arc.derivatives(i / 20.0)[0];
        RC_ASSERT(distanceToSegment(p, arc.start(), arc.end()) <= arc.chordError() * (1 + 1e-12) + 1e-13);
      }
    }
  }));
  // A parabola deviates from its chord by half of the deviation of its middle pole, a cubic with two poles alike by
  // three quarters, a quarter of a circle by 1 - √½.
  const auto error = [](ProfileNurbs nurbs) { return curve(std::move(nurbs)).arcs()[0].chordError(); };
  QCOMPARE(error({2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {3, 1}, {1, 2}}, {1, 1, 1}}), 1.0);
  QCOMPARE(error({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{1, 0}, {3, 0}, {3, 2}, {1, 2}}, {1, 1, 1, 1}}), 1.5);
  QCOMPARE(error(test::sphere(1.0, 0.0)), 1.0 - std::sqrt(0.5));
}

void BezierArcTest::halvesAreTheSameCurve() {
  QVERIFY(rc::check("each runs over half of the parameter", [] {
    const ProfileCurve c = curve(test::randomNurbs());
    const BezierArc& arc = c.arcs().front();
    const auto [left, right] = arc.halves();
    const double t = test::between(0.0, 1.0);
    RC_ASSERT((left.derivatives(t)[0] - arc.derivatives(t / 2)[0]).norm() < 1e-12);
    RC_ASSERT((right.derivatives(t)[0] - arc.derivatives(0.5 + t / 2)[0]).norm() < 1e-12);
  }));
}

HANDWHEEL_TEST(BezierArcTest)
#include "BezierArcTest.moc"
