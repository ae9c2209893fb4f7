// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/ProfileCurve.h"

#include "Profiles.h"
#include "TestClass.h"

#include <QTest>
#include <limits>

using namespace handwheel;

class ProfileCurveTest : public QObject {
  Q_OBJECT

 private slots:
  void isTheTextbooksCurve();
  void derivativeIsTheLimitOfDifferences();
  void passesThroughItsEndsAndCorners();
  void polylineRunsAlongItsPoints();
  void halfCircleIsExact();
  void keepsItsShapeFarFromTheOrigin();
  void volumeWithAnyWeights();
  void directionAtDoublePoles();
  void directionOfAPointIsZero();
  void refusesNetsThatAreNone_data();
  void refusesNetsThatAreNone();
};

namespace {

ProfileCurve profileCurveCurve(ProfileNurbs nurbs) {
  auto made = ProfileCurve::make(std::move(nurbs));
  if (!made) qFatal("%s", made.error().arguments.back().c_str());
  return std::move(made.value());
}

}  // namespace

void ProfileCurveTest::isTheTextbooksCurve() {
  QVERIFY(rc::check("de Boor's recursion gives the same point", [] {
    const ProfileNurbs nurbs = test::randomNurbs();
    const ProfileCurve c = profileCurveCurve(nurbs);
    const double u = *rc::gen::arbitrary<bool>() ? test::between(c.from(), c.to()) : *rc::gen::elementOf(nurbs.knots);
    RC_ASSERT((c.point(u) - test::pointByDefinition(nurbs, u)).norm() < 1e-12);
  }));
}

void ProfileCurveTest::derivativeIsTheLimitOfDifferences() {
  QVERIFY(rc::check("inside an arc", [] {
    const ProfileNurbs nurbs = test::randomNurbs();
    const ProfileCurve c = profileCurveCurve(nurbs);
    const double u = test::between(c.from(), c.to()), h = 1e-5;
    for (double knot : nurbs.knots) RC_PRE(std::abs(u - knot) > 2.0 * h);
    const ProfilePoint slope = (c.point(u + h) - c.point(u - h)) / (2.0 * h);
    // The error of a central difference is h²/6 of the third derivative, which weights of 0.2…5 over spans of 0.01 and
    // poles within 20 let grow to some 1e9.
    const double tolerance = 1e-3 * (1.0 + slope.norm());
    RC_ASSERT((c.derivative(u) - slope).norm() < tolerance);
    if (slope.norm() > 10.0 * tolerance) RC_ASSERT((c.direction(u) - slope.normalized()).norm() < 0.05);
  }));
}

void ProfileCurveTest::passesThroughItsEndsAndCorners() {
  const ProfileCurve c =
      profileCurveCurve({2, {0, 0, 0, 1, 1, 3, 3, 3}, {{0, 0}, {4, 0}, {4, 3}, {4, 9}, {1, 9}}, {1, 2, 1, 1, 3}});
  QCOMPARE(c.arcs().size(), std::size_t{2});
  QVERIFY(c.point(0) == ProfilePoint(0, 0));
  QVERIFY(c.point(1) == ProfilePoint(4, 3));
  QVERIFY(c.point(3) == ProfilePoint(1, 9));
  QVERIFY(c.point(-5) == ProfilePoint(0, 0));  // beyond the range: its ends
  QVERIFY(c.point(5) == ProfilePoint(1, 9));
  QVERIFY((c.direction(0) - ProfilePoint(1, 0)).norm() < 1e-15);
  QVERIFY((c.direction(3) - ProfilePoint(-1, 0)).norm() < 1e-15);
}

void ProfileCurveTest::polylineRunsAlongItsPoints() {
  const std::vector<ProfilePoint> points = {{5, 0}, {5, 10}, {3, 10}, {3, 10}, {0, 14}};
  const auto c = ProfileCurve::polyline(points);
  QVERIFY(c.hasValue());
  for (std::size_t i = 0; i < points.size(); ++i) QVERIFY(c->point(double(i)) == points[i]);
  QVERIFY((c->point(1.25) - ProfilePoint(4.5, 10)).norm() < 1e-15);
  QVERIFY(!ProfileCurve::polyline({{1, 2}}));
  QVERIFY(!ProfileCurve::polyline({}));
}

