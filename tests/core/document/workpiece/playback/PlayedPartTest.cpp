// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/playback/PlayedPart.h"

#include "TestClass.h"
#include "document/workpiece/ProgramTrial.h"

#include <QtTest>
#include <cmath>
#include <ctime>

using namespace handwheel;

namespace {

constexpr double kPlayedSpacing = 0.0133;  // mm
constexpr double kPlayedChord = 0.01;      // mm
constexpr double kPlayedFrame = 0.04;      // s

// Shares of the duration of a program: in order, and in leaps.
constexpr double kPlayedShares[] = {0.05, 0.1,  0.2, 0.22, 0.3, 0.4, 0.45, 0.5,  0.55, 0.6, 0.66, 0.7,
                                    0.8,  0.85, 0.9, 0.95, 1.0, 0.9, 0.3,  0.31, 0.05, 0.6, 0.0,  1.0};

WorkpieceSnapshot playedBar() {
  WorkpieceSnapshot workpiece;
  workpiece.stock = {40.0, 100.0, -100.0};
  return workpiece;
}

ProgramTrial::Pointer playedTrial(const std::string& text) {
  const WorkpieceSnapshot bar = playedBar();
  const ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, bar.stock, 20.0, 0.4);
  const auto trial = ProgramTrial::run(bar, text, setup, kPlayedSpacing);
  return trial ? *trial : nullptr;
}

// A contour of 20,000 short moves.
std::string longProgram() {
  std::string text = "G7 G21 G97 S800 M3\nG0 X44 Z1\n";
  for (int i = 0; i < 20'000; ++i)
    text +=
        "G1 X" + std::to_string(36.0 + 2.0 * std::sin(0.01 * i)) + " Z" + std::to_string(1.0 - 0.003 * i) + " F160\n";
  return text + "M2\n";
}

// A thread of 1.5 mm in many passes, fed along its flank.
constexpr const char* kPlayedThreads =
    "G7 G21 G97 S400 M3\nG0 X44 Z4\nG76 P1.5 Z-50 I-4 J0.1 R1.5 K1.84 Q29.5 H2\nG0 X50 Z10\nM2\n";

double playingSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Returns true if two displays show the same triangles, each corner where it is in the other.
bool isSameDisplay(const DisplayModel& a, const DisplayModel& b) {
  if (a.parts.size() != b.parts.size()) return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    const TriangleSoup &one = *a.parts[i].soup, &other = *b.parts[i].soup;
    if (one.triangles.size() != other.triangles.size() || a.parts[i].group != b.parts[i].group) return false;
    for (std::size_t t = 0; t < one.triangles.size(); ++t)
      for (std::size_t c = 0; c < 3; ++c)
        if (one.points[one.triangles[t][c]] != other.points[other.triangles[t][c]]) return false;
  }
  return true;
}

// Returns the largest distance in r of shown points from the surface of a bar with threads, between its ends; mm.
double farthestFromThreads(const DisplayModel& shown, const ProgramTrial::Moment& moment) {
  double farthest = 0.0;
  for (const DisplayPart& part : shown.parts) {
    for (const Vec3& p : part.soup->points) {
      if (p.z() < 1.0 || p.z() > moment.profile.length() - 1.0) continue;
      const double angle = std::atan2(p.y(), p.x());
      const double surface =
          moment.threads ? moment.threads->radius(TurningSide::Outside, 20.0, 0.0, p.z(), angle) : 20.0;
      farthest = std::max(farthest, std::abs(std::hypot(p.x(), p.y()) - surface));
    }
  }
  return farthest;
}

}  // namespace

// The part that the view shows while a program is played.
class PlayedPartTest : public QObject {
  Q_OBJECT

