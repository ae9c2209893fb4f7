// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillProgram.h"

#include "TestClass.h"
#include "volume/VolumeErrors.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

std::vector<double> heights(const DrillProgram& program) {
  std::vector<double> all;
  for (const DrillProgram::Waypoint& waypoint : program.waypoints) all.push_back(waypoint.tip.z());
  return all;
}

}  // namespace

class DrillProgramTest : public QObject {
  Q_OBJECT

 private slots:
  // Two holes by G81: across at the first height, down fast to R, down by the feed, up fast.
  void plainCycle() {
    const auto program = readDrillProgram(
        "%\n(two holes) G21 G90 G94\nS1200 M3\nG0 X0 Y0 Z10\nG81 X5 Y2 Z-3 R1 F120 ; first\nX9\nG80\nM30\njunk");
    QVERIFY(program.hasValue());
    QCOMPARE(*program->spindle, 1200.0);
    QCOMPARE(heights(*program), (std::vector<double>{10, 10, 1, -3, 10, 10, 1, -3, 10}));
    QVERIFY((program->waypoints[3].tip - Vec3(5.0, 2.0, -3.0)).norm() < 1e-12);
    QVERIFY((program->waypoints[7].tip - Vec3(9.0, 2.0, -3.0)).norm() < 1e-12);
    // 4 mm at 2 mm/s; 13 mm fast.
    QVERIFY(std::abs(program->waypoints[3].time - program->waypoints[2].time - 2.0) < 1e-12);
    QVERIFY(std::abs(program->waypoints[4].time - program->waypoints[3].time - 13.0 / DrillProgram::kRapid) < 1e-12);
  }

  void dwellsAndHeights() {
    // Back to R only, and a pause of half a second at the bottom.
    const auto program = readDrillProgram("G0 X0 Y0 Z10\nG99 G82 X1 Y0 Z-1 R2 P0.5 F60\nX2\n");
    QVERIFY(program.hasValue());
    QCOMPARE(heights(*program), (std::vector<double>{10, 10, 2, -1, -1, 2, 2, -1, -1, 2}));
    QVERIFY(std::abs(program->waypoints[4].time - program->waypoints[3].time - 0.5) < 1e-12);
    // From below R it goes up first.
    const auto below = readDrillProgram("g0x0y0z0\ng81 x3 y0 z-2 r5 f100");
    QCOMPARE(heights(*below), (std::vector<double>{0, 5, 5, -2, 5}));
    QCOMPARE(heights(*readDrillProgram("G0 X0 Y0 Z1\nG4 P2\nG1 Z0 F60")), (std::vector<double>{1, 1, 0}));
  }

  // 5 mm in pecks of 2: to -2, -4 and -5 below R, out to R between, and back to a little above the last depth.
  void pecks() {
    const auto program = readDrillProgram("G0 X0 Y0 Z3\nG83 Z-5 R0 Q2 F60");
    QVERIFY(program.hasValue());
    const double c = DrillProgram::kPeckClearance;
    QCOMPARE(heights(*program), (std::vector<double>{3, 0, -2, 0, -2 + c, -4, 0, -4 + c, -5, 3}));
    // A peck that is deeper than the hole is the hole.
    QCOMPARE(heights(*readDrillProgram("G0 X0 Y0 Z3\nG83 Z-5 R0 Q20 F60")), (std::vector<double>{3, 0, -5, 3}));
  }

  // For any numbers, a cycle goes exactly as deep as Z, and time increases.
  void anyCycle() {
    QVERIFY(rc::check([] {
      const auto number = [](int low, int high) { return 0.01 * *rc::gen::inRange(low, high); };
      const double bottom = number(-3000, 0), above = number(0, 1000), peck = number(1, 500),
                   first = number(-500, 2000);
      const std::string text = "G0 X0 Y0 Z" + std::to_string(first) + "\nG83 X1 Y1 Z" + std::to_string(bottom) + " R" +
                               std::to_string(above) + " Q" + std::to_string(peck) + " F100\n";
      const auto program = readDrillProgram(text);
      RC_ASSERT(program.hasValue());
      double lowest = first, drilled = above;
      for (std::size_t i = 1; i < program->waypoints.size(); ++i) {
        const auto& [time, tip] = program->waypoints[i];
        RC_ASSERT(time > program->waypoints[i - 1].time);
        lowest = std::min(lowest, tip.z());
        // New ground is broken by no more than a peck.
        RC_ASSERT(drilled - tip.z() <= peck + 1e-9 || tip.z() >= above - 1e-9 || first < above);
        if (tip.x() == 1.0) drilled = std::min(drilled, tip.z());
      }
      RC_ASSERT(std::abs(lowest - std::min(first, bottom)) < 1e-6);
      RC_ASSERT(std::abs(program->waypoints.back().tip.z() - std::max(first, above)) < 1e-6);
    }));
  }

