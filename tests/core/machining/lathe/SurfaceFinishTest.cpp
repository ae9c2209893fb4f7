// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/SurfaceFinish.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheRun.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kPolished{40.0, 100.0, 0.0};
constexpr double kBeat = 0.001;  // s

// A lathe with a finishing tool, then paper, then a file in its post.
struct FinishBench {
  FinishBench() : run(setup(), shippedLatheTools(), TurnedProfile(kPolished, 0.05), state(setup())) {}

  static LatheSetup setup() {
    LatheSetup made = defaultLatheSetup(kPolished);
    for (LatheSlot& slot : made.stations) slot.place = slot.offset = {0.0, 0.0};
    made.stations[0].tool = "right-finishing";
    made.stations[1].tool = "paper-240";
    made.stations[2].tool = "file-flat";
    return made;
  }
  static LatheState state(const LatheSetup& setup) { return LatheMachine::initialState(setup, kPolished); }
  void send(LatheCommand::Kind kind, double value, double other = 0.0) {
    run.step(kBeat, std::vector<LatheCommand>{{kind, LatheAxis::Carriage, value, other}});
  }
  void pass(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kBeat)); ++i) run.step(kBeat, {});
  }
  // 0.2 mm off the end by a feed.
  void turn(double feed) {
    send(LatheCommand::Kind::Spindle, 1.0);
    send(LatheCommand::Kind::Place, 19.8, 102.0);
    pass(2.0);
    send(LatheCommand::Kind::Feed, -feed);
    pass(10.0);
    send(LatheCommand::Kind::Feed, 0.0);
    send(LatheCommand::Kind::Place, 40.0, 130.0);
    pass(2.0);
  }
  void rub(double tool, double seconds) {
    send(LatheCommand::Kind::Tool, tool);
    send(LatheCommand::Kind::Place, 20.5, 90.0);
    pass(2.0);
    send(LatheCommand::Kind::Place, 19.0, 90.0);
    pass(seconds);
    send(LatheCommand::Kind::Place, 40.0, 130.0);
    pass(2.0);
  }
  std::optional<double> at(double z) const {
    const auto i = static_cast<std::size_t>(std::lround(z / run.profile().spacing()));
    return run.finish().at(TurningSide::Outside, i, run.profile().radius(i));
  }

  LatheRun run;
};

}  // namespace

class SurfaceFinishTest : public QObject {
  Q_OBJECT

 private slots:
  // Ra = f² / 32 R of the feed and the nose of 0.4 mm; what was not cut is not known.
  void turnedSurfaces() {
    for (const double feed : {0.1, 0.2}) {
      FinishBench bench;
      bench.turn(feed);
      const std::optional<double> ra = bench.at(95.0);
      QVERIFY(ra);
      QVERIFY2(std::abs(*ra / (1000.0 * feed * feed / (32.0 * 0.4)) - 1.0) < 0.1, qPrintable(QString::number(*ra)));
      QVERIFY(!bench.at(30.0));
    }
  }

  // Paper makes it finer with the turns, down to its grain and no further; beside its width nothing changes.
  void paperAndFile() {
    FinishBench bench;
    bench.turn(0.2);
    const double turned = *bench.at(90.0), beside = *bench.at(99.0);
    QVERIFY(beside > 3.0 * 0.4);
    bench.rub(1.0, 1.2);
    const double first = *bench.at(90.0);
    QVERIFY(first < turned && first >= 0.4);
    bench.rub(1.0, 8.0);
    QVERIFY(std::abs(*bench.at(90.0) - 0.4) < 1e-6);
    QCOMPARE(bench.at(84.0).has_value(), true);
    // A file leaves its own marks on it.
    bench.rub(2.0, 2.0);
    QVERIFY(*bench.at(90.0) > 1.5);
    QVERIFY(bench.run.collisions().empty());
  }

  void marksOfAnotherRadiusDoNotCount() {
    SurfaceFinish finish(10);
    finish.set(TurningSide::Outside, 3, 20.0, 1.6);
    QVERIFY(std::abs(*finish.at(TurningSide::Outside, 3, 20.0) - 1.6) < 1e-6);
    QVERIFY(!finish.at(TurningSide::Outside, 3, 19.9));
    QVERIFY(!finish.at(TurningSide::Bore, 3, 20.0));
    QVERIFY(!finish.at(TurningSide::Outside, 10, 20.0));
    finish.set(TurningSide::Outside, 99, 20.0, 1.6);
    finish.set(TurningSide::Outside, 4, 20.0, 1e9);
    QCOMPARE(*finish.at(TurningSide::Outside, 4, 20.0), SurfaceFinish::kRoughest);
  }

  void formulas() {
    QVERIFY(std::abs(turnedRoughness(0.2, 0.8) - 1.5625) < 1e-9);
    QCOMPARE(turnedRoughness(0.0, 0.8), 0.0);
    QCOMPARE(turnedRoughness(0.2, 0.0), SurfaceFinish::kRoughest);
    QVERIFY(std::abs(abradedRoughness(3.2, 0.004, 0.4) - 2.2) < 1e-9);
    QCOMPARE(abradedRoughness(3.2, 1.0, 0.4), 0.4);
    QCOMPARE(abradedRoughness(0.2, 0.001, 1.6), 1.6);
  }
};

HANDWHEEL_TEST(SurfaceFinishTest)
#include "SurfaceFinishTest.moc"
