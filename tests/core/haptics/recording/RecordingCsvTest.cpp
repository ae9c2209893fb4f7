// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/recording/RecordingCsv.h"

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
    recording.add(tick);
    recording.addEvent({41, "Say \"a, b\""});
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
    QVERIFY(lines[0].endsWith(
        "tick,hip_qw,hip_qx,hip_qy,hip_qz,torque_x,torque_y,torque_z,sent_torque_x,sent_torque_y,sent_torque_z,event"));
    QCOMPARE(lines[1],
             "0.041,1,-2.5,1e+07,0,-2.5,1e+07,-0.1,0,0,1,12.5,3,0,-0.1,0,256,41,0.5,-0.5,0.5,-0.5,7,8,9,0,0,6,\"Say "
             "\"\"a, b\"\"; second\"");
    QCOMPARE(lines[2],
             "0.041,1,-2.5,1e+07,0,-2.5,1e+07,nan,0,0,0,12.5,3,0,-0.1,0,256,42,0.5,-0.5,0.5,-0.5,7,8,9,0,0,6,");
    QCOMPARE(lines[1].section('"', 0, 0).count(','), lines[0].count(','));
  }

  void nothingRecordedIsALineOfNames() {
    std::ostringstream out;
    QVERIFY(writeCsv(Recording(), out).hasValue());
    QCOMPARE(QString::fromStdString(out.str()).count('\n'), 1);
  }

  void aFullDiskIsTold() {
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
};

HANDWHEEL_TEST(RecordingCsvTest)
#include "RecordingCsvTest.moc"
