// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/Recording.h"

#include <QtTest>
#include <bit>
#include <sstream>

#include "HapticRecordings.h"
#include "TestClass.h"
#include "haptics/recording/RecordingBytes.h"
#include "haptics/recording/RecordingCsv.h"

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
  // The hand, the loop and its measured limits made these tips; the source alone computes the same forces from them.
  void replayGivesTheSameForcesBitForBit() {
    RecordedRun run;
    const Recording recording = run.record(4000);
    QCOMPARE(recording.size(), std::size_t{4000});
    StickyWall source;
    int same = 0;
    double largest = 0.0;
    recording.replay([&](const RecordedTick&) { return &source; },
                     [&](const RecordedTick& tick, const ForceOut& felt) {
                       same += isSameBits(tick.felt.force, felt.force) && isSameBits(tick.felt.torque, felt.torque) &&
                               isSameBits(tick.felt.proxy, felt.proxy) && isSameBits(tick.felt.gripper, felt.gripper);
                       largest = std::max(largest, felt.force.norm());
                     });
    QCOMPARE(same, 4000);
    QVERIFY(largest > 0.05);
  }

  // Another scene in the middle: the event says at which tick, and the one that follows gives the same forces again.
  void aSceneThatChangesIsFeltAgain() {
    RecordedRun run;
    const auto setScene = [&run](const char* note) {
      auto scene = std::make_unique<HapticScene>();
      scene->renderer = std::make_unique<StickyWall>();
      run.recorder->noteNextScene(note);
      run.loop->setScene(std::move(scene));
      run.recorder->fetch();  // its thread may do so at any time
    };
    setScene("wall");
    run.record(1500);
    setScene("never felt");  // replaced before the next tick
    setScene("wall again");
    const Recording recording = run.record(1500);
    QCOMPARE(recording.size(), std::size_t{3000});
    QCOMPARE(recording.events().size(), std::size_t{3});
    QCOMPARE(recording.events()[0].tick, recording[0].tick);
    QCOMPARE(recording.events()[1].text, std::string("scene never felt"));
    QCOMPARE(recording.events()[2].text, std::string("scene wall again"));
    QCOMPARE(recording.events()[2].tick, recording[1500].tick);

    const Recording stored = *recordingFromBytes(recordingBytes(recording));
    std::ostringstream table;
    QVERIFY(writeCsv(recording, table).hasValue());
    const Result<Recording> read = recordingFromCsv(table.str());
    QVERIFY(read.hasValue());
    for (const Recording* each : {&recording, &stored, &*read}) {
      std::unique_ptr<StickyWall> scene;
      auto event = each->events().begin();
      int same = 0;
      each->replay(
          [&](const RecordedTick& tick) {
            for (; event != each->events().end() && event->tick <= tick.tick; ++event) {
              if (event->text == "scene never felt") continue;
              auto next = std::make_unique<StickyWall>();
              if (scene) next->follow(*scene);
              scene = std::move(next);
            }
            return scene.get();
          },
          [&](const RecordedTick& tick, const ForceOut& felt) {
            same += isSameBits(tick.felt.force, felt.force) && isSameBits(tick.felt.proxy, felt.proxy);
          });
      QCOMPARE(same, 3000);
    }
  }

  // The whole runs on a virtual clock: hand, loop, safety and all.
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

  // Ticks without a scene, for example while the device was gone, are not given to the source.
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
    recording.replay([&](const RecordedTick&) { return &source; },
                     [&](const RecordedTick& t, const ForceOut&) {
                       QCOMPARE(t.tick % 3, std::uint64_t{0});
                       ++count;
                     });
    QCOMPARE(count, 4);
  }
};

HANDWHEEL_TEST(RecordingTest)
#include "RecordingTest.moc"
