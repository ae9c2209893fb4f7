// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/CurveFit.h"

#include "AnyProfile.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using test::evenly;

namespace {

double distanceTo(const std::vector<ProfileSegment>& segments, const ProfilePoint& p) {
  double least = HUGE_VAL;
  for (const ProfileSegment& s : segments) least = std::min(least, (s.nearest(p) - p).norm());
  return least;
}

}  // namespace

class CurveFitTest : public QObject {
  Q_OBJECT

 private slots:
  void aLineIsALine() {
    std::vector<ProfilePoint> points;
    for (int i = 0; i <= 1000; ++i) points.emplace_back(3.0 + 0.01 * i, 0.02 * i);
    const auto found = fitSegments(points, 1e-6);
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(!found[0].isArc());
  }

  void anArcIsAnArc() {
    const ProfileSegment arc = arcAround({10.0, 5.0}, 7.0, -1.0, 2.5);
    std::vector<ProfilePoint> points;
    for (int i = 0; i <= 300; ++i) points.push_back(arc.at(i / 300.0));
    const auto found = fitSegments(points, 1e-6);
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(std::abs(found[0].radius() - 7.0) < 1e-9);
    QVERIFY(std::abs(found[0].angle() - 3.5) < 1e-9);
  }

  void cornersStay() {
    std::vector<ProfilePoint> points;
    for (int i = 0; i <= 100; ++i) points.emplace_back(10.0, 0.1 * i);
    for (int i = 1; i <= 100; ++i) points.emplace_back(10.0 - 0.05 * i, 10.0);
    for (int i = 1; i <= 100; ++i) points.emplace_back(5.0, 10.0 - 0.05 * i);  // back down beside it
    const auto found = fitSegments(points, 1e-3);
    QCOMPARE(found.size(), std::size_t{3});
    QVERIFY((found[0].to - ProfilePoint(10, 10)).norm() < 1e-9 && (found[1].to - ProfilePoint(5, 10)).norm() < 1e-9);
  }

  void anEllipse() {
    const auto ellipse = [](double t) {
      return ProfilePoint(20.0 + 10.0 * std::cos(3.0 * t), 4.0 * std::sin(3.0 * t));
    };
    const double tolerance = 1e-3;
    const auto found = fitSegments(ellipse, tolerance);
    QVERIFY(found.size() > 2 && found.size() < 60);
    for (int i = 0; i <= 5000; ++i) QVERIFY(distanceTo(found, ellipse(i / 5000.0)) < 2.0 * tolerance);
  }

  void withinTheTolerance() {
    QVERIFY(rc::check("every point, by far fewer segments, joined end to end", [] {
      // A smooth curve with noise below the tolerance.
      const double tolerance = evenly(1e-4, 1e-2), a = evenly(1.0, 10.0), b = evenly(0.1, 1.0);
      std::vector<ProfilePoint> points;
      for (int i = 0; i <= 500; ++i) {
        const double z = 0.1 * i;
        points.emplace_back(30.0 + a * std::sin(b * z) + evenly(-0.2, 0.2) * tolerance, z);
      }
      const auto found = fitSegments(points, tolerance);
      for (const ProfilePoint& p : points) RC_ASSERT(distanceTo(found, p) <= tolerance * (1.0 + 1e-9));
      for (std::size_t i = 0; i + 1 < found.size(); ++i) RC_ASSERT(found[i].to == found[i + 1].from);
      RC_ASSERT(found.front().from == points.front());
      RC_ASSERT(found.back().to == points.back());
    }));
  }

  void fewPoints() {
    QVERIFY(fitSegments(std::vector<ProfilePoint>{}, 1e-3).empty());
    QVERIFY(fitSegments(std::vector<ProfilePoint>{{1, 1}}, 1e-3).empty());
    QCOMPARE(fitSegments(std::vector<ProfilePoint>{{1, 1}, {2, 2}}, 1e-3).size(), std::size_t{1});
    // All points coincide.
    QVERIFY(fitSegments(std::vector<ProfilePoint>(50, ProfilePoint(1, 1)), 1e-3).size() <= 50);
  }
};

HANDWHEEL_TEST(CurveFitTest)
#include "CurveFitTest.moc"