  void refusals_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("code");
    const auto row = [](const char* name, const char* text, int line, const ErrorDescription& code) {
      QTest::newRow(name) << QByteArray(text) << line << QString::fromStdString(std::string(code.id));
    };
    row("empty", "", 0, VolumeErrors::ProgramMovesNothing);
    row("arc", "G0 X0 Y0 Z1\nG2 X1 Y1 I1", 2, VolumeErrors::ProgramWord);
    row("inches", "G20", 1, VolumeErrors::ProgramWord);
    row("increments", "\n\nG91", 3, VolumeErrors::ProgramWord);
    row("unknown letter", "G0 X0 Y0 Z1 A3", 1, VolumeErrors::ProgramWord);
    row("repeats", "G0 X0 Y0 Z1\nG81 X1 Z-1 R0 L3 F9", 2, VolumeErrors::ProgramWord);
    row("twice", "G0 X0 X1 Y0 Z1", 1, VolumeErrors::ProgramWord);
    row("symbol", "G0 X0 Y0 Z1\n#1=3", 2, VolumeErrors::ProgramWord);
    row("open comment", "(hello", 1, VolumeErrors::ProgramWord);
    row("tool", "T1 M6", 1, VolumeErrors::ProgramWord);
    row("no number", "G0 X Y0 Z1", 1, ErrorCode::NumberMalformed);
    row("two points", "G0 X1.2.3 Y0 Z1", 1, ErrorCode::NumberMalformed);
    row("huge", "G0 X1000000000 Y0 Z1", 1, ErrorCode::NumberMalformed);
    row("no R", "G0 X0 Y0 Z1\nG81 X1 Z-1 F60", 2, VolumeErrors::ProgramLacks);
    row("no F", "G0 X0 Y0 Z1\nG81 X1 Z-1 R0", 2, VolumeErrors::ProgramLacks);
    row("no Q", "G0 X0 Y0 Z1\nG83 X1 Z-1 R0 F60", 2, VolumeErrors::ProgramLacks);
    row("no P", "G0 X0 Y0 Z1\nG82 X1 Z-1 R0 F60", 2, VolumeErrors::ProgramLacks);
    row("no motion", "G0 X0 Y0 Z1\nG80\nX3", 3, VolumeErrors::ProgramLacks);
    row("nowhere", "G1 Z1 F60", 1, VolumeErrors::ProgramLacks);
    row("cycle first", "G81 X1 Y1 Z-1 R0 F60", 1, VolumeErrors::ProgramLacks);
    row("upwards", "G0 X0 Y0 Z1\nG81 X1 Z3 R0 F60", 2, VolumeErrors::ProgramValue);
    row("feed 0", "F0", 1, VolumeErrors::ProgramValue);
    row("peck 0", "G0 X0 Y0 Z1\nG83 Z-1 R0 Q0 F60", 2, VolumeErrors::ProgramValue);
    row("two speeds", "S100\nS200", 2, VolumeErrors::ProgramValue);
    row("too many pecks", "G0 X0 Y0 Z1\nG83 Z-1000000 R0 Q0.01 F60", 2, VolumeErrors::ProgramTooLong);
  }
  void refusals() {
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(QString, code);
    const auto program = readDrillProgram(text.toStdString());
    QVERIFY(!program.hasValue());
    QCOMPARE(QString::fromStdString(std::string(program.error().code->id)), code);
    QCOMPARE(static_cast<int>(program.error().position.value), line);
  }
};

HANDWHEEL_TEST(DrillProgramTest)
#include "DrillProgramTest.moc"
