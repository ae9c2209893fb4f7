// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramWriter.h"

#include "BushPasses.h"
#include "TestClass.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The machine of the bar with the tools of the passes, whose bodies must meet nothing.
ProgramSetup bushSetup(std::span<const TurningPass> passes, ProgramDialect dialect) {
  ProgramSetup setup = usualSetup(dialect, kBushBar, 20.0, 0.0);
  for (const PassTool& tool : toolsOf(passes))
    setup.tools[tool.number] = {tool.noseRadius, tool.orientationIn(dialect), {0, 0}, tool.tool};
  const LatheSetup lathe = defaultLatheSetup(kBushBar);
  setup.lathe = ProgramLathe{lathe.chuck, lathe.tailstock, nullptr};
  return setup;
}

}  // namespace

// Recorded passes in a bore, written as a program. Those on the outside: RoughAndFinishTest.
class ProgramWriterTest : public QObject {
  Q_OBJECT

 private slots:
  // The program leaves the bush that its passes leave, its radii are those of the paths, and nothing collides.
  void aBushIsRepeated_data() {
    QTest::addColumn<bool>("isFanuc");
    QTest::newRow("LinuxCNC") << false;
    QTest::newRow("Fanuc") << true;
  }
  void aBushIsRepeated() {
    QFETCH(bool, isFanuc);
    const ProgramDialect dialect = isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc;
    const std::vector<TurningPass> passes = bushPasses();
    const TurnedProfile bar(kBushBar, 0.05);
    TurnedProfile expected = bar;
    for (const TurningPass& pass : passes) {
      QVERIFY(!refusalToProgram(pass));
      cut(expected, pass);
    }
    const ProgramSetup setup = bushSetup(passes, dialect);
    QCOMPARE(setup.tools.size(), std::size_t{4});
    QCOMPARE(setup.tools.at(1).noseRadius, 10.0);  // a drill has half its diameter
    QVERIFY(tipDirection(dialect, setup.tools.at(2).orientation) == ProfilePoint(1, -1));
    QVERIFY(tipDirection(dialect, setup.tools.at(4).orientation) == ProfilePoint(1, -1));
    const std::string text = programText(movesOf(passes, kBushBar, 100.0, {}), dialect, "bush");
    const auto path = runProgram(text, setup);
    QVERIFY2(bool(path), text.c_str());
    ProgramSimulation simulation(bar, *path, setup);
    QVERIFY(simulation.run({}));
    for (const ProgramCollision& each : simulation.collisions()) qWarning("collision in line %u", each.line);
    QVERIFY2(simulation.collisionCount() == 0, text.c_str());
    const TurnedProfile& part = simulation.part();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const auto near = [&](double z) { return std::abs(part.z(i) - z) < 2.0; };
      if (near(80.0) || near(60.0) || near(50.0) || near(91.0))
        continue;  // the back of an insert is not that of a nose
      QVERIFY2(std::abs(part.inner(i) - expected.inner(i)) < 2e-3, qPrintable(QString::number(part.z(i))));
      QVERIFY2(std::abs(part.radius(i) - expected.radius(i)) < 2e-3, qPrintable(QString::number(part.z(i))));
    }
    for (const auto& [z, r] : {std::pair(54.0, 10.0), {70.0, 11.5}, {86.0, 14.0}, {96.0, 15.5}})
      QVERIFY(std::abs(part.inner(static_cast<std::size_t>(std::lround(z / 0.05))) - r) < 2e-3);
  }

  // A pass that begins in a groove, as after a pause in it, goes in through the mouth that the pass before has left;
  // one that ends beside the bar goes up, and not through the bar.
  void groovesAndPathsBesideTheBar() {
    const std::vector<TurningPass> bush = bushPasses();
    TurningPass groove = bush[1], beside = bush[1];
    groove.path = {{13.0, 75.0}, {13.5, 75.0}, {13.5, 70.0}, {12.5, 70.0}};
    beside.path = {{11.5, 101.0}, {11.5, 104.0}, {23.0, 104.0}, {23.0, 70.0}};
    groove.times = beside.times = {0.0, 1.0, 2.0, 3.0};
    const double mouth = 11.0 - 1e-9, front = 100.0;
    const std::vector<TurningPass> grooved{bush[0], bush[1], groove}, along{bush[0], beside};
    int rapids = 0;
    for (const ToolMove& move : movesOf(grooved, kBushBar, 0.0, {})) {
      if (move.kind != ToolMove::Kind::Rapid || std::min(move.from.y(), move.to.y()) >= front) continue;
      ++rapids;
      QVERIFY(std::max(move.from.x(), move.to.x()) < mouth);
    }
    QVERIFY(rapids >= 4);
    for (const ToolMove& move : movesOf(along, kBushBar, 0.0, {})) {
      const bool isInside = std::min(move.from.y(), move.to.y()) < front;
      QVERIFY(!isInside || move.from.x() < 20.0 || move.to.x() >= 20.0);
    }
  }

  // 0.25 mm in each turn of 1680 r/min, then drawn back at 80 mm/s: at 500 r/min it is 0.25 mm in a turn still, in both
  // dialects. A pass that does not record its spindle keeps its feed in a minute.
  void theFeedPerRevolution() {
    TurningPass pass = bushPasses()[2];
    pass.path.clear();
    pass.times.clear();
    for (int i = 0; i <= 510; ++i) {
      pass.path.emplace_back(18.0, 101.0 - 0.1 * i);
      pass.times.push_back(0.1 * i / (0.25 * 28.0));
    }
    pass.path.emplace_back(40.0, 50.0);
    pass.times.push_back(pass.times.back() + 22.0 / 80.0);
    pass.speeds.assign(pass.path.size(), 1680.0);
    const std::vector<TurningPass> passes{pass};
    PassProgram slow;
    slow.spindle = 500.0;
    int cuts = 0;
    for (const ToolMove& move : movesOf(passes, kBushBar, 0.0, slow)) {
      if (move.kind != ToolMove::Kind::Feed) continue;
      QVERIFY(move.isPerRevolution);
      QCOMPARE(move.spindle, 500.0);
      if (move.to.x() != 18.0 || move.from.x() != 18.0) continue;
      ++cuts;
      QVERIFY2(std::abs(move.feed - 0.25) < 1e-4, qPrintable(QString::number(move.feed)));
    }
    QVERIFY(cuts >= 1);
    const auto textOf = [&](ProgramDialect dialect, const PassProgram& how) {
      return programText(movesOf(passes, kBushBar, 0.0, how), dialect, "feed");
    };
    const std::string cnc = textOf(ProgramDialect::LinuxCnc, slow), fanuc = textOf(ProgramDialect::Fanuc, slow);
    QVERIFY2(cnc.find("G97 S500") != std::string::npos && cnc.find("G95") != std::string::npos, cnc.c_str());
    QVERIFY2(fanuc.find("F0.25\n") != std::string::npos && fanuc.find("G98") == std::string::npos, fanuc.c_str());
    QVERIFY(textOf(ProgramDialect::LinuxCnc, {}).find("G97 S1680 ") != std::string::npos);
    for (const ToolMove& move : movesOf(bushPasses(), kBushBar, 0.0, {})) {
      QVERIFY(!move.isPerRevolution);
      QCOMPARE(move.spindle, MeanSpindle::kUsual);
    }
  }

  // Not even a drill of a file's making that is beside the axis, or a pass of one point, is a move that is no number.
  void strangePasses() {
    TurningPass beside = bushPasses().front(), point = bushPasses()[1], none = point;
    beside.path = {{3, 101}, {3, 60}};
    point.path = {{11.5, 70}};
    point.times = {0.0};
    none.path.clear();
    const std::vector<TurningPass> passes{none, beside, point};
    for (const ToolMove& move : movesOf(passes, kBushBar, 100.0, {}))
      QVERIFY(move.to.allFinite() && std::isfinite(move.feed) &&
              (move.kind == ToolMove::Kind::Rapid || move.feed > 0.0));
    QVERIFY(movesOf({}, kBushBar, 100.0, {}).empty());
  }
};

HANDWHEEL_TEST(ProgramWriterTest)
#include "ProgramWriterTest.moc"
