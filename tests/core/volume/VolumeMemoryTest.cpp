// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeMemory.h"

#include "TestClass.h"
#include "process/SystemMemory.h"
#include "volume/VolumeErrors.h"

#include <QtTest>
#include <limits>

using namespace handwheel;

// The memory of the system changes while this runs, but not by a fifth of it.
class VolumeMemoryTest : public QObject {
  Q_OBJECT

 private slots:
  void aQuarterIsTakenWithoutAsking() {
    const auto left = static_cast<double>(systemMemory());
    QVERIFY(!needsConsent(0.0));
    QVERIFY(!needsConsent(0.2 * left));
    QVERIFY(needsConsent(0.3 * left));
    for (const double none : {std::numeric_limits<double>::infinity(), std::nan("")}) QVERIFY(needsConsent(none));
  }

  void whatIsRefused() {
    const auto left = static_cast<double>(systemMemory());
    QVERIFY(!consentRefusal(0.1, 0.2 * left, false));
    const auto refused = consentRefusal(0.1, 0.5 * left, false);
    QVERIFY(refused && refused->code == VolumeErrors::NeedsConsent);
    QCOMPARE(refused->arguments.size(), std::size_t{3});
    QCOMPARE(refused->arguments[0], std::string("0.1"));
    QVERIFY(std::abs(std::stod(refused->arguments[1]) / (0.5e-6 * left) - 1.0) < 0.01);  // three digits
    QVERIFY(!consentRefusal(0.1, 0.5 * left, true));
    const auto tooLarge = consentRefusal(0.1, 2.0 * left, false);
    QVERIFY(tooLarge && tooLarge->code == VolumeErrors::TooLarge);
    QVERIFY(!consentRefusal(0.1, 2.0 * left, true));
    QVERIFY(memoryRefusal(0.1, 2.0 * left));
    QVERIFY(!memoryRefusal(0.1, 0.5 * left));
  }

  // The growth since the last check counts, not the total.
  void growthIsWatched() {
    const auto left = static_cast<double>(systemMemory());
    const double begin = 10.0 * left, little = 0.5 * VolumeGrowth::kBetweenLooks;
    VolumeGrowth growth(0.1, begin);
    for (const double bytes : {begin, begin + little, 0.0, begin + 0.6 * left, begin + 1.2 * left})
      QVERIFY(!growth.refusalAt(bytes));
    const auto refused = growth.refusalAt(begin + 3.2 * left);
    QVERIFY(refused && refused->code == VolumeErrors::TooLarge);
    QCOMPARE(refused->arguments[0], std::string("0.1"));
    QVERIFY(!VolumeGrowth(0.1, begin).refusalAt(std::nan("")));
  }
};

HANDWHEEL_TEST(VolumeMemoryTest)
#include "VolumeMemoryTest.moc"
