// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/finish/FinishReading.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kReadBar{40.0, 100.0, 0.0};

// Samples from first on, before last, of one pass.
void mark(SurfaceFinish& finish, TurningSide side, std::size_t first, std::size_t last, float ra, float feed,
          std::uint32_t pass) {
  for (std::size_t i = first; i < last; ++i) finish.set(side, i, {ra, feed, pass});
}

}  // namespace

class FinishReadingTest : public QObject {
  Q_OBJECT

 private slots:
  // 16 of 101 samples may be rougher (16 %), and 17 not.
  void aSixthMayBeRougher() {
    const TurnedProfile profile(kReadBar, 1.0);
    SurfaceFinish finish(profile.size());
    mark(finish, TurningSide::Outside, 0, 101, 0.8f, 0.1f, 0);
    mark(finish, TurningSide::Outside, 40, 56, 3.2f, 0.2f, 1);
    auto reading = readFinish(finish, profile, TurningSide::Outside, {0.0, 100.0});
    QVERIFY(reading && reading->roughness == 0.8f && reading->largest == 3.2f && reading->largestAt == 40.0);
    mark(finish, TurningSide::Outside, 56, 57, 3.2f, 0.2f, 1);
    QCOMPARE(readFinish(finish, profile, TurningSide::Outside, {0.0, 100.0})->roughness, double{3.2f});
    QVERIFY(!readFinish(finish, profile, TurningSide::Bore, {0.0, 100.0}));
    QVERIFY(!readFinish(finish, profile, TurningSide::Outside, {60.2, 60.8}));  // between two samples
    finish.set(TurningSide::Outside, 70, FinishMark());
    QVERIFY(!readFinish(finish, profile, TurningSide::Outside, {0.0, 100.0}));
    QVERIFY(readFinish(finish, profile, TurningSide::Outside, {0.0, 69.0}));
  }

  void stretches() {
    TurnedProfile profile(kReadBar, 1.0);
    SurfaceFinish finish(profile.size());
    mark(finish, TurningSide::Outside, 10, 20, 0.8f, 0.1f, 0);
    mark(finish, TurningSide::Outside, 20, 30, 1.6f, 0.2f, 4);
    mark(finish, TurningSide::Outside, 40, 41, 0.8f, 0.1f, 0);
    mark(finish, TurningSide::Bore, 0, 101, 0.4f, 0.1f, 5);
    for (std::size_t i = 90; i < 101; ++i) profile.limitInner(i, 5.0);
    const auto all = finishIntervals(finish, profile, TurningSide::Outside);
    QCOMPARE(all.size(), std::size_t{3});
    QVERIFY(all[0].from == 10.0 && all[0].to == 19.0 && all[0].pass == 0 && all[0].reading.roughness == 0.8f);
    QVERIFY(all[1].from == 20.0 && all[1].to == 29.0 && all[1].pass == 4 && all[1].feed == 0.2f);
    QVERIFY(all[2].from == 40.0 && all[2].to == 40.0);
    const auto bore = finishIntervals(finish, profile, TurningSide::Bore);
    QVERIFY(bore.size() == 1 && bore[0].from == 90.0 && bore[0].to == 100.0);
    // Nothing is left of the part there.
    for (std::size_t i = 12; i < 15; ++i) profile.limitOuter(i, 0.0);
    QCOMPARE(finishIntervals(finish, profile, TurningSide::Outside).size(), std::size_t{4});
    QVERIFY(finishIntervals(SurfaceFinish(), profile, TurningSide::Outside).empty());
  }
};

HANDWHEEL_TEST(FinishReadingTest)
#include "FinishReadingTest.moc"
