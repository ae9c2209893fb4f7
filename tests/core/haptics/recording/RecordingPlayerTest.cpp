// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/recording/RecordingPlayer.h"

#include <rapidcheck.h>
#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr std::int64_t kMs = 1'000'000;  // ns

// Returns ticks at the times given, s.
Recording at(const std::vector<double>& times) {
  Recording recording;
  for (std::size_t i = 0; i < times.size(); ++i) {
    RecordedTick tick;
    tick.tick = i;
    tick.tip.time = times[i];
    recording.add(tick);
  }
  return recording;
}

}  // namespace

class RecordingPlayerTest : public QObject {
  Q_OBJECT

 private slots:
  void anEmptyOneHasNothingToSee() {
    VirtualClock clock;
    RecordingPlayer player(Recording(), clock);
    player.play();
    player.seek(3.0);
    QVERIFY(!player.tick() && !player.isPlaying());
    QCOMPARE(player.duration(), 0.0);
    QCOMPARE(player.position(), 0.0);
  }

  void runsAsTimeDoesAndEndsAtTheEnd() {
    VirtualClock clock;
    RecordingPlayer player(at({5.0, 5.001, 5.002, 5.010}), clock);
    QCOMPARE(player.tick()->tick, std::uint64_t{0});
    clock.set(700 * kMs);  // it is paused
    QCOMPARE(player.tick()->tick, std::uint64_t{0});
    player.play();
    QVERIFY(player.isPlaying());
    clock.set(701 * kMs + 1);
    QCOMPARE(player.tick()->tick, std::uint64_t{1});
    clock.set(709 * kMs);  // ticks are missing: the last one stays
    QCOMPARE(player.tick()->tick, std::uint64_t{2});
    clock.set(900 * kMs);
    QCOMPARE(player.tick()->tick, std::uint64_t{3});
    QVERIFY(!player.isPlaying());
    player.play();  // once more
    QVERIFY(player.isPlaying());
    QCOMPARE(player.position(), 0.0);
  }

  void pausesAndGoesOn() {
    VirtualClock clock;
    RecordingPlayer player(at({0.0, 1.0, 2.0, 3.0}), clock);
    player.play();
    clock.set(1500 * kMs);
    player.pause();
    clock.set(9000 * kMs);
    QVERIFY(!player.isPlaying());
    QCOMPARE(player.position(), 1.5);
    player.play();
    clock.set(9600 * kMs);
    QCOMPARE(player.tick()->tick, std::uint64_t{2});
    QVERIFY(player.isPlaying());
  }

  void anySeekStaysWithin() {
    VirtualClock clock;
    RecordingPlayer player(at({0.0, 1.0, 2.0}), clock);
    for (const double far : {-1.0, std::nan(""), -std::numeric_limits<double>::infinity()}) {
      player.seek(far);
      QCOMPARE(player.position(), 0.0);
    }
    player.seek(std::numeric_limits<double>::infinity());
    QCOMPARE(player.position(), 2.0);
    QCOMPARE(player.tick()->tick, std::uint64_t{2});
  }

  // By definition, tick by tick, it is the last whose time is not after the moment.
  void showsTheLastTickWhoseTimeHasCome() {
    QVERIFY(rc::check([] {
      std::vector<double> times{0.0};
      for (int i = *rc::gen::inRange(0, 40); i > 0; --i) times.push_back(times.back() + *rc::gen::inRange(0, 5) * 0.25);
      VirtualClock clock;
      RecordingPlayer player(at(times), clock);
      const double moment = *rc::gen::inRange(0, 200) * 0.125;
      player.seek(moment);
      std::size_t expected = 0;
      for (std::size_t i = 0; i < times.size(); ++i) {
        if (times[i] <= moment) expected = i;
      }
      RC_ASSERT(player.tick()->tick == expected);
    }));
  }

  // For any rounding of the difference of two times.
  void endsWithTheLastTick() {
    QVERIFY(rc::check([] {
      const double first = *rc::gen::inRange(0, 1000000) * 0.001, step = *rc::gen::inRange(1, 1000000) * 1e-5;
      VirtualClock clock;
      RecordingPlayer player(at({first, first + 0.5 * step, first + step}), clock);
      player.seek(player.duration());
      RC_ASSERT(player.tick()->tick == 2u);
    }));
  }

  // Written by hand, with decreasing times: some tick is returned, and the same each time.
  void timesThatGoBackDoNoHarm() {
    VirtualClock clock;
    RecordingPlayer player(at({3.0, 1.0, 2.0, -4.0}), clock);
    QCOMPARE(player.duration(), 0.0);
    player.seek(1.0);
    const RecordedTick* const first = player.tick();
    QVERIFY(first && first == player.tick());
  }
};

HANDWHEEL_TEST(RecordingPlayerTest)
#include "RecordingPlayerTest.moc"