void ProfileCurveTest::halfCircleIsExact() {
  for (double radius : {1e-6, 1.0, 1e6}) {
    const ProfileCurve c = profileCurveCurve(test::sphere(radius, 0.0));
    for (int i = 0; i <= 1000; ++i) {
      const ProfilePoint p = c.point(2.0 * i / 1000);
      QVERIFY(std::abs(p.norm() / radius - 1.0) < 1e-14);
      QVERIFY(p.x() >= 0.0);
      const ProfilePoint tangent = c.direction(2.0 * i / 1000);
      QVERIFY(std::abs(tangent.dot(p) / radius) < 1e-13);
    }
  }
}

void ProfileCurveTest::keepsItsShapeFarFromTheOrigin() {
  QVERIFY(rc::check("at 1e7 mm only the last digits of the place are lost", [] {
    ProfileNurbs nurbs = test::randomNurbs();
    const ProfileCurve near = profileCurveCurve(nurbs);
    for (ProfilePoint& p : nurbs.poles) p.y() += 1e7;
    const ProfileCurve far = profileCurveCurve(nurbs);
    const double u = test::between(near.from(), near.to());
    RC_ASSERT((far.point(u) - near.point(u) - ProfilePoint(0, 1e7)).norm() < 2e-8);
    // Poles are rounded to 2e-9 there, and a derivative multiplies that by degree · weights / span.
    RC_ASSERT((far.derivative(u) - near.derivative(u)).norm() < 1e-3);
  }));
}

// Weights multiplied by the powers of a number give the same curve with other parameters: between 0.001 and 1000 most
// of it lies within a thousandth of the range.
void ProfileCurveTest::volumeWithAnyWeights() {
  const double w = std::sqrt(0.5);
  QVERIFY(rc::check("a quarter of a circle, and a cone of each degree", [w] {
    const double c = std::pow(10.0, test::between(-3.0, 3.0));
    const ProfileNurbs quarter{2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {5, 0}, {5, 5}}, {1, w * c, c * c}};
    RC_ASSERT(std::abs(profileCurveCurve(quarter).volume() / (2.0 / 3.0 * M_PI * 125.0) - 1.0) < 1e-10);
    const double h = test::between(0.001, 1000.0), cone = M_PI * h * (1.0 + 2.0 + 4.0) / 3.0;
    const ProfileNurbs line{1, {0, 0, 1, 1}, {{1, 0}, {2, h}}, {1, c}};
    RC_ASSERT(std::abs(profileCurveCurve(line).volume() / cone - 1.0) < 1e-10);
    const ProfileNurbs cubic{3,
                             {0, 0, 0, 0, 1, 1, 1, 1},
                             {{1, 0}, {4.0 / 3.0, h / 3}, {5.0 / 3.0, 2 * h / 3}, {2, h}},
                             {c, 1.0 / c, c, 1.0 / c}};
    RC_ASSERT(std::abs(profileCurveCurve(cubic).volume() / cone - 1.0) < 1e-10);
  }));
  for (const double most : {1e6, 1e-6}) {
    const ProfileNurbs line{1, {0, 0, 1, 1}, {{1, 0}, {2, 3}}, {1.0 / most, most}};
    QVERIFY(std::abs(profileCurveCurve(line).volume() / (7.0 * M_PI) - 1.0) < 1e-10);
  }
}

void ProfileCurveTest::directionAtDoublePoles() {
  const ProfileCurve two = profileCurveCurve({2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 0}, {1, 5}}, {1, 1, 1}});
  QCOMPARE(two.derivative(0), ProfilePoint(0, 0));
  QVERIFY((two.direction(0) - ProfilePoint(0, 1)).norm() < 1e-15);
  const ProfileCurve end = profileCurveCurve({2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 5}, {1, 5}}, {1, 2, 3}});
  QVERIFY((end.direction(1) - ProfilePoint(0, 1)).norm() < 1e-15);
  const ProfileCurve three =
      profileCurveCurve({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{1, 0}, {1, 0}, {1, 0}, {4, 4}}, {1, 2, 3, 4}});
  QVERIFY((three.direction(0) - ProfilePoint(0.6, 0.8)).norm() < 1e-15);
  const ProfileCurve back =
      profileCurveCurve({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{1, 0}, {4, 4}, {4, 4}, {4, 4}}, {1, 1, 1, 1}});
  QVERIFY((back.direction(1) - ProfilePoint(0.6, 0.8)).norm() < 1e-15);
}

