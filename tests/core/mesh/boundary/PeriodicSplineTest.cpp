// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "mesh/boundary/PeriodicSpline.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace handwheel;

class PeriodicSplineTest : public QObject {
  Q_OBJECT

 private slots:
  void passesThroughThePoints();
  void isSmooth();
  void approachesACircle();
  void wavesByTheirLength_data();
  void wavesByTheirLength();
  void extremes();
};

namespace {

// A circle of radius 1 with a wave of this height across its plane, so many times around.
std::vector<Vec3> wavyCircle(int n, int waves, double height) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double u = 2.0 * M_PI * i / n;
    points.emplace_back(std::cos(u), std::sin(u), height * std::cos(waves * u));
  }
  return points;
}

std::vector<Vec3> randomLoop(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-0.3, 0.3);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double u = 2.0 * M_PI * (i + share(random)) / n;
    points.emplace_back(std::cos(u) + share(random), std::sin(u) + share(random), share(random));
  }
  return points;
}

}  // namespace

void PeriodicSplineTest::passesThroughThePoints() {
  for (const int n : {3, 4, 7, 50}) {
    const std::vector<Vec3> points = randomLoop(n, n);
    const PeriodicSpline spline(points, 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      QVERIFY((spline.at(i, 0.0) - points[i]).norm() < 1e-14);
      QVERIFY((spline.at(i, 1.0) - points[(i + 1) % points.size()]).norm() < 1e-14);
    }
  }
}

// Value, slope and bend are the same from either side of a knot.
void PeriodicSplineTest::isSmooth() {
  const std::vector<Vec3> points = randomLoop(20, 5);
  std::vector<double> chords;
  for (std::size_t i = 0; i < points.size(); ++i) chords.push_back((points[(i + 1) % 20] - points[i]).norm());
  for (const double lambda : {0.0, 0.3, 30.0}) {
    const PeriodicSpline spline(points, lambda);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t before = (i + 19) % 20;
      const double e = 1e-4;  // differences are exact to e²
      const auto right = [&](double t) { return spline.at(i, t / chords[i]); };
      const auto left = [&](double t) { return spline.at(before, 1.0 - t / chords[before]); };
      const Vec3 slope = (-3.0 * right(0) + 4.0 * right(e) - right(2 * e)) / (2.0 * e);
      const Vec3 slopeBefore = (3.0 * left(0) - 4.0 * left(e) + left(2 * e)) / (2.0 * e);
      QVERIFY((slope - slopeBefore).norm() < 1e-5 * (1.0 + slope.norm()));
      const Vec3 bend = (2.0 * right(0) - 5.0 * right(e) + 4.0 * right(2 * e) - right(3 * e)) / (e * e);
      const Vec3 bendBefore = (2.0 * left(0) - 5.0 * left(e) + 4.0 * left(2 * e) - left(3 * e)) / (e * e);
      QVERIFY((bend - bendBefore).norm() < 1e-4 * (1.0 + bend.norm()));
    }
  }
}

// An interpolating cubic spline errs with the fourth power of the step.
void PeriodicSplineTest::approachesACircle() {
  const auto error = [](int n) {
    const PeriodicSpline spline(wavyCircle(n, 0, 0.0), 0.0);
    double worst = 0.0;
    for (int i = 0; i < n; ++i) worst = std::max(worst, std::abs(spline.at(i, 0.5).norm() - 1.0));
    return worst;
  };
  QVERIFY(error(16) < 2e-4);
  const double order = std::log2(error(16) / error(32));
  QVERIFY2(std::abs(order - 4.0) < 0.2, qPrintable(QString::number(order)));
}

void PeriodicSplineTest::wavesByTheirLength_data() {
  QTest::addColumn<double>("wavelength");
  QTest::addColumn<int>("waves");
  QTest::addColumn<double>("least");
  QTest::addColumn<double>("most");
  QTest::newRow("half") << 8.0 << 15 << 0.499 << 0.501;
  QTest::newRow("half of longer ones") << 24.0 << 5 << 0.499 << 0.501;
  QTest::newRow("zigzag") << 8.0 << 60 << 0.0 << 0.01;
  QTest::newRow("long waves") << 8.0 << 3 << 0.995 << 1.0;
  QTest::newRow("none") << 1.9 << 60 << 1.0 - 1e-12 << 1.0 + 1e-12;
}

void PeriodicSplineTest::wavesByTheirLength() {
  QFETCH(double, wavelength);
  QFETCH(int, waves);
  const PeriodicSpline spline(wavyCircle(120, waves, 1e-4), lambdaForWavelength(wavelength));
  const double kept = spline.knot(0).z() / 1e-4;
  QFETCH(double, least);
  QFETCH(double, most);
  QVERIFY2(kept >= least && kept <= most, qPrintable(QString::number(kept)));
}

void PeriodicSplineTest::extremes() {
  for (const double lambda : {0.0, 2.6, 1e6}) {
    for (const double scale : {1e-6, 1.0, 1e6, 1e140}) {
      for (const double offset : {0.0, 1e7}) {
        std::vector<Vec3> points;
        for (const Vec3& p : randomLoop(12, 3)) points.push_back(scale * (p + Vec3::Constant(offset)));
        points.push_back(points.back() + Vec3::Constant(offset > 0 ? scale * 1e-8 : scale * 1e-12));
        const PeriodicSpline spline(points, lambda);
        for (std::size_t i = 0; i < spline.size(); ++i)
          for (const double u : {0.0, 0.3, 1.0}) {
            const Vec3 p = spline.at(i, u) / scale - Vec3::Constant(offset);
            QVERIFY(p.allFinite() && p.norm() < 4.0);
          }
      }
    }
  }
  // Infinitely smooth: all in the middle.
  const PeriodicSpline flat(wavyCircle(12, 0, 0.0), 1e12);
  for (std::size_t i = 0; i < 12; ++i) QVERIFY(flat.knot(i).norm() < 1e-6);
}

HANDWHEEL_TEST(PeriodicSplineTest)
#include "PeriodicSplineTest.moc"
