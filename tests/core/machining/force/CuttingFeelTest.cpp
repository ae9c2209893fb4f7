// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/CuttingFeel.h"

#include "TestClass.h"
#include "machining/force/CutWarnings.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double anyNumber() {
  constexpr double kOdd[] = {0.0, -1.0, 0.3, 5.0, 1e9, kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
  return kOdd[*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 8))];
}

// Returns the deflection of a beam at its load, by integrating its curvature M / EI twice; the support's reaction by
// bisection.
double integratedDeflection(const SlenderWork& work, double force) {
  constexpr int kSteps = 20'000;
  const double stiffness = work.modulus * M_PI * std::pow(work.diameter, 4) / 64.0, dx = work.length / kSteps;
  const auto bend = [&](double reaction, double& atLoad) {
    double slope = 0.0, bent = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double x = (i + 0.5) * dx;
      const double moment = force * std::max(work.position - x, 0.0) - reaction * (work.length - x);
      bent += slope * dx + 0.5 * moment / stiffness * dx * dx;
      slope += moment / stiffness * dx;
      if (x < work.position) atLoad = bent;
    }
    return bent;  // at the end
  };
  double atLoad = 0.0, low = 0.0, high = work.hasTailstock ? force : 0.0;
  for (int i = 0; i < 60; ++i) (bend(0.5 * (low + high), atLoad) > 0.0 ? low : high) = 0.5 * (low + high);
  bend(0.5 * (low + high), atLoad);
  return atLoad;
}

}  // namespace

// Wear, vibration and friction; bending, limits and their warnings.
class CuttingFeelTest : public QObject {
  Q_OBJECT

 private slots:
  // The measured means: 103.3/122.8/156.6 N, 61.9/98.6/207.3 N, 48.1/64.0/138.6 N at 0, 0.1 and 0.3 mm.
  void wearIsAsMeasured() {
    const CutForces sharp{103.3, 48.1, 61.9};
    QCOMPARE(worn(sharp, 0.0), sharp);
    const CutForces some = worn(sharp, 0.1), much = worn(sharp, 0.3);
    QVERIFY(std::abs(some.cutting - 122.8) < 0.5 && std::abs(some.radial - 98.6) < 0.5 &&
            std::abs(some.feed - 64.0) < 0.5);
    QVERIFY(std::abs(much.cutting - 156.6) < 0.8 && std::abs(much.radial - 207.3) < 0.8 &&
            std::abs(much.feed - 138.6) < 0.8);
    QCOMPARE(worn(sharp, 99.0), worn(sharp, CuttingFeel::kMostWear));
    QCOMPARE(worn(sharp, std::nan("")), sharp);
  }

