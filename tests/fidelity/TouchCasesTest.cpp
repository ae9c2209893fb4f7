// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseRuns.h"
#include "TestClass.h"
#include "fidelity/PressedWall.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

const FidelityCase& caseOf(const char* id, std::size_t index) {
  return test::measured().find(id)->cases.at(index);
}

}  // namespace

// The measurements of touch agree with mechanics.
class TouchCasesTest : public QObject {
  Q_OBJECT

 private slots:
  void aPressedWall_data();
  void aPressedWall();
  void aWireLimitsTheRate();
  void theRateThatAStiffnessNeeds();
  void aFasterLoopCarriesAStifferWall();
  void velocityIsLateOrNoisy();
  void aProxyThatRestsTooSoon();
};

void TouchCasesTest::aPressedWall_data() {
  QTest::addColumn<double>("rate");
  QTest::addColumn<double>("latency");
  QTest::addColumn<double>("stiffness");
  QTest::addColumn<double>("felt");  // N/mm: the least of what is asked, 3 of the device, and b / (T/2 + td)
  QTest::newRow("soft") << 1000.0 << 0.0 << 0.1 << 0.1;
  QTest::newRow("as stiff as the loop allows") << 1000.0 << 0.0 << 1e3 << 1.0;
  QTest::newRow("at 500 Hz") << 500.0 << 0.0 << 1e3 << 0.5;
  QTest::newRow("as stiff as the device is") << 8000.0 << 0.0 << 1e3 << 3.0;
  QTest::newRow("1 ms late") << 1000.0 << 0.001 << 1e3 << 1.0 / 3.0;
  QTest::newRow("10 ms late") << 2000.0 << 0.01 << 1e3 << 0.0005 / 0.01025;
}

// Hooke's law, once all is at rest.
void TouchCasesTest::aPressedWall() {
  QFETCH(double, rate);
  QFETCH(double, latency);
  QFETCH(double, stiffness);
  QFETCH(double, felt);
  DeviceCapabilities device = simulatedDevice().capabilities;
  QCOMPARE(device.inherentDamping, 0.0005);
  device.latency = latency;
  const double depth = pressedDepth(device, rate, stiffness);
  QVERIFY2(std::abs(depth * felt / kPressingForce - 1.0) < 0.01, qPrintable(QString::number(depth)));
}

// With a packet a ms, each half a ms after the tick that waits for it, the delay is that half. At 2 kHz the same: each
// other tick is missed. At 500 Hz the period is 2 ms. At 4 kHz the tick that waits was due 0.75 ms before.
void TouchCasesTest::aWireLimitsTheRate() {
  const FidelityCase& wired = caseOf("servo.rate", 2);
  const auto felt = [&](double rate) { return kPressingForce / wired.run(rate, 1, {}).error; };
  QVERIFY(std::abs(felt(1000.0) / (0.0005 / (0.0005 + 0.0005)) - 1.0) < 0.02);
  QVERIFY(std::abs(felt(2000.0) / (0.0005 / (0.0005 + 0.0005)) - 1.0) < 0.02);
  QVERIFY(std::abs(felt(500.0) / (0.0005 / (0.001 + 0.0005)) - 1.0) < 0.02);
  QVERIFY(std::abs(felt(4000.0) / (0.0005 / (0.0005 + 0.00075)) - 1.0) < 0.02);
}

// K <= 2 b / T: 1 N/mm takes 1 kHz, 2 N/mm 2 kHz; with 0.2 ms of delay T = 2 (b / K - td). No loop is slower than
// 500 Hz or faster than 8 kHz.
void TouchCasesTest::theRateThatAStiffnessNeeds() {
  const FidelityCase &prompt = caseOf("contact.stiffness", 0), &late = caseOf("contact.stiffness", 1);
  for (double stiffness : {1.0, 2.0, 3.0}) {
    const FidelitySample sample = prompt.run(stiffness, 1, {});
    QVERIFY(std::abs(sample.cost - 1000.0 * stiffness) < 1e-6);
    QVERIFY(std::abs(sample.error - 2.0 / stiffness) < 0.01 * sample.error);
  }
  QCOMPARE(prompt.run(0.1, 1, {}).cost, 500.0);
  QVERIFY(std::abs(late.run(1.0, 1, {}).cost - 1.0 / (2.0 * (0.0005 - 0.0002))) < 1e-6);
  QCOMPARE(late.run(10.0, 1, {}).cost, 8000.0);  // in vain
  QVERIFY(std::abs(late.run(10.0, 1, {}).error - 2.0 / (0.0005 / (0.5 / 8000.0 + 0.0002))) < 0.02);
}

void TouchCasesTest::aFasterLoopCarriesAStifferWall() {
  const FidelitySample slow = caseOf("servo.rate", 0).run(500.0, 1, {}),
                       fast = caseOf("servo.rate", 0).run(2000.0, 1, {});
  QVERIFY(std::abs(slow.error / fast.error - 4.0) < 0.05);
}

// Two readings differ by steps of the device; a long window is late by half of itself, where the swing of 3 Hz has
// turned by 2 pi 3 td: for small angles that is the share by which the velocity is wrong.
void TouchCasesTest::velocityIsLateOrNoisy() {
  const FidelityCase& fast = caseOf("servo.velocity_window", 1);
  // A reading is wrong by a step / sqrt(12), a difference by sqrt(2) of that, in each of three directions.
  const double noise = std::sqrt(3.0 * 2.0 / 12.0) * 0.05 / 0.001;
  const FidelitySample noisy = fast.run(0.0005, 1, {});
  QVERIFY2(std::abs(noisy.error / noise - 1.0) < 0.15, qPrintable(QString::number(noisy.error)));
  QVERIFY(std::abs(noisy.cost - 0.0005) < 1e-9);
  const FidelitySample late = fast.run(0.0205, 1, {});
  QVERIFY(std::abs(late.cost - 0.01) < 1e-9);
  const double circular = 2.0 * M_PI * 3.0, rms = 20.0 * circular / std::sqrt(2.0);
  QVERIFY2(std::abs(late.error / (rms * 2.0 * std::sin(0.5 * circular * late.cost)) - 1.0) < 0.05,
           qPrintable(QString::number(late.error)));
}

// It lags by about as much as it may, a share of the diagonal of a ball of 38 mm with bumps of 3 %.
void TouchCasesTest::aProxyThatRestsTooSoon() {
  const double diagonal = 2.0 * 38.0 * std::sqrt(3.0);
  for (std::size_t i : {0, 1}) {
    const FidelityCase& slide = caseOf("proxy.tolerance", i);
    QCOMPARE(slide.run(1e-9, 1, {}).error, 0.0);
    const double coarse = slide.run(1e-4, 1, {}).error;
    QVERIFY2(coarse > 1e-6 * diagonal && coarse < 1.06e-4 * diagonal, qPrintable(QString::number(coarse)));
  }
}

HANDWHEEL_TEST(TouchCasesTest)
#include "TouchCasesTest.moc"
