// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "machining/force/KienzleModel.h"
#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheRun.h"
#include "machining/measure/ThreadMeasure.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/program/ProgramWriter.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kThreadedBar{20.0, 60.0, 0.0};

std::vector<TurningPass> passesOfProgram(const std::string& text, ProgramDialect dialect) {
  ProgramSetup setup;
  setup.dialect = dialect;
  setup.reference = {50.0, 50.0};
  const Result<ToolPath> path = runProgram(text, setup);
  if (!path) return {};
  const TurnedProfile bar(kThreadedBar, 0.02);
  ProgramSimulation simulation(bar, *path, setup);
  simulation.run({});
  return simulation.part() == bar ? simulation.takePasses() : std::vector<TurningPass>();  // the envelope stays
}

std::shared_ptr<const PartThreads> threadsIn(const std::vector<TurningPass>& passes) {
  TurningPasses all;
  for (const TurningPass& pass : passes) all.push_back(std::make_shared<const TurningPass>(pass));
  return PartThreads::of(all);
}

}  // namespace

// Threads by programs and by the half-nut. M20 × 2.5 with a sharp tool: the groove is 1.5 mm deep, so that the crest is
// as wide as the groove at 2.5 / 4 / tan 30° above its bottom.
class ThreadProgramTest : public QObject {
  Q_OBJECT

 private slots:
  void programsCutThreads_data() {
    QTest::addColumn<int>("dialect");
    QTest::addColumn<QString>("program");
    QTest::addColumn<bool>("isLeft");
    const auto row = [](const char* name, ProgramDialect dialect, const char* text, bool isLeft) {
      QTest::newRow(name) << static_cast<int>(dialect) << QString(text) << isLeft;
    };
    row("G33", ProgramDialect::LinuxCnc, "G21 G18 G8 G97 S300 M3\nG0 X8.5 Z5\nG33 Z-40 K2.5\nG0 X15\nM2\n", false);
    row("G33 backwards", ProgramDialect::LinuxCnc,
        "G21 G18 G8 G97 S300 M4\nG0 X12 Z5\nX8.5\nG33 Z-40 K2.5\nG0 X15\nM2\n", true);
    row("G76", ProgramDialect::LinuxCnc,
        "G21 G18 G8 G97 S300 M3\nG0 X11 Z5\nG76 P2.5 Z-40 I-1 J0.3 K1.5 Q30 R1.5 H1\nG0 X15\nM2\n", false);
    row("G32", ProgramDialect::Fanuc, "G21 G97 S300 M3\nG0 X17. Z5.\nG32 Z-40. F2.5\nG0 X30.\nM30\n", false);
    row("G92", ProgramDialect::Fanuc, "G21 G97 S300 M3\nG0 X24. Z5.\nG92 X19. Z-40. F2.5\nX18.\nX17.\nG0 X30.\nM30\n",
        false);
  }
  void programsCutThreads() {
    QFETCH(int, dialect);
    QFETCH(QString, program);
    QFETCH(bool, isLeft);
    const auto passes = passesOfProgram(program.toStdString(), static_cast<ProgramDialect>(dialect));
    QVERIFY(!passes.empty());
    const auto threads = threadsIn(passes);
    QVERIFY(threads);
    QCOMPARE(threads->grooves().back().cut().isLeft, isLeft);
    const auto reading = measureThread(TurnedProfile(kThreadedBar, 0.02), *threads, TurningSide::Outside, {25.0, 58.0});
    QVERIFY(reading);
    QVERIFY(std::abs(reading->pitch - 2.5) < 1e-4);
    QVERIFY(std::abs(reading->major - 20.0) < 1e-9);
    QVERIFY2(std::abs(reading->minor - 17.0) < 6e-3, QByteArray::number(reading->minor));
    const double expected = 17.0 + 2.0 * 0.625 / std::tan(M_PI / 6.0);
    QVERIFY2(std::abs(reading->pitchDiameter - expected) < 4e-3, QByteArray::number(reading->pitchDiameter, 'g', 9));
  }

  // Written as a program and run again, the same groove.
  void writtenAsProgram() {
    const auto passes =
        passesOfProgram("G21 G18 G8 G97 S300 M3\nG0 X8.5 Z5.3\nG33 Z-40 K2.5\nG0 X15\nM2\n", ProgramDialect::LinuxCnc);
    QVERIFY(!passes.empty());
    for (const ProgramDialect dialect : {ProgramDialect::LinuxCnc, ProgramDialect::Fanuc}) {
      const std::string text = programText(movesOf(passes, kThreadedBar, 60.0, {}), dialect, "thread");
      const auto again = threadsIn(passesOfProgram(text, dialect));
      QVERIFY2(again, text.c_str());
      const auto before = threadsIn(passes);
      for (double z = 25.0; z < 55.0; z += 0.37) {
        const double was = before->grooves().front().radius(z, 1.0), is = again->grooves().front().radius(z, 1.0);
        QVERIFY(std::abs(was - is) < 1e-3);
      }
    }
  }

