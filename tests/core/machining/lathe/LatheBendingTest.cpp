// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LoadedLathe.h"
#include "TestClass.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kGrip = 20.0, kModulus = 210e3;
constexpr StockCylinder kSlender{12.0, 170.0, 0.0};

LatheSetup slenderSetup() {
  LatheSetup setup = setupWith(0.0, 0.0);
  setup.chuck.grip = kGrip;
  return setup;
}

// The law presses with k = 500 N/mm² · 0.2 mm for each mm of depth.
constexpr double kPressing = 100.0;

// Returns the yielding δ at a height of a bar that is turned from its end: the force k(t - δ) on the arm a bends it by
// c k (t - δ), with c = a³/(3 E I) for a cantilever of the uncut diameter. So δ = c k t / (1 + c k).
double yieldedAt(double z, double depth) {
  const double arm = z - kGrip, moment = M_PI * std::pow(kSlender.diameter, 4) / 64.0;
  const double give = kPressing * std::pow(arm, 3) / (3.0 * kModulus * moment);
  return give * depth / (1.0 + give);
}

}  // namespace

class LatheBendingTest : public QObject {
  Q_OBJECT

 private slots:
  // A bar of 12 mm that stands out by 150 mm, set to 10 mm, is 10.69 mm at its free end, and tapers down to 10 mm at
  // the chuck as the beam does.
  void aSlenderBarIsATaper() {
    LoadedLathe lathe(slenderSetup(), 500.0, kSlender, 0.0133);
    lathe.turnDown(5.0, 0.2, 75.0);
    QVERIFY(lathe.run.machine().tip().y() < 25.0);
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(std::abs(2.0 * yieldedAt(170.0, 1.0) - 0.690) < 1e-3);
    for (int i = 0; i < 10; ++i) {
      const double z = 170.0 - 14.0 * i;
      const double left = lathe.radiusAt(z) - 5.0, expected = yieldedAt(z, 1.0);
      QVERIFY2(std::abs(left - expected) < 0.03 * expected + 1e-4,
               qPrintable(QString("%1: %2 %3").arg(z).arg(left).arg(expected)));
    }
  }

  // Nothing is wavy: every sample is as thick as its neighbour on the chuck's side, or thicker.
  void theTaperHasNoRipple() {
    LoadedLathe lathe(slenderSetup(), 500.0, kSlender, 0.0133);
    lathe.turnDown(5.0, 0.2, 30.0);
    const TurnedProfile& part = lathe.run.profile();
    for (std::size_t i = part.size() - 1; part.z(i) > 130.0; --i)
      QVERIFY2(part.radius(i) >= part.radius(i - 1) - 1e-5, qPrintable(QString::number(part.z(i))));
  }

  // The panel tells the same: twice the yielding, on the diameter, at its largest, which is at the free end.
  void theWarningIsWhatThePartMeasures() {
    LoadedLathe lathe(slenderSetup(), 500.0, kSlender, 0.0133);
    lathe.turnDown(5.0, 0.2, 20.0);
    const LatheWarning* const warning = lathe.warningOf(Rule::Deflection);
    QVERIFY(warning);
    const double measured = 2.0 * (lathe.radiusAt(169.5) - 5.0);
    QVERIFY2(std::abs(warning->warning.value / measured - 1.0) < 0.03,
             qPrintable(QString("%1 %2").arg(warning->warning.value).arg(measured)));
  }

  // On a centre the middle of the bar gives way by 7 L³ / 768 EI for each newton (a propped cantilever), not by the
  // L³ / 24 EI of a bar without one.
  void aBarOnACentre() {
    LatheSetup setup = slenderSetup();
    setup.tailstock.fitting = LatheFitting::Centre;
    setup.tailstock.position = kSlender.length;
    LoadedLathe lathe(setup, 500.0, kSlender, 0.0133);
    lathe.send({Lever::Spindle, LatheAxis::Carriage, 1.0});
    lathe.send({Lever::MoveTip, LatheAxis::Carriage, 6.5, 110.0});
    lathe.pass(4.0);
    lathe.send({Lever::Feed, LatheAxis::Cross, -0.1});
    lathe.pass(1.0);
    lathe.send({Lever::Feed, LatheAxis::Carriage, -0.2});
    lathe.pass(10.0);
    QVERIFY(lathe.run.collisions().empty());
    const double set = lathe.run.machine().tip().x(), depth = 6.0 - set;
    QVERIFY(depth > 0.3 && lathe.run.machine().tip().y() < 94.0);
    const double moment = M_PI * std::pow(kSlender.diameter, 4) / 64.0;
    const double give = kPressing * 7.0 * std::pow(150.0, 3) / (768.0 * kModulus * moment);
    const double left = lathe.radiusAt(kGrip + 75.0) - set, expected = depth * give / (1.0 + give);
    QVERIFY2(std::abs(left / expected - 1.0) < 0.04, qPrintable(QString("%1 %2").arg(left).arg(expected)));
  }

  // A stiff bar is turned to its size: ⌀40 by 75 mm gives way by 50 N · 75³/(3 · 210e3 · 125664) = 0.27 µm.
  void aStiffBarKeepsItsSize() {
    LatheSetup setup = setupWith(0.0, 0.0);
    setup.chuck.grip = 25.0;
    LoadedLathe lathe(setup, 500.0);
    lathe.turnDown(19.5, 0.2, 6.0);
    QVERIFY(std::abs(lathe.radiusAt(95.0) - 19.5) < 1e-3);
  }

  // The sums that a cut brings up to date are those of a part that is looked at anew.
  void theBeamFollowsTheCut() {
    TurnedProfile part(kSlender, 0.05);
    WorkBeam beam(part, kGrip);
    for (const double z : {160.0, 60.0, 100.0, 165.0}) {
      const TurnedProfile::Range changed = part.cut({3.0 + z / 100.0, z}, {3.0 + z / 100.0, z - 10.0}, 0.4);
      beam.change(part, changed);
      const SlenderWork kept = beam.at(part, 150.0), anew = beamOf(part, kGrip, 150.0);
      QVERIFY(std::abs(kept.diameter - anew.diameter) < 1e-9 && kept.length == anew.length);
    }
    for (std::size_t i = 1000; i < 1010; ++i) part.limitOuter(i, 0.0);  // parted off at z = 50
    beam.change(part, {1000, 1010});
    QVERIFY(std::abs(beam.at(part, 150.0).length - 29.95) < 1e-9);
  }
};

HANDWHEEL_TEST(LatheBendingTest)
#include "LatheBendingTest.moc"
