// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/Recording.h"

#include <QtTest>
#include <bit>

#include "HapticRecordings.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

bool isSameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool isSameBits(const Vec3& a, const Vec3& b) {
  return isSameBits(a.x(), b.x()) && isSameBits(a.y(), b.y()) && isSameBits(a.z(), b.z());
}

}  // namespace

class RecordingTest : public QObject {
  Q_OBJECT

 private slots:
  // The hand, the loop and its measured limits made these tips; the source alone makes the same forces of them again.
  void replayGivesTheSameForcesBitForBit() {
    RecordedRun run;
    const Recording recording = run.record(4000);
    QCOMPARE(recording.size(), std::size_t{4000});
    StickyWall source;
    int same = 0;
    double largest = 0.0;
    recording.replay(source, [&](const RecordedTick& tick, const ForceOut& felt) {
      same += isSameBits(tick.felt.force, felt.force) && isSameBits(tick.felt.torque, felt.torque) &&
              isSameBits(tick.felt.proxy, felt.proxy) && isSameBits(tick.felt.gripper, felt.gripper);
      largest = std::max(largest, felt.force.norm());
    });
    QCOMPARE(same, 4000);
    QVERIFY(largest > 0.05);
  }

  // And the whole of it on a virtual clock: hand, loop, safety and all.
  void twoRunsAreTheSameBitForBit() {
    RecordedRun one, other;
    const Recording a = one.record(3000), b = other.record(3000);
    for (std::size_t i = 0; i < a.size(); ++i) {
      QVERIFY(isSameBits(a[i].devicePosition, b[i].devicePosition));
      QVERIFY(isSameBits(a[i].sent.force, b[i].sent.force));
      QVERIFY(isSameBits(a[i].tip.stiffnessLimit, b[i].tip.stiffnessLimit));
      QCOMPARE(a[i].actions, b[i].actions);
    }
  }

  void whatIsMissingIsCounted() {
    Recording recording;
    RecordedTick tick;
    for (const std::uint64_t number : {5, 6, 7, 10, 11, 20}) {
      tick.tick = number;
      recording.add(tick);
    }
    QCOMPARE(recording.missing(), std::uint64_t{2 + 8});
  }

  // Ticks without a scene, as while the device was gone, are not given to the source.
  void onlyWhatTheSceneWasAskedIsReplayed() {
    Recording recording;
    RecordedTick tick;
    for (int i = 0; i < 10; ++i) {
      tick.hasSource = i % 3 == 0;
      tick.tick = static_cast<std::uint64_t>(i);
      recording.add(tick);
    }
    StickyWall source;
    int count = 0;
    recording.replay(source, [&](const RecordedTick& t, const ForceOut&) {
      QCOMPARE(t.tick % 3, std::uint64_t{0});
      ++count;
    });
    QCOMPARE(count, 4);
  }
};

HANDWHEEL_TEST(RecordingTest)
#include "RecordingTest.moc"
