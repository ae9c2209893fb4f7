// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "window/haptics/Playback.h"

#include <QSignalSpy>
#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kHalf = 500'000;  // between two ticks, wherever they are rounded to

// Two seconds at 1 kHz along x, 1 mm each tick; for some ticks the device was away.
StoredRecording walk() {
  StoredRecording recording{"0001", "walk", "hand", 4.0, {}};
  for (int i = 0; i <= 2000; ++i) {
    RecordedTick tick;
    tick.tick = static_cast<std::uint64_t>(i);
    tick.tip.time = 0.001 * i;
    tick.tip.position = Vec3(i, 0, 0);
    tick.felt.proxy = Vec3(i, 1, 0);
    tick.felt.force = Vec3(0, 0, 0.001 * i);
    tick.status = i >= 500 && i < 600 ? DeviceStatus::Absent : DeviceStatus::Ready;
    recording.ticks.add(tick);
  }
  return recording;
}

}  // namespace

class PlaybackTest : public QObject {
  Q_OBJECT

 private slots:
  void withoutOneNothingIsShownAndNothingRuns() {
    VirtualClock clock;
    Playback playback(clock);
    QSignalSpy moved(&playback, &Playback::moved);
    playback.play();
    playback.seek(1.0);
    playback.pause();
    playback.leave();
    QTest::qWait(60);
    QCOMPARE(moved.count(), 0);
    QVERIFY(!playback.cursor() && !playback.isRecordingLoaded());
  }

  void theCursorIsThatOfTheMoment() {
    VirtualClock clock;
    Playback playback(clock);
    playback.takeUp(walk());
    QCOMPARE(playback.duration(), 2.0);
    playback.play();
    clock.set(250 * kMs + kHalf);
    const std::optional<DeviceCursor> cursor = playback.cursor();
    QVERIFY(cursor.has_value());
    QCOMPARE(cursor->tip, Vec3(250, 0, 0));
    QCOMPARE(cursor->proxy, Vec3(250, 1, 0));
    QCOMPARE(cursor->force, Vec3(0, 0, 0.25));
    QCOMPARE(cursor->limit, 4.0);
    clock.set(550 * kMs + kHalf);
    QVERIFY(!playback.cursor());  // it did not know where it was
    clock.set(700 * kMs + kHalf);
    QCOMPARE(playback.cursor()->tip.x(), 700.0);
  }

  // The same moments of the clock give the same cursors.
  void isTheSameEachTime() {
    std::vector<double> seen[2];
    for (std::vector<double>& run : seen) {
      VirtualClock clock;
      Playback playback(clock);
      playback.takeUp(walk());
      playback.play();
      for (const int ms : {3, 17, 400, 401, 1999}) {
        clock.set(ms * kMs + kHalf);
        run.push_back(playback.cursor()->tip.x());
      }
      playback.pause();
      playback.seek(0.1235);
      run.push_back(playback.cursor()->tip.x());
    }
    QVERIFY(seen[0] == seen[1]);
    QCOMPARE(seen[0].back(), 123.0);
  }

  // While it plays it tells so with each frame; paused, or at its end, nothing runs.
  void tellsWhileItPlays() {
    VirtualClock clock;
    Playback playback(clock);
    playback.takeUp(walk());
    playback.play();
    QSignalSpy moved(&playback, &Playback::moved);
    QTRY_VERIFY(moved.count() > 3);
    playback.pause();
    QTest::qWait(50);
    moved.clear();
    QTest::qWait(60);
    QCOMPARE(moved.count(), 0);
    playback.play();
    clock.set(10'000 * kMs);
    QTRY_VERIFY(!playback.isPlaying());
    QCOMPARE(playback.position(), 2.0);
    QTest::qWait(50);
    moved.clear();
    QTest::qWait(60);
    QCOMPARE(moved.count(), 0);
    QCOMPARE(playback.cursor()->tip.x(), 2000.0);  // it stays where it ended
  }

  void whatIsNoNumberIsNotDrawn() {
    VirtualClock clock;
    Playback playback(clock);
    StoredRecording recording{"0001", "bad", "", 0.0, {}};
    RecordedTick tick;
    tick.status = DeviceStatus::Ready;
    tick.tip.position = Vec3(1, 2, 3);
    tick.felt.proxy.x() = std::nan("");
    tick.felt.force.y() = std::numeric_limits<double>::infinity();
    recording.ticks.add(tick);
    playback.takeUp(recording);
    QCOMPARE(playback.cursor()->proxy, Vec3(1, 2, 3));
    QVERIFY(playback.cursor()->force.isZero());
    QVERIFY(playback.cursor()->limit > 0.0);
  }
};

HANDWHEEL_WIDGET_TEST(PlaybackTest)
#include "PlaybackTest.moc"