void ProfileCurveTest::directionOfAPointIsZero() {
  const ProfileCurve c = profileCurveCurve({2, {0, 0, 0, 1, 1, 1}, {{1, 7}, {1, 7}, {1, 7}}, {1, 1, 1}});
  QCOMPARE(c.direction(0.5), ProfilePoint(0, 0));
  QCOMPARE(c.arcs()[0].chordError(), 0.0);
}

void ProfileCurveTest::refusesNetsThatAreNone_data() {
  QTest::addColumn<int>("degree");
  QTest::addColumn<QList<double>>("knots");
  QTest::addColumn<QList<double>>("radii");
  QTest::addColumn<QList<double>>("weights");
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  using List = QList<double>;
  QTest::newRow("degree 0") << 0 << List{0, 1, 2} << List{1, 1} << List{1, 1};
  QTest::newRow("degree 4") << 4 << List{0, 0, 0, 0, 0, 1, 1, 1, 1, 1} << List{1, 1, 1, 1, 1} << List{1, 1, 1, 1, 1};
  QTest::newRow("no poles") << 1 << List{} << List{} << List{};
  QTest::newRow("too few poles") << 2 << List{0, 0, 0, 1, 1} << List{1, 1} << List{1, 1};
  QTest::newRow("a knot short") << 1 << List{0, 0, 1} << List{1, 1} << List{1, 1};
  QTest::newRow("knots fall") << 1 << List{0, 0, 2, 1, 3, 3} << List{1, 1, 1, 1} << List{1, 1, 1, 1};
  QTest::newRow("knots without extent") << 1 << List{0, 0, 0, 0} << List{1, 1} << List{1, 1};
  QTest::newRow("ends not multiple") << 2 << List{0, 0, 1, 2, 2, 2} << List{1, 1, 1} << List{1, 1, 1};
  QTest::newRow("a gap") << 1 << List{0, 0, 1, 1, 2, 2} << List{1, 1, 1, 1} << List{1, 1, 1, 1};
  QTest::newRow("knots too near") << 1 << List{0, 0, 1e-14, 1, 1} << List{1, 1, 1} << List{1, 1, 1};
  QTest::newRow("NaN among knots") << 1 << List{0, 0, nan, 1, 1} << List{1, 1, 1} << List{1, 1, 1};
  QTest::newRow("infinite knots") << 1 << List{-inf, -inf, inf, inf} << List{1, 1} << List{1, 1};
  QTest::newRow("across the axis") << 1 << List{0, 0, 1, 1} << List{1, -1e-9} << List{1, 1};
  QTest::newRow("NaN pole") << 1 << List{0, 0, 1, 1} << List{1, nan} << List{1, 1};
  QTest::newRow("far pole") << 1 << List{0, 0, 1, 1} << List{1, 1e10} << List{1, 1};
  QTest::newRow("weight 0") << 1 << List{0, 0, 1, 1} << List{1, 1} << List{1, 0};
  QTest::newRow("weight NaN") << 1 << List{0, 0, 1, 1} << List{1, 1} << List{nan, 1};
  QTest::newRow("a weight short") << 1 << List{0, 0, 1, 1} << List{1, 1} << List{1};
}

void ProfileCurveTest::refusesNetsThatAreNone() {
  QFETCH(int, degree);
  QFETCH(QList<double>, knots);
  QFETCH(QList<double>, radii);
  QFETCH(QList<double>, weights);
  ProfileNurbs nurbs{degree, {knots.begin(), knots.end()}, {}, {weights.begin(), weights.end()}};
  for (double r : radii) nurbs.poles.emplace_back(r, double(nurbs.poles.size()));
  const auto made = ProfileCurve::make(nurbs);
  QVERIFY(!made);
  QCOMPARE(made.error().code, ErrorCode::ElementMalformed);
}

HANDWHEEL_TEST(ProfileCurveTest)
#include "ProfileCurveTest.moc"
