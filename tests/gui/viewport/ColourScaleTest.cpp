// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "viewport/overlay/ColourScale.h"

#include <Eigen/Dense>

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

double linear(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Eigen::Vector3d linearRgb(const QColor& c) {
  return {linear(c.redF()), linear(c.greenF()), linear(c.blueF())};
}

// CIELAB of linear sRGB, by the matrix of IEC 61966-2-1 (the scale uses its inverse).
Eigen::Vector3d lab(const Eigen::Vector3d& rgb) {
  Eigen::Matrix3d toXyz;
  toXyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Eigen::Vector3d xyz = toXyz * rgb;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const double x = f(xyz.x() / 0.95047), y = f(xyz.y()), z = f(xyz.z() / 1.08883);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

// Returns the colour seen by people without green cones: Viénot, Brettel, Mollon, "Digital video colourmaps for
// checking the legibility of displays by dichromats" (1999).
Eigen::Vector3d withoutGreen(const Eigen::Vector3d& rgb) {
  Eigen::Matrix3d seen;
  seen << 0.29275, 0.70725, 0.0, 0.29275, 0.70725, 0.0, -0.02234, 0.02234, 1.0;
  return (seen * rgb).cwiseMax(0.0).cwiseMin(1.0);
}

}  // namespace

class ColourScaleTest : public QObject {
  Q_OBJECT

 private slots:
  void equalStepsLookEqual() {
    const ColourScale scale{2.0};
    constexpr int kSteps = 16;
    const double whole = (lab(linearRgb(scale.at(0.0))) - lab(linearRgb(scale.at(2.0)))).norm();
    for (int i = -kSteps; i < kSteps; ++i) {
      const auto a = lab(linearRgb(scale.at(2.0 * i / kSteps))), b = lab(linearRgb(scale.at(2.0 * (i + 1) / kSteps)));
      QVERIFY2(std::abs((b - a).norm() - whole / kSteps) < 0.05 * whole / kSteps, qPrintable(QString::number(i)));
    }
  }

  void bothSignsWeighTheSame() {
    const ColourScale scale{0.5};
    for (const double value : {0.1, 0.3, 0.5}) {
      const auto low = lab(linearRgb(scale.at(-value))), high = lab(linearRgb(scale.at(value)));
      QVERIFY(std::abs(low[0] - high[0]) < 0.5);
      QVERIFY(low[2] < -5.0 && high[1] > 5.0);  // blue, red
    }
    const QColor middle = scale.at(0.0);
    QVERIFY(std::abs(middle.red() - middle.blue()) <= 2 && middle.red() > 230);
  }

  void whatLiesBeyondHasTheColourOfTheEnd() {
    const ColourScale scale{1.0};
    const double infinity = std::numeric_limits<double>::infinity();
    QCOMPARE(scale.at(7.0), scale.at(1.0));
    QCOMPARE(scale.at(-infinity), scale.at(-1.0));
    const QColor unknown = scale.at(std::nan(""));
    QVERIFY(unknown.saturation() < 5 && unknown.lightness() < 200);
  }

  // Both signs can be distinguished, and each from the middle.
  void forPeopleWithoutGreenCones() {
    const ColourScale scale{1.0};
    const auto seen = [&](double value) { return lab(withoutGreen(linearRgb(scale.at(value)))); };
    for (const double value : {0.3, 0.6, 1.0}) {
      QVERIFY((seen(value) - seen(-value)).norm() > 20.0 * value);
      QVERIFY((seen(value) - seen(0.0)).norm() > 20.0 * value);
    }
  }
};

HANDWHEEL_TEST(ColourScaleTest)
#include "ColourScaleTest.moc"