  // Threads in a bore, threads of several starts and left-hand threads are the same again: each groove where it was.
  void othersWrittenAsPrograms_data() {
    QTest::addColumn<bool>("isBore");
    QTest::addColumn<int>("starts");
    QTest::addColumn<bool>("isLeft");
    QTest::newRow("inner") << true << 1 << false;
    QTest::newRow("inner, left-hand") << true << 1 << true;
    QTest::newRow("inner, two starts") << true << 2 << false;
    QTest::newRow("outer, three starts") << false << 3 << false;
    QTest::newRow("outer, two starts, left-hand") << false << 2 << true;
  }
  void othersWrittenAsPrograms() {
    QFETCH(bool, isBore);
    QFETCH(int, starts);
    QFETCH(bool, isLeft);
    constexpr double kHole = 6.0;
    TurnedProfile part(kThreadedBar, 0.02);
    if (isBore) part.cutBore({kHole - 1.0, 70.0}, {kHole - 1.0, -5.0}, 1.0);
    // Left-hand threads begin in a relief.
    if (isBore)
      part.cutBore({6.2, 22.0}, {6.2, 16.0}, 1.0);
    else
      part.cut({9.9, 22.0}, {9.9, 16.0}, 1.0);
    TurningPass pass;
    pass.noseRadius = 0.1;
    pass.side = isBore ? TurningSide::Bore : TurningSide::Outside;
    const double centre = isBore ? kHole + 0.7 : 9.3;  // 0.8 mm deep
    pass.path = {{centre, 65.0}, {centre, 20.0}};
    pass.times = {0.0, 10.0};
    pass.thread = ThreadCut();
    pass.thread->pitch = 1.5;
    pass.thread->starts = starts;
    pass.thread->isLeft = isLeft;
    pass.thread->offset = 0.4;
    QVERIFY(!refusalToProgram(pass));
    const auto before = threadsIn({pass});
    for (const ProgramDialect dialect : {ProgramDialect::LinuxCnc, ProgramDialect::Fanuc}) {
      ProgramSetup setup = usualSetup(dialect, kThreadedBar, 10.0, 0.0);
      for (const PassTool& tool : toolsOf({&pass, 1}))
        setup.tools[tool.number] = {tool.noseRadius, tool.orientationIn(dialect), {0, 0}, tool.tool};
      const std::string text = programText(movesOf({&pass, 1}, kThreadedBar, 60.0, {}), dialect, "thread");
      const auto path = runProgram(text, setup);
      QVERIFY2(bool(path), text.c_str());
      ProgramSimulation simulation(part, *path, setup);
      QVERIFY(simulation.run({}));
      QVERIFY2(simulation.collisionCount() == 0 && simulation.part() == part, text.c_str());
      const auto again = threadsIn(simulation.takePasses());
      QVERIFY2(again, text.c_str());
      const double surface = isBore ? kHole : 10.0, beyond = isBore ? 10.0 : 0.0;
      for (double z = 25.0; z < 55.0; z += 0.37) {
        const double was = before->radius(pass.side, surface, beyond, z, 1.0);
        const double is = again->radius(pass.side, surface, beyond, z, 1.0);
        QVERIFY2(std::abs(was - is) < 1e-3, qPrintable(QString("%1: %2 %3").arg(z).arg(was).arg(is)));
      }
    }
  }

  // Two runs with the half-nut are one thread where the lead is a part of the lead screw's pitch.
  void halfNutCutsAThread() {
    LatheSetup setup = defaultLatheSetup(kThreadedBar);
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    LatheRun run(setup, shippedLatheTools(), TurnedProfile(kThreadedBar, 0.02),
                 LatheMachine::initialState(setup, kThreadedBar));
    using Kind = LatheCommand::Kind;
    const auto once = [&](std::initializer_list<LatheCommand> commands = {}) {
      return run.step(0.001, std::vector<LatheCommand>(commands));
    };
    const auto go = [&](double r, double z) {
      once({{Kind::MoveTip, LatheAxis::Carriage, r, z}});
      for (int i = 0; i < 20000 && (run.machine().tip() - ProfilePoint(r, z)).norm() > 1e-9; ++i) once();
      once({{Kind::Release}});
    };
    int slot = -1;
    for (std::size_t i = 0; i < setup.stations.size(); ++i)
      if (setup.stations[i].tool == "threading-60") slot = static_cast<int>(i);
    QVERIFY(slot >= 0);
    go(20.0, 70.0);
    once({{Kind::Tool, LatheAxis::Carriage, static_cast<double>(slot)}});
    once({{Kind::Spindle, LatheAxis::Carriage, 1.0}, {Kind::Speed, LatheAxis::Carriage, 200.0}});
    for (int i = 0; i < 3000; ++i) once();
    std::vector<TurningPass> passes;
    for (const double radius : {9.5, 9.0}) {
      go(20.0, 66.0);
      go(radius, 66.0);
      once({{Kind::HalfNut, LatheAxis::Carriage, -1.5}});
      TurningPass pass;
      for (int i = 0; i < 20000 && run.machine().tip().y() > 46.0; ++i) {
        const LatheStep step = once();
        QVERIFY(!step.isCrash && !step.isHeld);
        if (!step.thread) continue;
        if (pass.path.empty()) {
          pass.tool = step.tool;
          pass.noseRadius = step.tool->noseRadius;
          pass.thread = step.thread;
          pass.path.push_back(step.from);
        }
        QVERIFY(std::abs(std::remainder(step.thread->offset - pass.thread->offset, 1.5)) < 1e-9);
        pass.path.push_back(step.to);
      }
      once({{Kind::HalfNut}});
      go(20.0, run.machine().tip().y());
      QVERIFY(pass.path.size() > 100);
      passes.push_back(pass);
    }
    const auto threads = threadsIn(passes);
    QVERIFY(threads);
    QCOMPARE(threads->grooves().size(), std::size_t(1));
    QVERIFY(!threads->grooves().front().cut().isLeft);
    const auto reading = measureThread(run.profile(), *threads, TurningSide::Outside, {49.0, 59.0});
    QVERIFY(reading && std::abs(reading->pitch - 1.5) < 1e-4);
    QVERIFY2(std::abs(reading->minor - 18.0) < 6e-3, QByteArray::number(reading->minor));
  }
};

HANDWHEEL_TEST(ThreadProgramTest)
#include "ThreadProgramTest.moc"
