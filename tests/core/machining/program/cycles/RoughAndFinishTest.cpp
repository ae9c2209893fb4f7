// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/RoughAndFinish.h"

#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/program/ProgramWriter.h"
#include "machining/program/cycles/BoreCuts.h"
#include "machining/program/cycles/CycleProgram.h"
#include "machining/target/TargetDeviation.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

constexpr double kBarRadius = 20.0, kBarLength = 100.0, kFine = 0.013;  // mm
constexpr StockCylinder kRoughedBar{2.0 * kBarRadius, kBarLength, 0.0};

ProfileSegment arcOf(const ProfilePoint& a, const ProfilePoint& m, const ProfilePoint& b) {
  return *arcThrough(a, m, b);
}

TargetProfile targetOf(const QString& name) {
  std::vector<ProfileSegment> s;
  if (name == "shaft") {
    s = {{{18, -60}, {18, -40}},
         {{18, -40}, {15, -40}},
         {{15, -40}, {15, -20}},
         {{15, -20}, {10, -15}},
         {{10, -15}, {10, 0}}};
  } else if (name == "ball") {
    s = {arcOf({0, -30}, {15, -15}, {0, 0})};
  } else {  // a stem between two bells, as of a glass
    s = {{{18, -60}, {18, -55}},
         arcOf({18, -55}, {18 - 4 * (1 - std::sqrt(0.5)), -55 + 4 * std::sqrt(0.5)}, {14, -51}),
         {{14, -51}, {6, -45}},
         {{6, -45}, {6, -30}},
         arcOf({6, -30}, {11, -24}, {14, -20}),
         {{14, -20}, {16, 0}}};
  }
  return TargetProfile::make(s).value();
}

ProgramSetup setupFor(ProgramDialect dialect, double nose) {
  ProgramSetup setup;
  setup.dialect = dialect;
  setup.standard = {nose, outsideOrientation(dialect), {0, 0}};
  setup.reference = {120.0, 100.0};
  return setup;
}

}  // namespace

// Cycles for a target, and the programs that are written of them.
class RoughAndFinishTest : public QObject {
  Q_OBJECT

