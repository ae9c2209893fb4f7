// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/ForceRecorder.h"

#include <QtTest>

#include "HapticRecordings.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

// Ten minutes at the largest rate.
static_assert(ForceRecorder::kMostTicks >= static_cast<std::size_t>(600 * kLargestServoRate));

class ForceRecorderTest : public QObject {
  Q_OBJECT

 private slots:
  // Ten minutes at 1 kHz.
  void tenMinutesWithoutALoss() {
    RecordedRun run;
    const Recording recording = run.record(600'000);
    QCOMPARE(recording.size(), std::size_t{600'000});
    QCOMPARE(recording.missing(), std::uint64_t{0});
    QCOMPARE(run.loop->droppedSamples(), std::uint64_t{0});
    QVERIFY(qAbs(recording[599'999].tip.time - 600.0) < 0.01);
  }

  // Records on threads, at 8 kHz, while this one looks at the recording.
  void threadsLoseNothing() {
    auto log = std::make_shared<ScriptedDevice::Log>();
    MonotonicClock clock;
    Service service("servo");
    ServoSettings settings;
    settings.rate = 8000.0;
    ServoLoop loop(std::make_unique<ScriptedDevice>(log), settings, clock, service);
    ForceRecorder recorder(loop);
    loop.start();
    recorder.start();
    QVERIFY(recorder.isRecording());
    std::size_t last = 0;
    while (last < 4000) {
      const std::size_t size = recorder.recording().size();
      QVERIFY(size >= last);
      last = size;
      QThread::msleep(5);
    }
    recorder.mark("enough");
    loop.stop();
    recorder.stop();
    const Recording recording = recorder.recording();
    QCOMPARE(recording.missing(), std::uint64_t{0});
    QCOMPARE(loop.droppedSamples(), std::uint64_t{0});
    QCOMPARE(recording[recording.size() - 1].tick, loop.latest().tick);
    QCOMPARE(recording.events().size(), std::size_t{1});
  }

  void eventsLieAtTheirTicks() {
    RecordedRun run;
    run.recorder->mark("before all");
    run.record(1000);
    run.recorder->mark("tool");
    const Recording recording = run.record(500);
    QCOMPARE(recording.events()[0].tick, std::uint64_t{0});
    QCOMPARE(recording.events()[1].tick, std::uint64_t{999});
    QCOMPARE(recording.size(), std::size_t{1500});
  }

  // A new recording starts with the ticks from now on, not with pending ones.
  void beginsAnew() {
    RecordedRun run;
    run.loop->runTicks(500);
    run.recorder->clear();
    const Recording recording = run.record(10);
    QCOMPARE(recording.size(), std::size_t{10});
    QCOMPARE(recording[0].tick, std::uint64_t{500});
  }

  // A device that is away for a while leaves no hole in the time that is played back.
  void timeGoesOnWithoutTheDevice() {
    auto log = std::make_shared<ScriptedDevice::Log>();
    VirtualClock clock;
    Service service("servo");
    ServoLoop loop(std::make_unique<ScriptedDevice>(log), ServoSettings(), clock, service);
    ForceRecorder recorder(loop);
    loop.runTicks(100);
    log->state.status = DeviceStatus::Absent;
    loop.runTicks(100);
    log->state.status = DeviceStatus::Ready;
    loop.runTicks(100);
    recorder.fetch();
    const Recording recording = recorder.recording();
    QCOMPARE(recording.size(), recorder.ticks());
    QCOMPARE(recording[150].status, DeviceStatus::Absent);
    for (std::size_t i = 1; i < recording.size(); ++i)
      QVERIFY(qAbs(recording[i].tip.time - recording[i - 1].tip.time - 0.001) < 1e-9);
    QCOMPARE(recorder.duration(), recording.duration());
    QVERIFY(qAbs(recording.duration() - 0.299) < 1e-6);
  }

  void endsWhenFull() {
    RecordedRun run;
    ForceRecorder small(*run.loop, 700);
    run.loop->runTicks(1000);
    QVERIFY(!small.isFull());
    small.fetch();
    QVERIFY(small.isFull());
    QCOMPARE(small.recording().size(), std::size_t{700});
  }

  // Nobody fetches: the ring fills, the loop goes on, and the recording shows the loss.
  void whatWasLostIsSeen() {
    RecordedRun run;
    run.loop->runTicks(20'000);
    QVERIFY(run.loop->droppedSamples() > 0);
    run.recorder->fetch();
    run.loop->runTicks(1);
    run.recorder->fetch();
    QCOMPARE(run.recorder->recording().missing(), run.loop->droppedSamples());
  }
};

HANDWHEEL_TEST(ForceRecorderTest)
#include "ForceRecorderTest.moc"