 private slots:
  // At ten times the speed of the machine a frame is 0.4 s of the program. A step takes less than 100 ms of the
  // processor, the mean of them all and each single one, threads too.
  void aStepIsQuick_data() {
    QTest::addColumn<QString>("program");
    QTest::newRow("20,000 moves") << QString::fromStdString(longProgram());
    QTest::newRow("threads") << QString(kPlayedThreads);
  }
  void aStepIsQuick() {
    QFETCH(QString, program);
    const auto trial = playedTrial(program.toStdString());
    QVERIFY(trial && trial->part());
    const double duration = trial->steps().duration();
    PlayedPart played(kPlayedChord, -100.0);
    played.at(trial->at({})->profile, nullptr);
    int steps = 0;
    double all = 0.0, longest = 0.0;
    for (double time = 0.0; time < duration; time += 10.0 * kPlayedFrame * (1.0 + duration / 400.0)) {
      const double begin = playingSeconds();
      const auto moment = trial->at(trial->steps().at(time));
      played.at(moment->profile, moment->threads);
      const double seconds = playingSeconds() - begin;
      longest = std::max(longest, seconds);
      all += seconds;
      ++steps;
    }
    qInfo("%d steps of %.1f s: mean %.2f ms, longest %.2f ms", steps, duration, 1e3 * all / steps, 1e3 * longest);
    QVERIFY2(all / steps < 0.1 && longest < 0.3, qPrintable(QString("%1 %2").arg(all / steps).arg(longest)));
  }

  // Each step shows what a surface of the whole part shows: forwards, backwards, and over leaps.
  void stepsAreWhatTheyShow() {
    const auto trial = playedTrial(
        "G7 G21 G97 S800 M3\nG0 X36 Z1\nG1 Z-50 F400\nG0 X44\nZ1\nX30\nG1 Z-30\nG0 X44\nZ1\nX0\nG1 Z-20 F100\n"
        "G0 Z2\nX44\nZ-60\nG1 X-1\nG0 X44\nM2\n");
    QVERIFY(trial && trial->part());
    const TurnedProfile bar = trial->at({})->profile;
    PlayedPart played(0.05, -100.0);
    played.at(bar, nullptr);
    for (const double share : kPlayedShares) {
      const auto moment = trial->at(trial->steps().at(share * trial->steps().duration()));
      QVERIFY(moment.has_value());
      TurnedSurface whole(bar, 0.05);
      whole.update(moment->profile, {0, bar.size()});
      DisplayModel anew = displayOf(whole, -100.0);
      showPartedOff(anew, moment->profile);
      QVERIFY2(isSameDisplay(played.at(moment->profile, moment->threads), anew), qPrintable(QString::number(share)));
    }
  }

  void threadsAreWhereTheyAre_data() {
    QTest::addColumn<QString>("program");
    QTest::newRow("threads") << QString(kPlayedThreads);
    QTest::newRow("a tapered thread") << "G7 G21 G97 S400 M3\nG0 X38 Z4\nG33 X39.5 Z-40 K2\nG0 X44\nZ4\nX37.5\n"
                                         "G33 X39 Z-40 K2\nG0 X44\nM2\n";
    QTest::newRow("left-hand, of two starts") << "G7 G21 G97 S400 M4\nG0 X44 Z4\nX38\nG33 Z-40 K3\nG0 X44\nZ5.5\nX38\n"
                                                 "G33 Z-40 K3\nG0 X44\nZ4\nX37.5\nG33 Z-40 K3\nG0 X44\nM2\n";
  }
  void threadsAreWhereTheyAre() {
    QFETCH(QString, program);
    const auto trial = playedTrial(program.toStdString());
    QVERIFY(trial && trial->part());
    PlayedPart played(0.05, -100.0);
    played.at(trial->at({})->profile, nullptr);
    for (const double share : kPlayedShares) {
      const auto moment = trial->at(trial->steps().at(share * trial->steps().duration()));
      QVERIFY(moment.has_value());
      const double off = farthestFromThreads(played.at(moment->profile, moment->threads), *moment);
      QVERIFY2(off < 1e-6, qPrintable(QString("%1: %2").arg(share).arg(off)));
    }
  }

  // The threads are there before the end, and grow with the pass.
  void threadsArePlayed() {
    const auto trial = playedTrial(kPlayedThreads);
    const double duration = trial->steps().duration();
    double removed = 0.0;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const auto moment = trial->at(trial->steps().at(share * duration));
      QVERIFY(moment && moment->threads);
      const double now = moment->threads->volume(moment->profile);
      QVERIFY(now > removed);
      removed = now;
    }
    QVERIFY(std::abs(removed / trial->part()->threads()->volume(trial->part()->profile) - 1.0) < 1e-9);
  }
};

HANDWHEEL_TEST(PlayedPartTest)
#include "PlayedPartTest.moc"
