// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../ProgramTrial.h"
#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/program/cycles/BoreCuts.h"
#include "machining/program/cycles/CycleProgram.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using test::ProgramTrial;

namespace {

// A cylinder of 36 mm by 50 mm with a bore from its upper end, whose wall and bottom these points are.
TargetProfile withBore(const std::vector<ProfilePoint>& wall) {
  std::vector<ProfileSegment> all = {{{0, -50}, {18, -50}, 0.0}, {{18, -50}, {18, 0}, 0.0}};
  for (const ProfilePoint& p : wall) all.push_back({all.back().to, p, 0.0});
  return TargetProfile::make(std::move(all)).value();
}

// A bush of 36 mm by 50 mm with a hole of this radius.
TargetProfile withHole(double radius) {
  return TargetProfile::make({{{18, -50}, {18, 0}, 0.0},
                              {{18, 0}, {radius, 0}, 0.0},
                              {{radius, 0}, {radius, -50}, 0.0},
                              {{radius, -50}, {18, -50}, 0.0}})
      .value();
}

// Returns the reason of an error, "word: reason".
std::string refusedBecause(const Error& error) {
  return error.arguments.at(1) + ": " + error.arguments.at(2);
}

}  // namespace

// Targets that cycles and drills cannot make, and why.
class CycleRefusalsTest : public QObject {
  Q_OBJECT

 private slots:
  // The point of a drill of 118° and 6 mm is 1.8 mm high: too long for a flat bore 1.5 mm deep.
  void theShallowestBore() {
    const LatheTools tools = shippedLatheTools();
    const TargetProfile shallow = withBore({{14, 0}, {14, -1.5}, {0, -1.5}});
    const auto refused = boreTools(shallow, 6.0, tools);
    QVERIFY(!refused);
    QCOMPARE(refusedBecause(refused.error()), std::string("drill: its point is longer than the bore is deep"));
    // There is no text of a program yet that a line and a column would be of.
    QVERIFY(refused.error().code == ProgramError::Unmakeable);
    QVERIFY(refused.error().position.kind == InputPosition::Kind::None);
    QCOMPARE(drillFor(shallow, tools), 0.0);
    QVERIFY(whyNoDrill(shallow, tools).has_value());
  }

  // The reason for a missing drill is given for the largest that goes into the bore; for a bore narrower than all, for
  // the smallest.
  void whyThereIsNoDrill() {
    const LatheTools tools = shippedLatheTools();
    const TargetProfile deep = withBore({{14, 0}, {14, -30}, {0, -30}}),
                        narrow = withBore({{2, 0}, {2, -30}, {0, -30}});
    QVERIFY(drillFor(deep, tools) > 0.0 && !whyNoDrill(deep, tools));
    const auto why = whyNoDrill(narrow, tools);
    QVERIFY(why && refusedBecause(*why) == "drill: it is too large for the bore");
    QVERIFY(why->arguments.at(3).find("at most") != std::string::npos);
  }

  // A bore of 10 mm through the part is what the drill of 10 mm leaves, with its point behind the part.
  void aDrillAloneMakesItsBore() {
    const LatheTools tools = shippedLatheTools();
    const TargetProfile target = withHole(5.0);
    QCOMPARE(drillFor(target, tools), 10.0);
    QVERIFY(!boreTools(target, 10.0, tools)->bar);
    const StockCylinder stock{40.0, 80.0, 0.0};
    const TurnedProfile bar(stock, 0.05);
    const CycleTask task{target, stock, bar, -80.0, 20.0, tools};
    const auto program = cycleProgramWithDrill(task, ProgramDialect::LinuxCnc, {});
    QVERIFY(program && program->drill == 10.0);
    ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, stock, 20.0, 0.4);
    setup.tools = program->tools;
    const auto path = runProgram(program->text, setup);
    QVERIFY(bool(path));
    ProgramSimulation simulation(bar, *path, setup);
    QVERIFY(simulation.run({}));
    for (const double z : {31.0, 55.0, 79.0})
      QCOMPARE(simulation.part().inner(static_cast<std::size_t>(std::lround(z / 0.05))), 5.0);
  }

  // If the largest drill that goes into the bore does not do, the next smaller one is taken: behind the part there are
  // 13 mm of bar, but a drill of 20 mm needs 3 mm for the boring bar, 0.5 mm, its radius and 0.5 mm: 14 mm. One of 16
  // mm needs 12 mm.
  void theNextSmallerDrill() {
    const LatheTools tools = shippedLatheTools();
    const TargetProfile target = withHole(14.0);
    QCOMPARE(drillsFor(target, tools), (std::vector<double>{20.0, 16.0, 12.0, 10.0}));
    const StockCylinder stock{40.0, 63.0, 0.0};
    const TurnedProfile bar(stock, 0.05);
    const CycleTask task{target, stock, bar, -63.0, 5.0, tools};
    CycleSettings settings;
    settings.drill = 20.0;
    QVERIFY(!cycleProgram(task, ProgramDialect::LinuxCnc, settings));
    const auto program = cycleProgramWithDrill(task, ProgramDialect::LinuxCnc, settings);
    QVERIFY(bool(program));
    QCOMPARE(program->drill, 16.0);
  }

  // A shaft needs no drill.
  void nothingToDrill() {
    const TargetProfile shaft = withBore({{0, 0}});
    const StockCylinder stock{40.0, 80.0, 0.0};
    const TurnedProfile bar(stock, 0.05);
    const auto program =
        cycleProgramWithDrill({shaft, stock, bar, -80.0, 20.0, shippedLatheTools()}, ProgramDialect::Fanuc, {});
    QVERIFY(program && program->drill == 0.0 && program->tools.size() == 2);
  }

  // A wall that goes back towards the end it is reached from.
  void undercuts() {
    const auto bored =
        boreTools(withBore({{10, 0}, {10, -20}, {14, -15}, {14, -30}, {0, -30}}), 16.0, shippedLatheTools());
    QVERIFY(!bored);
    QCOMPARE(refusedBecause(bored.error()), std::string("target: its bore has an undercut at z = -17.5"));
    const std::vector<ProfilePoint> points = {{18, -60}, {18, -40}, {10, -40}, {10, -20},
                                              {14, -25}, {16, -10}, {16, 0}};
    std::vector<ProfileSegment> lip;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) lip.push_back({points[i], points[i + 1], 0.0});
    const auto turned = roughAndFinish(TargetProfile::make(lip).value(), 20.0, {});
    QVERIFY(!turned);
    QCOMPARE(refusedBecause(turned.error()), std::string("target: it has an undercut at z = -22.5"));
  }
};

HANDWHEEL_TEST(CycleRefusalsTest)
#include "CycleRefusalsTest.moc"