  // Once a turn, of no mean, and never as large as the force.
  void vibrationSwingsWithTheSpindle() {
    CuttingFeel feel;
    feel.vibration = 0.2;
    feel.largestSwing = 4.0;
    double sum = 0.0, most = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double v = vibration(feel, 10.0, 2.0 * M_PI * i / 1000, 600.0, 0.001);
      sum += v;
      most = std::max(most, std::abs(v));
    }
    QVERIFY(std::abs(sum) < 1e-9 && std::abs(most - 2.0) < 1e-4);
    QVERIFY(std::abs(vibration(feel, 1e4, 0.5 * M_PI, 600.0, 0.001) - 4.0) < 1e-12);
    // A loop of 1 kHz samples a spindle of 15,000 r/min four times a turn: nothing is left of it there.
    QCOMPARE(vibration(feel, 10.0, 1.0, 15'000.0, 0.001), 0.0);
    QVERIFY(vibration(feel, 10.0, 1.0, 10'000.0, 0.001) > 0.0);
  }

  void vibrationIsBounded() {
    rc::check([] {
      CuttingFeel feel{anyNumber(), anyNumber(), anyNumber(), anyNumber(), anyNumber(), anyNumber()};
      const double force = anyNumber(), v = vibration(feel, force, anyNumber(), anyNumber(), anyNumber());
      RC_ASSERT(std::abs(v) <= CuttingFeel::kMostSwing);
      if (force >= 0.0) RC_ASSERT(std::abs(v) <= CuttingFeel::kMostVibration * force + 1e-12);
      const double slide = slideResistance(feel, anyNumber());
      RC_ASSERT(std::isfinite(slide) && std::isfinite(steepestDamping(feel)) && steepestDamping(feel) >= 0.0);
    });
  }

  // Against the motion, odd, and nowhere steeper than it says: so the hand never gets energy from it.
  void slidesResist() {
    const CuttingFeel feel;
    rc::check([&] {
      const double a = *rc::gen::inRange(-300'000, 300'001) / 1e3, b = *rc::gen::inRange(-300'000, 300'001) / 1e3;
      RC_ASSERT(slideResistance(feel, a) * a >= 0.0);
      RC_ASSERT(slideResistance(feel, -a) == -slideResistance(feel, a));
      RC_ASSERT(std::abs(slideResistance(feel, a) - slideResistance(feel, b)) <=
                steepestDamping(feel) * std::abs(a - b) + 1e-12);
    });
    QVERIFY(std::abs(slideResistance(feel, 100.0) - (feel.friction + 100.0 * feel.drag)) < 1e-12);
  }

  void beamsBendAsTheirCurvatureSays() {
    for (const bool hasTailstock : {false, true}) {
      for (const double position : {10.0, 100.0, 170.0, 200.0}) {
        const SlenderWork work{20.0, 200.0, position, 210e3, hasTailstock};
        const double expected = integratedDeflection(work, 300.0), found = deflection(work, 300.0);
        QVERIFY2(std::abs(found - expected) < 1e-3 * std::abs(expected) + 1e-9, qPrintable(QString::number(position)));
      }
    }
    QCOMPARE(deflection({0.0, 100.0, 50.0, 210e3, false}, 1.0), kInfinity);
    QCOMPARE(deflection({20.0, 0.0, 0.0, 210e3, true}, 1.0), 0.0);
  }

  void eachRuleIsNamed() {
    using Rule = CutWarning::Rule;
    const auto broken = [](const CutConditions& cut, const CutForces& forces, const SlenderWork& work,
                           const SpindleDrive& drive) {
      std::vector<Rule> rules;
      for (const CutWarning& warning : warningsFor(cut, forces, {}, work, drive)) {
        rules.push_back(warning.rule);
        if (textOf(warning).find(QByteArray(wordFor(warning.rule)).toUpper().left(1).toStdString()) != 0) return rules;
      }
      return rules;
    };
    const SlenderWork stout{60.0, 60.0, 60.0, 210e3, false}, slender{10.0, 90.0, 90.0, 210e3, false};
    const SpindleDrive strong{100.0, 1e4, 0.8}, weak{1.0, 10.0, 0.8};
    const CutConditions cut{2.0, 0.2, 150.0};
    QCOMPARE(broken(cut, {855, 300, 200}, stout, strong), std::vector<Rule>());
    QCOMPARE(broken(cut, {855, 300, 200}, stout, weak), (std::vector<Rule>{Rule::Power, Rule::Torque}));
    QCOMPARE(broken(cut, {855, 300, 200}, slender, strong),
             (std::vector<Rule>{Rule::Slenderness, Rule::Deflection, Rule::Chatter}));
    QCOMPARE(broken({1.0, 0.005, 150.0}, {20, 5, 5}, stout, strong), (std::vector<Rule>{Rule::Rubbing}));
    QCOMPARE(broken({0.0, 0.0, 0.0}, {}, stout, strong), std::vector<Rule>());
  }

  // A chip thinner than a micrometre is not shown as a number.
  void aThinChipInWords() {
    QCOMPARE(textOf({CutWarning::Rule::Rubbing, 4.27e-5, 0.009}),
             std::string("Rubbing: a chip of less than 0.001 mm is not cut but rubbed; 0.009 mm is the least."));
    QVERIFY(textOf({CutWarning::Rule::Rubbing, 0.002, 0.009}).find("a chip of 0.002 mm") != std::string::npos);
  }

  void pressingInWords() {
    const std::string text = textOf({CutWarning::Rule::Pressing, 0.2, 0.01});
    QVERIFY(text.starts_with("Pressing: ") && text.ends_with("all its force goes 0.01 mm."));
    QVERIFY(text.find("cannot be fed 0.2 mm into it") != std::string::npos);
  }
};

HANDWHEEL_TEST(CuttingFeelTest)
#include "CuttingFeelTest.moc"