 private slots:
  // Nothing collides; no more than 0.001 mm is cut too deep; outside of inner corners no more than 0.002 mm is left.
  void makesTheTarget_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isFanuc");
    for (const char* const name : {"shaft", "ball", "glass"}) {
      QTest::addRow("%s, LinuxCNC", name) << QString(name) << false;
      QTest::addRow("%s, Fanuc", name) << QString(name) << true;
    }
  }
  void makesTheTarget() {
    QFETCH(QString, name);
    QFETCH(bool, isFanuc);
    const TargetProfile target = targetOf(name);
    const CycleSettings settings;
    const auto moves = roughAndFinish(target, kBarRadius, settings);
    QVERIFY(bool(moves));
    const ProgramDialect dialect = isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc;
    const ProgramSetup setup = setupFor(dialect, settings.nose);
    const auto path = runProgram(programText(*moves, dialect, "test"), setup);
    QVERIFY(bool(path));
    ProgramSimulation simulation(TurnedProfile({2.0 * kBarRadius, kBarLength, 0.0}, kFine), *path, setup);
    QVERIFY(simulation.run({}));
    QCOMPARE(simulation.collisionCount(), std::size_t{0});
    const double base = target.upperEnd() - kBarLength;
    const TargetDeviation deviation = deviationFrom(target, simulation.part(), base);
    std::size_t left = 0, all = 0;
    for (std::size_t i = 0; i < simulation.part().size(); ++i) {
      const double z = simulation.part().z(i) + base;
      if (z < target.lowerEnd() + 2 * kFine || z > target.upperEnd() - 2 * kFine) continue;
      QVERIFY2(deviation.outer[i] > -1e-3, qPrintable(QString("z %1: %2").arg(z).arg(deviation.outer[i])));
      QVERIFY(deviation.outer[i] < 0.2);  // (√2 - 1)·r in a square corner
      left += deviation.outer[i] > 0.002;
      ++all;
    }
    QVERIFY2(left * 50 < all, qPrintable(QString("%1 of %2").arg(left).arg(all)));
  }

  void refusesWhatCannotBeTurned() {
    CycleSettings settings;
    QVERIFY(!roughAndFinish(targetOf("shaft"), 17.0, settings));
    settings.nose = 0.8;  // a groove of 1 mm
    const auto groove = TargetProfile::make({{{15, -60}, {15, -40}},
                                             {{15, -40}, {10, -40}},
                                             {{10, -40}, {10, -39}},
                                             {{10, -39}, {15, -39}},
                                             {{15, -39}, {15, 0}}});
    QVERIFY(bool(groove) && !roughAndFinish(*groove, kBarRadius, settings));
    settings = {};
    settings.depth = 0.0;
    QVERIFY(!roughAndFinish(targetOf("shaft"), kBarRadius, settings));
  }

  // A bar as long as the target: a section as thick as the bar at its lower end stays in the chuck. Anything thinner
  // needs room for the nose (2 r), the allowance, and 0.01 mm beside the chuck.
  void chuckHoldsTheLowerEnd_data() {
    QTest::addColumn<double>("lowerRadius");
    QTest::addColumn<double>("room");
    QTest::addColumn<double>("grip");
    QTest::addColumn<bool>("isMade");
    for (const double grip : {0.0, 20.0}) {
      const auto row = [grip](const char* name, double lowerRadius, double room, bool isMade) {
        QTest::addRow("%s, held over %g mm", name, grip) << lowerRadius << room + grip << grip << isMade;
      };
      row("as thick as the bar", kBarRadius, 0.0, true);
      row("thinner", 18.0, 0.0, false);
      row("too little room", 18.0, 2 * 0.4 + 0.3, false);
      row("just room enough", 18.0, 2 * 0.4 + 0.3 + 0.02, true);
      row("room for a part of the overrun", 18.0, 3.0, true);
    }
    QTest::newRow("as thick as the bar in the jaws") << kBarRadius << 0.0 << 20.0 << true;
  }
  void chuckHoldsTheLowerEnd() {
    QFETCH(double, lowerRadius);
    QFETCH(double, room);
    QFETCH(double, grip);
    QFETCH(bool, isMade);
    const auto target = TargetProfile::make({{{lowerRadius, -100}, {lowerRadius, -70}},
                                             {{lowerRadius, -70}, {14, -70}},
                                             {{14, -70}, {14, -30}},
                                             {{14, -30}, {9, -30}},
                                             {{9, -30}, {9, 0}}});
    QVERIFY(bool(target));
    const StockCylinder stock{2.0 * kBarRadius, 100.0 + room, 0.0};
    const TurnedProfile bar(stock, 0.02);
    const CycleSettings settings;
    const CycleTask task{*target, stock, bar, -100.0 - room, grip};
    const auto program = cycleProgram(task, ProgramDialect::LinuxCnc, settings);
    QVERIFY2(bool(program) == isMade, program ? "" : program.error().arguments.front().c_str());
    if (!isMade) {
      const auto& words = program.error().arguments;
      QVERIFY(std::any_of(words.begin(), words.end(), [](const std::string& w) { return w.find("longer") != w.npos; }));
      return;
    }
    ProgramSetup setup = setupFor(ProgramDialect::LinuxCnc, settings.nose);
    setup.grip = grip;
    const auto path = runProgram(program->text, setup);
    QVERIFY(bool(path));
    ProgramSimulation simulation(bar, *path, setup);
    QVERIFY(simulation.run({}));
    QCOMPARE(simulation.collisionCount(), std::size_t{0});
    const TurnedProfile& part = simulation.part();
    const auto radiusAt = [&](double z) {  // z in the target's coordinates
      return part.radius(static_cast<std::size_t>(std::lround((z + 100.0 + room) / part.spacing())));
    };
    for (const auto& [z, r] : {std::pair(-15.0, 9.0), {-50.0, 14.0}, {-85.0, lowerRadius}})
      QVERIFY(std::abs(radiusAt(z) - r) < 1e-3);
  }

  // A stepped bore with a chamfer and a fillet, through a bush that is turned outside, too, by simulation with the
  // bodies of drill and bar: nothing is cut too deep, and but in inner corners nothing is left.
  void boresThrough_data() {
    QTest::addColumn<bool>("isFanuc");
    QTest::newRow("LinuxCNC") << false;
    QTest::newRow("Fanuc") << true;
  }
  void boresThrough() {
    QFETCH(bool, isFanuc);
    const ProgramDialect dialect = isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc;
    const auto target =
        TargetProfile::make({{{18, -50}, {18, 0}},
                             {{18, 0}, {15, 0}},
                             {{15, 0}, {14, -1}},
                             {{14, -1}, {14, -18}},
                             arcOf({14, -18}, {14 - 2 * (1 - std::sqrt(0.5)), -18 - 2 * std::sqrt(0.5)}, {12, -20}),
                             {{12, -20}, {12, -50}},
                             {{12, -50}, {18, -50}}});
    QVERIFY(bool(target) && target->isClosed());
    const LatheTools tools = shippedLatheTools();
    QCOMPARE(drillFor(*target, tools), 20.0);
    const StockCylinder stock{2.0 * kBarRadius, kBarLength, 0.0};
    const TurnedProfile bar(stock, kFine);
    const double base = -kBarLength;
    const LatheSetup lathe = defaultLatheSetup(stock);
    CycleSettings settings;
    settings.drill = 20.0;
    CycleTask task{*target, stock, bar, base, 20.0, tools, ProgramLathe{lathe.chuck, lathe.tailstock, nullptr}};
    const auto program = cycleProgram(task, dialect, settings);
    QVERIFY2(bool(program), program ? "" : program.error().arguments.front().c_str());
    QVERIFY(program->tools.at(3).body->id == "drill-20" && program->tools.at(4).body->id == "boring-12");
    ProgramSetup setup = usualSetup(dialect, stock, 20.0, settings.nose);
    setup.tools = program->tools;
    setup.lathe = task.lathe;
    const auto path = runProgram(program->text, setup);
    QVERIFY(bool(path));
    ProgramSimulation simulation(bar, *path, setup);
    QVERIFY(simulation.run({}));
    QCOMPARE(simulation.collisionCount(), std::size_t{0});
    const TargetDeviation deviation = deviationFrom(*target, simulation.part(), base);
    std::size_t left = 0, all = 0;
    for (std::size_t i = 0; i < simulation.part().size(); ++i) {
      const double z = simulation.part().z(i) + base;
      if (z < target->lowerEnd() + 2 * kFine || z > target->upperEnd() - 2 * kFine) continue;
      for (const double each : {deviation.inner[i], deviation.outer[i]}) {
        QVERIFY2(each > -1e-3 && each < 0.2, qPrintable(QString("z %1: %2").arg(z).arg(each)));
        left += each > 0.002;
        ++all;
      }
    }
    QVERIFY2(left * 50 < all, qPrintable(QString("%1 of %2").arg(left).arg(all)));
    // The bore goes on below the target, for parting off.
    QVERIFY(simulation.part().inner(static_cast<std::size_t>(std::lround(49.0 / kFine))) > 11.9);
  }

  // Blind bores by simulation with the bodies of the tools: the volume that is bored is that of the drawing, but for
  // the corner that the nose leaves, and nothing is cut too deep.
  void boresBlind_data() {
    QTest::addColumn<double>("wall");      // mm, radius
    QTest::addColumn<double>("point");     // mm, of the bottom below the end of the wall, on the axis
    QTest::addColumn<double>("expected");  // mm, diameter of the largest drill
    const double slope = std::tan(59.0 * M_PI / 180.0);
    QTest::newRow("flat") << 14.0 << 0.0 << 20.0;
    QTest::newRow("flat, a smaller drill") << 9.5 << 0.0 << 16.0;
    QTest::newRow("bored over the cone") << 14.0 << 14.0 / slope << 20.0;
    QTest::newRow("drilled alone") << 10.0 << 10.0 / slope << 20.0;
  }
  void boresBlind() {
    QFETCH(double, wall);
    QFETCH(double, point);
    QFETCH(double, expected);
    const auto target = TargetProfile::make({{{0, -50}, {18, -50}},
                                             {{18, -50}, {18, 0}},
                                             {{18, 0}, {wall, 0}},
                                             {{wall, 0}, {wall, -25}},
                                             {{wall, -25}, {0, -25 - point}}});
    QVERIFY(bool(target));
    const LatheTools tools = shippedLatheTools();
    QCOMPARE(drillFor(*target, tools), expected);
    const StockCylinder stock{2.0 * kBarRadius, kBarLength, 0.0};
    const TurnedProfile bar(stock, kFine);
    const double base = -kBarLength;
    const LatheSetup lathe = defaultLatheSetup(stock);
    CycleSettings settings;
    settings.drill = expected;
    CycleTask task{*target, stock, bar, base, 20.0, tools, ProgramLathe{lathe.chuck, lathe.tailstock, nullptr}};
    for (const ProgramDialect dialect : {ProgramDialect::LinuxCnc, ProgramDialect::Fanuc}) {
      const auto program = cycleProgram(task, dialect, settings);
      QVERIFY2(bool(program), program ? "" : program.error().arguments.front().c_str());
      ProgramSetup setup = usualSetup(dialect, stock, 20.0, settings.nose);
      setup.tools = program->tools;
      setup.lathe = task.lathe;
      const auto path = runProgram(program->text, setup);
      QVERIFY(bool(path));
      ProgramSimulation simulation(bar, *path, setup);
      QVERIFY(simulation.run({}));
      QCOMPARE(simulation.collisionCount(), std::size_t{0});
      double bored = 0.0, tooDeep = 0.0;
      const TurnedProfile& part = simulation.part();
      for (std::size_t i = 0; i < part.size(); ++i) {
        const double z = part.z(i) + base;
        if (z > -kFine) continue;  // the face itself
        bored += M_PI * part.inner(i) * part.inner(i) * part.spacing();
        const double drawn = z >= -25.0 ? wall : point > 0.0 ? wall * std::max(0.0, 1.0 + (z + 25.0) / point) : 0.0;
        const double steep = std::abs(z + 25.0) < kFine ? wall : point > 0.0 ? wall / point * kFine : 0.0;
        tooDeep = std::max(tooDeep, part.inner(i) - drawn - steep);
      }
      const double volume = M_PI * wall * wall * (25.0 + point / 3.0);
      const double slack = M_PI * wall * wall * 2.0 * kFine + 0.3 * 2.0 * M_PI * wall * 0.4 * 0.4;
      QVERIFY2(std::abs(bored - volume) < slack, qPrintable(QString("%1 of %2").arg(bored).arg(volume)));
      QVERIFY2(tooDeep < 5e-3, qPrintable(QString::number(tooDeep)));
    }
  }

  // A bowl of 14 mm whose bottom is a half ball, which no drill makes: the cycles leave it, the axis being 14 mm from
  // its wall, and say so. A shaft leaves the corners of the nose only, (√2 - 1) of 0.4 mm at most.
  void tellsWhatIsLeft() {
    const auto bowl =
        TargetProfile::make({{{0, -50}, {18, -50}},
                             {{18, -50}, {18, 0}},
                             {{18, 0}, {14, 0}},
                             {{14, 0}, {14, -20}},
                             arcOf({14, -20}, {14 * std::sqrt(0.5), -20 - 14 * std::sqrt(0.5)}, {0, -34})});
    QVERIFY(bool(bowl));
    const LatheTools tools = shippedLatheTools();
    QCOMPARE(drillFor(*bowl, tools), 0.0);
    const auto why = whyNoDrill(*bowl, tools);
    QVERIFY(why && why->arguments[2].find("neither flat nor the cone") != std::string::npos);
    const TurnedProfile bar(kRoughedBar, 0.02);
    const auto rest = [&](const TargetProfile& target) {
      const CycleTask task{target, kRoughedBar, bar, -kBarLength, 20.0, tools};
      const auto program = cycleProgram(task, ProgramDialect::LinuxCnc, {});
      return program ? program->rest : CycleRest{-1.0};
    };
    const CycleRest ofBowl = rest(*bowl);
    QVERIFY2(std::abs(ofBowl.height - 14.0) < 0.01, qPrintable(QString::number(ofBowl.height)));
    QVERIFY(ofBowl.isInBore && ofBowl.isConsiderable() && ofBowl.z <= 0.03 && ofBowl.z > -20.1);
    const CycleRest ofShaft = rest(targetOf("shaft"));
    QVERIFY2(ofShaft.height >= 0.0 && ofShaft.height < 0.4 * (std::sqrt(2.0) - 1.0) + 0.02,
             qPrintable(QString::number(ofShaft.height)));
    QVERIFY(!ofShaft.isConsiderable());
  }

  void refusesWhatCannotBeBored() {
    const LatheTools tools = shippedLatheTools();
    const auto tube = [](double radius) {
      return TargetProfile::make({{{18, -50}, {18, 0}},
                                  {{18, 0}, {radius, 0}},
                                  {{radius, 0}, {radius, -50}},
                                  {{radius, -50}, {18, -50}}})
          .value();
    };
    QVERIFY(boreTools(tube(12.0), 20.0, tools) && !boreTools(tube(12.0), 24.0, tools) &&
            !boreTools(tube(12.0), 19.0, tools));
    QVERIFY(!boreTools(tube(4.0), 6.0, tools));  // no bar is so thin
    QCOMPARE(drillFor(tube(4.0), tools), 0.0);
    // A bottom of 90°, and a bore that is open at the chuck only.
    const auto cup = [](double depthOnAxis) {
      return TargetProfile::make({{{0, -50}, {18, -50}},
                                  {{18, -50}, {18, 0}},
                                  {{18, 0}, {12, 0}},
                                  {{12, 0}, {12, -30}},
                                  {{12, -30}, {0, -depthOnAxis}}});
    };
    QVERIFY(boreTools(cup(30.0).value(), 20.0, tools) && !boreTools(cup(42.0).value(), 20.0, tools));
    const auto hat = TargetProfile::make({{{0, -20}, {12, -20}},
                                          {{12, -20}, {12, -50}},
                                          {{12, -50}, {18, -50}},
                                          {{18, -50}, {18, 0}},
                                          {{18, 0}, {0, 0}}});
    QVERIFY(bool(hat) && !boreTools(*hat, 20.0, tools) && drillFor(*hat, tools) == 0.0);
    const BoreTools of20 = boreTools(tube(12.0), 20.0, tools).value();
    CycleSettings settings;
    settings.drill = 20.0;
    QVERIFY(drillAndBore(tube(12.0), of20, settings, 30.0));
    const auto noRoom = drillAndBore(tube(12.0), of20, settings, 5.0);
    QVERIFY(!noRoom && noRoom.error().arguments.back().find("longer") != std::string::npos);
  }

  // Arcs, threads, dwells and both feeds are read as they were written.
  void writtenMovesAreReadBack_data() {
    QTest::addColumn<bool>("isFanuc");
    QTest::newRow("LinuxCNC") << false;
    QTest::newRow("Fanuc") << true;
  }
  void writtenMovesAreReadBack() {
    QFETCH(bool, isFanuc);
    const ProgramDialect dialect = isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc;
    const char* const program =
        "G21 G18 G8\nT3 M6\nG97 S400 M3\nG0 X25 Z4\nG94 F120\nG1 X20.1234 Z-3\nG2 X24 Z-6.8766 R3.8766\nG95 F0.15\nG3 "
        "X27 Z-9.8766 R3\nG4 P0.75\nG33 Z-20 K1.5\nG0 X40\nG96 D1800 S120\nG1 X5 Z-21\n";
    const auto before = runProgram(program, setupFor(ProgramDialect::LinuxCnc, 0.0));
    QVERIFY(bool(before));
    const auto after = runProgram(programText(before->moves, dialect, "a (b)"), setupFor(dialect, 0.0));
    QVERIFY(bool(after));
    QCOMPARE(after->moves.size(), before->moves.size());
    for (std::size_t i = 0; i < after->moves.size(); ++i) {
      const ToolMove &a = before->moves[i], &b = after->moves[i];
      QCOMPARE(int(a.kind), int(b.kind));
      QCOMPARE(int(a.turn), int(b.turn));
      QVERIFY((a.to - b.to).norm() < 1e-4);
      if (a.turn != 0) QVERIFY((a.centre - b.centre).norm() < 2e-4);
      QVERIFY(std::abs(a.time - b.time) < 1e-3 * (1.0 + a.time));
      QCOMPARE(a.tool, b.tool);
      QVERIFY(a.isSurfaceSpeed == b.isSurfaceSpeed && std::abs(a.spindle - b.spindle) < 1e-3);
    }
  }

  // A recorded pass, written and simulated, leaves the same part.
  void aRecordedPassIsRepeated() {
    TurningPass pass;
    pass.noseRadius = 1.0;
    for (int i = 0; i <= 400; ++i) {
      pass.path.emplace_back(18.0 + 1.5 * std::sin(0.02 * i), 90.0 - 0.2 * i);
      pass.times.push_back(0.05 * i);
    }
    TurnedProfile expected({2.0 * kBarRadius, kBarLength, 0.0}, 0.05);
    const TurnedProfile bar = expected;
    cut(expected, pass);
    const std::vector<TurningPass> passes{pass};
    const std::vector<ToolMove> moves = movesOf(passes, kRoughedBar, kBarLength, {});
    QVERIFY(moves.size() < 300);  // thinned
    const ProgramSetup setup = setupFor(ProgramDialect::Fanuc, 1.0);
    const auto path = runProgram(programText(moves, ProgramDialect::Fanuc, "pass"), setup);
    QVERIFY(bool(path));
    ProgramSimulation simulation(bar, *path, setup);
    QVERIFY(simulation.run({}));
    QCOMPARE(simulation.collisionCount(), std::size_t{0});
    for (std::size_t i = 0; i < bar.size(); ++i) {
      // At the begin and end of the pass the tool comes from above.
      if (std::abs(bar.z(i) - 90.0) < 1.1 || std::abs(bar.z(i) - 10.0) < 1.1) continue;
      QVERIFY(std::abs(simulation.part().radius(i) - expected.radius(i)) < 2e-3);
    }
  }

  // Passes of two tools of the lathe, whose paths are those of their tips: Ø36 to Z -30, then a groove of the blade's
  // width at Z -20. The program changes tools, and its tips go where those of the lathe went.
  void passesOfToolsAreRepeated() {
    const LatheTools shipped = shippedLatheTools();
    TurningPass turning, groove;
    turning.tool = toolNamed(shipped, "right-roughing");
    groove.tool = *std::find_if(shipped.begin(), shipped.end(),
                                [](const auto& tool) { return tool->kind == LatheToolKind::Parting; });
    QVERIFY(turning.tool && turning.tool->noseRadius > 0.1);
    turning.path = {{18.0, 102.0}, {18.0, 70.0}, {22.0, 70.0}};
    turning.times = {0.0, 16.0, 18.0};
    groove.path = {{22.0, 80.0}, {12.0, 80.0}, {22.0, 80.0}};
    groove.times = {0.0, 20.0, 40.0};
    const std::vector<TurningPass> passes{turning, groove, turning};
    const std::vector<PassTool> tools = toolsOf(passes);
    QCOMPARE(tools.size(), std::size_t{2});
    QCOMPARE(tools[0].noseRadius, turning.tool->noseRadius);
    for (const ProgramDialect dialect : {ProgramDialect::LinuxCnc, ProgramDialect::Fanuc}) {
      QVERIFY(tipDirection(dialect, tools[0].orientationIn(dialect)) == ProfilePoint(-1, -1));
      const std::vector<std::string> comments{descriptionOf(tools[0], dialect)};
      const std::string text = programText(movesOf(passes, kRoughedBar, kBarLength, {}), dialect, "two", comments);
      QVERIFY(text.find(turning.tool->designation) != std::string::npos);
      const auto path = runProgram(text, setupFor(dialect, 0.0));
      QVERIFY(bool(path));
      const auto tipGoes = [&](int tool, const ProfilePoint& a, const ProfilePoint& b) {
        return std::any_of(path->moves.begin(), path->moves.end(), [&](const ToolMove& m) {
          return m.kind == ToolMove::Kind::Feed && m.tool == tool && (m.from - a).norm() < 1e-4 &&
                 (m.to - b).norm() < 1e-4;
        });
      };
      QVERIFY(tipGoes(1, {18.0, 2.0}, {18.0, -30.0}) && tipGoes(1, {18.0, -30.0}, {22.0, -30.0}));
      QVERIFY(tipGoes(2, {22.0, -20.0}, {12.0, -20.0}));
    }
    // With the nose in the table the program leaves the cylinder that the lathe has left.
    ProgramSetup setup = setupFor(ProgramDialect::LinuxCnc, 0.0);
    setup.tools[1] = {tools[0].noseRadius, tools[0].orientationIn(setup.dialect), {0, 0}};
    const std::vector<TurningPass> first{turning};
    const TurnedProfile bar({2.0 * kBarRadius, kBarLength, 0.0}, 0.05);
    const auto path = runProgram(programText(movesOf(first, kRoughedBar, kBarLength, {}), setup.dialect, "one"), setup);
    QVERIFY(bool(path));
    ProgramSimulation simulation(bar, *path, setup);
    QVERIFY(simulation.run({}));
    TurnedProfile expected = bar;
    cut(expected, turning);
    for (std::size_t i = 0; i < bar.size(); ++i) {
      if (bar.z(i) < 72.0) continue;  // the back of the insert is not that of a round nose
      QVERIFY(std::abs(simulation.part().radius(i) - expected.radius(i)) < 1e-4);
    }
  }

  void someToolsAreNotForPrograms() {
    for (const auto& tool : shippedLatheTools()) {
      TurningPass pass;
      pass.tool = tool;
      pass.side = tool->side;
      const bool isByHand = tool->kind >= LatheToolKind::File;
      QVERIFY2((refusalToProgram(pass) == PassRefusal::Abrasive) == isByHand, tool->id.c_str());
      QVERIFY2(refusalToProgram(pass).has_value() == isByHand, tool->id.c_str());
    }
    TurningPass thread;
    thread.thread = ThreadCut();
    for (const TurningSide side : {TurningSide::Outside, TurningSide::Bore}) {
      thread.side = side;
      QVERIFY(!refusalToProgram(thread));
    }
    thread.thread->angle = 0.5;  // a trapezoid
    QVERIFY(refusalToProgram(thread) == PassRefusal::ThreadEdge);
  }

  // An ideal point: the volume between two cylinders and a cone, by formula.
  void aPointCutsItsPath() {
    const auto path = runProgram("G21 G8 F100 S100 M3\nG0 X22 Z1\nX15\nG1 Z-20\nX20 Z-40\nG0 X30\n",
                                 setupFor(ProgramDialect::LinuxCnc, 0.0));
    QVERIFY(bool(path));
    const TurnedProfile bar({40.0, 100.0, 0.0}, 0.05);
    const ProgramSetup setup = setupFor(ProgramDialect::LinuxCnc, 0.0);
    ProgramSimulation simulation(bar, *path, setup);
    QVERIFY(simulation.run({}));
    const double frustum = M_PI / 3.0 * 20.0 * (225.0 + 300.0 + 400.0);
    const double expected = M_PI * 400.0 * 40.0 - M_PI * 225.0 * 20.0 - frustum;
    QVERIFY(std::abs((bar.volume() - simulation.part().volume()) / expected - 1.0) < 1e-3);
    // The passes that it gives repeat it, though they cut a whole move at once.
    TurnedProfile again = bar;
    for (const TurningPass& pass : simulation.takePasses()) cut(again, pass);
    for (std::size_t i = 0; i < bar.size(); ++i)
      QVERIFY(std::abs(again.radius(i) - simulation.part().radius(i)) < 1e-9);
  }
};

HANDWHEEL_TEST(RoughAndFinishTest)
#include "RoughAndFinishTest.moc"
