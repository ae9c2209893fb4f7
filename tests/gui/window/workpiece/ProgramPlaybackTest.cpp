// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "ProgramWindow.h"
#include "window/workpiece/program/ProgramPlayer.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>

using namespace handwheel;
using namespace handwheel::test;

namespace {

double secondsOfProcessor() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Returns the least height of the shown part at which points lie between two radii, mm; infinite if none does.
double lowestBetween(const DisplayModel& shown, double inner, double outer) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const DisplayPart& part : shown.parts) {
    for (const Vec3& p : part.soup->points) {
      const double r = std::hypot(p.x(), p.y());
      if (r > inner && r < outer) lowest = std::min(lowest, (part.pose * p).z());
    }
  }
  return lowest;
}

}  // namespace

// Programs that are played in the window.
class ProgramPlaybackTest : public QObject {
  Q_OBJECT

 private slots:
  // While a program plays at ten times the speed of the machine, the view shows the part cut as far as the tool has
  // come, and the next frames' steps do not pile up.
  void thePartFollowsTheTool_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<double>("inner");
    QTest::addColumn<double>("outer");
    QString turning = "G7 G21 G97 S800 M3\nG0 X46 Z1\n";
    for (int i = 0; i < 20'000; ++i)
      turning += QString("G1 X%1 Z%2 F100\n").arg(i % 2 ? 46.0 : 46.001).arg(1.0 - 0.0035 * i);
    QTest::newRow("20,000 moves") << turning + "M2\n" << 20.0 << 24.0;
    QTest::newRow("a thread") << "G7 G21 G97 S60 M3\nG0 X47 Z4\nG33 Z-60 K1.5\nG0 X54\nM2\n" << 23.0 << 24.0;
  }
  void thePartFollowsTheTool() {
    QFETCH(QString, program);
    QFETCH(double, inner);
    QFETCH(double, outer);
    ProgramWindow window;
    QVERIFY(window.begin() && window.run(program.toLatin1().constData()));
    auto* const player = window.driver.find<ProgramPlayer>("programPlayer");
    window.driver.click("programPlay");
    QVERIFY(player->isPlaying());
    const auto shown = [&] { return window.session().picture().part; };
    const auto tip = [&] { return window.session().picture().tool.back().front().z(); };
    const double upper = window.document().workpiece().stock.position + window.document().workpiece().stock.length;
    QTRY_VERIFY_WITH_TIMEOUT(tip() < upper - 5.0, kPatienceMs);
    int steps = 0, behind = 0;
    const double begin = secondsOfProcessor();
    for (auto last = shown(); player->isPlaying() && steps < 40 && tip() > upper - 50.0;) {
      QTRY_VERIFY_WITH_TIMEOUT(shown() != last || !player->isPlaying(), kPatienceMs);
      last = shown();
      ++steps;
      // A turn of the thread leaves its groove at each height.
      if (std::abs(lowestBetween(*last, inner, outer) - tip()) > 4.0) ++behind;
    }
    const double seconds = secondsOfProcessor() - begin;
    qInfo("%d steps, %.1f ms of the processor each, %d behind", steps, 1e3 * seconds / std::max(steps, 1), behind);
    QVERIFY(steps > 5);
    QVERIFY2(behind * 4 <= steps, qPrintable(QString("%1 of %2").arg(behind).arg(steps)));
    window.clear();
  }
};

HANDWHEEL_WINDOW_TEST(ProgramPlaybackTest)
#include "ProgramPlaybackTest.moc"
