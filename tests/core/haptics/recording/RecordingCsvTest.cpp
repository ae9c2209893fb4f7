// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/recording/RecordingCsv.h"

#include <rapidcheck.h>
#include <QtTest>
#include <limits>
#include <sstream>

using namespace handwheel;

class RecordingCsvTest : public QObject {
  Q_OBJECT

 private slots:
  void oneLineForEachTick() {
    Recording recording;
    RecordedTick tick;
    tick.tick = 41;
    tick.tip.time = 0.041;
    tick.tip.position = {1, -2.5, 1e7};
    tick.felt.proxy = {0, -2.5, 1e7};
    tick.felt.force = {-0.1, 0, 0};
    tick.felt.isContact = true;
    tick.microseconds = 12.5f;
    tick.tip.buttons = 3;
    tick.sent.force = {0, -0.1, 0};
    tick.actions = 256;
    tick.tip.orientation = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
    tick.felt.torque = {7, 8, 9};
    tick.sent.torque = {0, 0, 6};
    tick.tip.velocity = {1, 2, 3};
    tick.hasSource = true;
    recording.add(tick);
    recording.addEvent({41, "Say \"a, b\""});
    recording.addEvent({41, "scene {\"k\":1}"});
    recording.addEvent({41, "second"});
    tick.tick = 42;
    tick.felt.isContact = false;
    tick.felt.force.x() = std::numeric_limits<double>::quiet_NaN();
    recording.add(tick);
    std::ostringstream out;
    QVERIFY(writeCsv(recording, out).hasValue());
    const auto lines = QString::fromStdString(out.str()).split('\n');
    QCOMPARE(lines.size(), 4);
    QVERIFY(
        lines[0].startsWith("t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us"));
    QVERIFY(
        lines[0].endsWith("tick,hip_qw,hip_qx,hip_qy,hip_qz,torque_x,torque_y,torque_z,sent_torque_x,sent_torque_y,"
                          "sent_torque_z,hip_vx,hip_vy,"
                          "hip_vz,period_s,stiffness_limit,damping_limit,restart,in_scene,event,scene"));
    QCOMPARE(lines[1],
             "0.041,1,-2.5,1e+07,0,-2.5,1e+07,-0.1,0,0,1,12.5,3,0,-0.1,0,256,41,0.5,-0.5,0.5,-0.5,7,8,9,0,0,6,1,2,3,0."
             "001,inf,inf,"
             "1,1,\"Say \"\"a, b\"\"; second\",\"{\"\"k\"\":1}\"");
    QCOMPARE(lines[2],
             "0.041,1,-2.5,1e+07,0,-2.5,1e+07,nan,0,0,0,12.5,3,0,-0.1,0,256,42,0.5,-0.5,0.5,-0.5,7,8,9,0,0,6,1,2,3,0."
             "001,inf,inf,1,1,,");
    QCOMPARE(lines[2].count(','), lines[0].count(','));
  }

  void nothingRecordedIsALineOfNames() {
    std::ostringstream out;
    QVERIFY(writeCsv(Recording(), out).hasValue());
    QCOMPARE(QString::fromStdString(out.str()).count('\n'), 1);
  }

  void aFullDiskIsReported() {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    const Status status = writeCsv(Recording(), out);
    QVERIFY(!status.hasValue());
    QVERIFY(status.error().code == ErrorCode::WriteFailed);
  }

  void canBeCancelled() {
    Recording recording;
    for (std::uint64_t i = 0; i < 5000; ++i) {
      RecordedTick tick;
      tick.tick = i;
      recording.add(tick);
    }
    JobState job;
    job.cancelled = true;
    std::ostringstream out;
    const Status status = writeCsv(recording, out, Progress(job));
    QVERIFY(!status.hasValue() && status.error().code == ErrorCode::Cancelled);
  }

  void readsBackWhatItWrote() {
    const bool ok = rc::check("every number and every event", [] {
      Recording recording;
      const auto ticks = *rc::gen::inRange(1, 20);
      for (int i = 0; i < ticks; ++i) {
        RecordedTick tick;
        tick.tick = static_cast<std::uint64_t>(7 + i);
        const auto number = [] { return *rc::gen::arbitrary<double>(); };
        tick.tip.time = 0.001 * i;
        tick.tip.position = {number(), number(), number()};
        RC_PRE(tick.tip.position.allFinite());
        tick.tip.velocity = {number(), number(), number()};
        tick.tip.dampingLimit = number();
        tick.tip.isRestart = *rc::gen::arbitrary<bool>();
        tick.hasSource = *rc::gen::arbitrary<bool>();
        tick.felt.force = {number(), number(), number()};
        recording.add(tick);
        if (*rc::gen::arbitrary<bool>())
          recording.addEvent(
              {tick.tick, *rc::gen::element<std::string>("a \"b\"", "line\nbreak", "scene {\"a\":\"1,2\"}")});
      }
      std::ostringstream out;
      RC_ASSERT(writeCsv(recording, out).hasValue());
      const std::string text = out.str();
      RC_ASSERT(isRecordingCsv(text));
      const Result<Recording> read = recordingFromCsv(text);
      RC_ASSERT(read.hasValue());
      std::ostringstream again;
      RC_ASSERT(writeCsv(*read, again).hasValue());
      RC_ASSERT(read->events().size() == recording.events().size());
      for (std::size_t i = 0; i < recording.size(); ++i) {
        RC_ASSERT((*read)[i].tip.position == recording[i].tip.position);
        RC_ASSERT((*read)[i].tip.velocity == recording[i].tip.velocity);
        RC_ASSERT((*read)[i].tip.isRestart == recording[i].tip.isRestart);
        RC_ASSERT((*read)[i].hasSource == recording[i].hasSource);
      }
      RC_ASSERT(again.str().size() == text.size());
    });
    QVERIFY(ok);
  }

  // Any text gives a result, or an error with a line number.
  void refusesWhatIsNoTable() {
    Recording recording;
    RecordedTick tick;
    tick.tip.position = {1, 2, 3};
    for (int i = 0; i < 3; ++i, ++tick.tick) recording.add(tick);
    std::ostringstream out;
    QVERIFY(writeCsv(recording, out).hasValue());
    const std::string text = out.str();
    QVERIFY(!isRecordingCsv("t_s,x_mm,y_mm,z_mm\n0,1,2,3\n"));
    QVERIFY(recordingFromCsv("").error().code == ErrorCode::HeaderMalformed);
    const std::size_t third = text.find('\n', text.find('\n') + 1) + 1;
    std::string wrong = text;
    wrong[third] = 'x';
    const Result<Recording> read = recordingFromCsv(wrong);
    QVERIFY(!read && read.error().code == ErrorCode::NumberMalformed);
    QCOMPARE(read.error().position.value, std::uint64_t{3});
    wrong.replace(third, 1, "nan");
    for (std::size_t cut = 0; cut < text.size(); ++cut) {
      const Result<Recording> part = recordingFromCsv(std::string_view(text).substr(0, cut));
      QVERIFY(!part || part->size() <= 3);
    }
  }
};

HANDWHEEL_TEST(RecordingCsvTest)
#include "RecordingCsvTest.moc"
