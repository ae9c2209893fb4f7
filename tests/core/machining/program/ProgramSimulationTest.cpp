// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramSimulation.h"

#include "TestClass.h"
#include "machining/force/WorkMaterials.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramInterpreter.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

using CollisionKind = ProgramCollision::Kind;

constexpr double kFineSpacing = 0.013;  // mm
constexpr StockCylinder kSimulatedBar{40.0, 100.0, 0.0};

struct Simulated {
  bool isRun = false;
  TurnedProfile part{kSimulatedBar, 1.0};
  std::vector<ProgramCollision> collisions;
  std::vector<TurningPass> passes;
  std::vector<ToolPath::Note> notes;
};

Simulated simulate(const std::string& text, const ProgramSetup& setup, const TurnedProfile& bar) {
  Simulated result;
  const Result<ToolPath> path = runProgram(text, setup);
  if (!path) qWarning("line %d: %s", int(path.error().position.value), path.error().arguments.at(2).c_str());
  if (!path) return result;
  ProgramSimulation simulation(bar, *path, setup);
  result.isRun = simulation.run({});
  result.part = simulation.part();
  result.collisions = simulation.collisions();
  result.notes = simulation.notes();
  result.passes = simulation.takePasses();
  return result;
}

Simulated simulate(const std::string& text, double nose = 0.0) {
  ProgramSetup setup;
  setup.standard = {nose, outsideOrientation(setup.dialect), {0, 0}};
  setup.reference = {120.0, 100.0};
  return simulate(text, setup, TurnedProfile(kSimulatedBar, kFineSpacing));
}

double removedBy(const Simulated& simulated) {
  return kSimulatedBar.volume() - simulated.part.volume();
}

}  // namespace

// The effects of programs on a bar of 40 mm, and their collisions. Z 0 is the right end.
class ProgramSimulationTest : public QObject {
  Q_OBJECT

 private slots:
  void collisions_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<double>("nose");
    QTest::addColumn<int>("kind");  // -1: none
    const QString begin = "G21 G18 G7\nF100 S500 M3\n", still = "G21 G18 G7\nF100 S500\n";
    const int rapid = int(CollisionKind::RapidInMaterial), atRest = int(CollisionKind::SpindleAtRest);
    for (const double nose : {0.0, 0.8}) {
      const auto add = [&](const char* name, const QString& program, int kind) {
        QTest::addRow("%s, nose %g", name, nose) << program << nose << kind;
      };
      add("straight in", begin + "G0 X50 Z-20\nX10\n", rapid);
      add("straight in between samples", begin + "G0 X50 Z-20.0071\nX10\n", rapid);
      add("slanting", begin + "G0 X50 Z-20\nX30 Z-25\n", rapid);
      add("through the end", begin + "G0 X20 Z5\nZ-5\n", rapid);
      add("beside", begin + "G0 X50 Z-20\nX42 Z-10\nX44 Z2\nX0\n", -1);
      // Off a shoulder that lies between two samples, and back along the cut.
      add("away from a shoulder", begin + "G0 X36 Z2\nG1 Z-20.0071\nG0 X50\nZ2\nX36\nG0 Z-19\n", -1);
      add("along a cone", begin + "G0 X30 Z2\nG1 Z0\nX38 Z-20\nG0 X30 Z0\n", -1);
      add("never turned", still + "G0 X44 Z2\nX36\nG1 Z-20\n", atRest);
      add("stopped", begin + "G0 X44 Z2\nX36\nM5\nG1 Z-20\n", atRest);
      add("plunge at rest", still + "G0 X44 Z-20\nG1 X30\n", atRest);
      add("without speed", "G21 G18 G7\nF100 M3\nG0 X44 Z2\nX36\nG1 Z-20\n", atRest);
      add("reversed", begin + "M4\nG0 X44 Z2\nX36\nG1 Z-20\n", -1);
      add("at rest in the air", still + "G0 X44 Z2\nG1 Z-20\n", -1);
      // Out of a thread, but not on through the part.
      const QString thread = begin + "G0 X44 Z5\nX38.5\nG33 Z-20 K1.5\n";
      add("out of a thread", thread + "G0 X44\n", -1);
      add("out of a thread along its flank", thread + "G0 X44 Z-19\n", -1);
      add("from a thread to the axis", thread + "G0 X0\n", rapid);
      add("from a thread slanting inward", thread + "G0 X30 Z-21\n", rapid);
    }
  }
  void collisions() {
    QFETCH(QString, program);
    QFETCH(double, nose);
    QFETCH(int, kind);
    const Simulated simulated = simulate(program.toStdString(), nose);
    QVERIFY(simulated.isRun);
    QCOMPARE(simulated.collisions.size(), std::size_t(kind < 0 ? 0 : 1));
    if (kind >= 0) QCOMPARE(int(simulated.collisions.front().kind), kind);
  }

  // The jaws hold 25 mm of 100: an outside tool may come down to Z -75. A drill goes on within the part.
  void theChuckHoldsTheLowerEnd_data() {
    QTest::addColumn<QString>("cuts");
    QTest::addColumn<bool>("isCollision");
    QTest::newRow("up to the jaws") << "G0 X44 Z2\nX38\nG1 Z-75\n" << false;
    QTest::newRow("into the jaws") << "G0 X44 Z2\nX38\nG1 Z-75.1\n" << true;
    QTest::newRow("beside the part") << "G0 X60 Z-95\n" << true;
    QTest::newRow("a thread into the jaws") << "G0 X44 Z5\nX38.5\nG33 Z-80 K1.5\nG0 X44\n" << true;
    QTest::newRow("a drill") << "G0 X0 Z2\nG1 Z-95\nG0 Z2\n" << false;
    QTest::newRow("a drill through") << "G0 X0 Z2\nG1 Z-101\nG0 Z2\n" << true;
  }
  void theChuckHoldsTheLowerEnd() {
    QFETCH(QString, cuts);
    QFETCH(bool, isCollision);
    for (const double nose : {0.0, 0.8}) {
      if (nose == 0.0 && cuts.contains("X0 ")) continue;  // a point drills nothing
      const ProgramSetup setup = usualSetup(ProgramDialect::LinuxCnc, kSimulatedBar, 25.0, nose);
      const Simulated simulated = simulate("G21 G18 G7\nF100 S500 M3\n" + cuts.toStdString(), setup,
                                           TurnedProfile(kSimulatedBar, kFineSpacing));
      QVERIFY(simulated.isRun);
      QCOMPARE(simulated.collisions.size(), std::size_t(isCollision ? 1 : 0));
      if (isCollision) QCOMPARE(int(simulated.collisions.front().kind), int(CollisionKind::Chuck));
    }
  }

  // In a tube of 40 and 30 mm a tool is drawn out of its thread towards the axis; outward it meets the wall.
  void outOfAThreadInABore() {
    TurnedProfile tube(kSimulatedBar, kFineSpacing);
    for (std::size_t i = 0; i < tube.size(); ++i) tube.limitInner(i, 15.0);
    ProgramSetup setup;
    setup.standard = {0.0, 3, {0, 0}};
    setup.reference = {120.0, 100.0};
    const std::string thread = "G21 G18 G7\nF100 S500 M3\nG0 X20 Z5\nX31.5\nG33 Z-20 K1.5\n";
    QVERIFY(simulate(thread + "G0 X20\n", setup, tube).collisions.empty());
    const Simulated outward = simulate(thread + "G0 X50\n", setup, tube);
    QCOMPARE(outward.collisions.size(), std::size_t{1});
    QCOMPARE(int(outward.collisions.front().kind), int(CollisionKind::RapidInMaterial));
  }

  // A tube of 40 and 30 mm: a point at r 10 is in the bore, one at r 25 around it, and neither takes the wall away.
  void aPointBesideTheWallLeavesIt() {
    TurnedProfile tube(kSimulatedBar, kFineSpacing);
    for (std::size_t i = 0; i < tube.size(); ++i) tube.limitInner(i, 15.0);
    TurnedProfile inside = tube, outside = tube;
    TurningPass pass;
    pass.noseRadius = 0.0;
    QVERIFY(cut(inside, pass, {10.0, 102.0}, {10.0, 80.0}).isEmpty());
    QVERIFY(inside == tube);
    pass.side = TurningSide::Bore;
    QVERIFY(cut(outside, pass, {25.0, 102.0}, {25.0, 80.0}).isEmpty());
    QVERIFY(outside == tube);
    // Within the wall it cuts as before.
    QVERIFY(!cut(outside, pass, {18.0, 102.0}, {18.0, 80.0}).isEmpty());
    QVERIFY(std::abs(outside.inner(outside.size() - 2) - 18.0) < 1e-12);
  }

  // A wall of 15 to 20 mm and paths through it: the depth is the distance to the nearer side.
  void depthOfAPoint() {
    TurnedProfile tube({40.0, 100.0, 0.0}, 0.5);
    for (std::size_t i = 0; i < tube.size(); ++i) tube.limitInner(i, 15.0);
    QCOMPARE(pointDepth(tube, {10.0, 50.0}, {10.0, 20.0}), 0.0);
    QCOMPARE(pointDepth(tube, {22.0, 50.0}, {22.0, 20.0}), 0.0);
    QCOMPARE(pointDepth(tube, {22.0, 50.0}, {10.0, 50.0}), 2.5);
    QCOMPARE(pointDepth(tube, {22.0, 50.1}, {19.0, 50.1}), 1.0);
    QCOMPARE(pointDepth(tube, {16.0, 90.0}, {16.0, 80.0}), 1.0);
    QCOMPARE(pointDepth(tube, {17.0, 110.0}, {17.0, 101.0}), 0.0);
    QCOMPARE(pointDepth(tube, {22.0, 100.0}, {10.0, 100.0}), 0.0);  // along its face
  }

  // A drill of 10 mm goes 20 mm deep: a cylinder of 15 mm above half a ball.
  void aDrillHasTheDiameterOfItsNose_data() {
    QTest::addColumn<int>("orientation");
    for (const int orientation : {2, 7}) QTest::addRow("Q%d", orientation) << orientation;
  }
  void aDrillHasTheDiameterOfItsNose() {
    QFETCH(int, orientation);
    ProgramSetup setup;
    setup.standard = {5.0, orientation, {0, 0}};
    setup.reference = {120.0, 100.0};
    const TurnedProfile bar(kSimulatedBar, kFineSpacing);
    const Simulated simulated = simulate("G21 G18 G7\nF100 S500 M3\nG0 X0 Z2\nG1 Z-20\nG0 Z2\nX50\n", setup, bar);
    QCOMPARE(simulated.collisions.size(), std::size_t{0});
    const double expected = M_PI * 25.0 * 15.0 + 2.0 / 3.0 * M_PI * 125.0;
    QVERIFY2(std::abs(removedBy(simulated) / expected - 1.0) < 2e-3, qPrintable(QString::number(removedBy(simulated))));
    QVERIFY(simulated.notes.empty());
  }

  // In LinuxCNC a number begins a subprogram, so that nothing moves, which is noted; in the other dialect, the program.
  void aNumberAtTheBeginning() {
    const std::string text = "O2004\nG21 G98 G0 X30 Z2\nG1 Z-5 F100\nM30\n";
    ProgramSetup setup;
    setup.reference = {120.0, 100.0};
    const Result<ToolPath> other = runProgram(text, setup);
    QVERIFY(other && other->moves.empty());
    QVERIFY(other->notes.size() == 1 && other->notes[0].line == 1);
    QVERIFY(other->notes[0].text.find("O2004") == 0 && other->notes[0].text.find("fanuc") != std::string::npos);
    setup.dialect = ProgramDialect::Fanuc;
    const Result<ToolPath> meant = runProgram(text, setup);
    QVERIFY(meant && meant->moves.size() >= 2 && meant->notes.empty());
  }

  // A drill with a known body leaves its point of 118° at the bottom: a cone of half of that about the axis. A bore
  // above it leaves the rest of the cone. The passes repeat it, bit for bit.
  void aDrillHasItsPoint() {
    const LatheTools shipped = shippedLatheTools();
    ProgramSetup setup;
    setup.tools[1] = programToolOf(toolNamed(shipped, "drill-10"), setup.dialect);
    setup.reference = {120.0, 100.0};
    const TurnedProfile bar(kSimulatedBar, kFineSpacing);
    const Simulated simulated =
        simulate("G21 G18 G7\nT1 M6\nF100 S500 M3\nG0 X0 Z2\nG1 Z-20\nG0 Z2\nX50\n", setup, bar);
    QVERIFY(simulated.isRun && simulated.collisions.empty());
    const double point = 5.0 / std::tan(59.0 * M_PI / 180.0);  // mm, its height
    const double expected = M_PI * 25.0 * (20.0 - point) + M_PI * 25.0 * point / 3.0;
    QVERIFY2(std::abs(removedBy(simulated) / expected - 1.0) < 2e-3, qPrintable(QString::number(removedBy(simulated))));
    const auto innerAt = [&](double z) {
      return simulated.part.inner(static_cast<std::size_t>(std::lround((100.0 + z) / simulated.part.spacing())));
    };
    QVERIFY(std::abs(innerAt(-10.0) - 5.0) < 1e-9);
    for (const double z : {-19.5, -18.5, -17.5})
      QVERIFY(std::abs(innerAt(z) - (z + 20.0) * std::tan(59.0 * M_PI / 180.0)) < 0.03);
    TurnedProfile again = bar;
    for (const TurningPass& pass : simulated.passes) cut(again, pass);
    QVERIFY(again == simulated.part);
  }

  void aPointDrillsNothingAndSaysSo() {
    const Simulated simulated = simulate("G21 G18 G7\nF100 S500 M3\nG0 X0 Z2\nG1 Z-20\nG0 Z2\n");
    QVERIFY(std::abs(removedBy(simulated)) < 1e-6);
    QVERIFY(!simulated.notes.empty());
    QCOMPARE(int(simulated.notes.front().line), 4);
  }

  // Facing leaves a pip below the nose; the return along the axis does not hit it.
  void facingIsNotDrilling() {
    const Simulated simulated = simulate("G21 G18 G7\nF100 S500 M3\nG0 X44 Z-0.5\nG1 X0\nG0 Z2\n", 0.8);
    QCOMPARE(simulated.collisions.size(), std::size_t{0});
    QVERIFY(removedBy(simulated) > 0.99 * M_PI * 400.0 * 0.5);
  }

  // A thread in two moves of one lead is one pass, whose spindle turns on; with another lead they are two.
  void threadsGoOn() {
    const std::string begin = "G21 G18 G7\nF60 S500 M3\nG0 X44 Z5\nX38.5\nG33 Z-20 K1.5\n";
    const auto threadsOf = [](const Simulated& simulated) {
      std::vector<TurningPass> threads;
      for (const TurningPass& pass : simulated.passes)
        if (pass.thread) threads.push_back(pass);
      return threads;
    };
    const auto one = threadsOf(simulate(begin + "G33 Z-30 K1.5\nG0 X44\n"));
    QCOMPARE(one.size(), std::size_t{1});
    QCOMPARE(one[0].path.size(), std::size_t{3});
    QVERIFY(std::abs(one[0].path.back().y() - 70.0) < 1e-9 && std::abs(one[0].thread->pitch - 1.5) < 1e-9);
    QVERIFY(std::abs(one[0].times.back() - 35.0 / 1.5 / 500.0 * 60.0) < 1e-6);
    QCOMPARE(threadsOf(simulate(begin + "G33 Z-30 K2\nG0 X44\n")).size(), std::size_t{2});
  }

  // The control holds the speed at the tip, so that all pieces of a face, whose speed changes all along, have the feed
  // of the program.
  void surfaceSpeedIsThatOfTheTip() {
    const Simulated face = simulate("G7 G95 F0.2 G96 S150 D6000 M3\nG0 X44 Z-0.5\nG1 X-1.6\nG0 Z3\nM2\n", 0.8);
    for (const TurningPass& pass : face.passes)
      for (std::size_t i = 1; i < pass.path.size(); ++i) {
        const double turns = (pass.times[i] - pass.times[i - 1]) * pass.speeds[i] / 60.0;
        QVERIFY(std::abs((pass.path[i] - pass.path[i - 1]).norm() / turns - 0.2) < 1e-9);
      }
    QVERIFY(!face.passes.empty());
  }

  // M3 is clockwise, seen from the spindle: the work comes down in front of the axis and up behind it, so an insert
  // that faces up cuts in front with M3 and behind with M4. A tool beyond the axis stands on the other side. A twist
  // drill cuts clockwise.
  void theSpindleTurnsToTheEdge_data() {
    QTest::addColumn<bool>("isInFront");
    QTest::addColumn<bool>("isInsertUp");
    QTest::addColumn<bool>("isM3");
    QTest::newRow("in front, up") << true << true << true;
    QTest::newRow("in front, down") << true << false << false;
    QTest::newRow("behind, up") << false << true << false;
    QTest::newRow("behind, down") << false << false << true;
  }
  void theSpindleTurnsToTheEdge() {
    QFETCH(bool, isInFront);
    QFETCH(bool, isInsertUp);
    QFETCH(bool, isM3);
    ProgramSetup setup;
    setup.reference = {120.0, 100.0};
    setup.standard = {0.4, outsideOrientation(setup.dialect), {0, 0}};
    setup.post = {isInFront, isInsertUp};
    setup.tools[2] = {5.0, 7, {0, 0}};
    setup.tools[3] = setup.standard;
    setup.tools[3].isTurnedOver = true;
    const auto notesOf = [&](const std::string& cuts, bool withM3) {
      const std::string text = std::string("G7 F100 S500 ") + (withM3 ? "M3\n" : "M4\n") + cuts + "M2\n";
      const Simulated simulated = simulate(text, setup, TurnedProfile(kSimulatedBar, kFineSpacing));
      if (!simulated.collisions.empty()) qWarning("collision in line %d", int(simulated.collisions.front().line));
      return simulated.collisions.empty() ? simulated.notes : std::vector<ToolPath::Note>(9);
    };
    const std::string cut = "G0 X36 Z2\nG1 Z-20\nG0 X44\nZ2\nX34\nG1 Z-20\nX44\nG0 Z2\n";
    const std::string beyond = "G0 X-32 Z2\nG1 Z-20\nX-44\nG0 Z2\n", drill = "M61 Q2\nG0 X0\nG1 Z-9\nG0 Z2\n";
    QCOMPARE(notesOf(cut, isM3).size(), std::size_t{0});
    const auto notes = notesOf(cut, !isM3);
    QCOMPARE(notes.size(), std::size_t{1});  // one, at the first feed
    QCOMPARE(notes.front().line, std::uint32_t{3});
    QVERIFY(notes.front().text.find(isM3 ? "cuts with M3" : "cuts with M4") != std::string::npos);
    QVERIFY(notes.front().text.find(isInFront ? "in front of the axis" : "behind the axis") != std::string::npos);
    QCOMPARE(notesOf(beyond, !isM3).size(), std::size_t{0});
    QCOMPARE(notesOf(beyond, isM3).size(), std::size_t{1});
    QCOMPARE(notesOf("M61 Q3\n" + cut, !isM3).size(), std::size_t{0});
    QCOMPARE(notesOf("M61 Q3\n" + cut, isM3).size(), std::size_t{1});
    QCOMPARE(notesOf(drill, true).size(), std::size_t{0});
    QCOMPARE(notesOf(drill, false).size(), std::size_t{1});
  }

  // A tool at negative X is the mirror image of one at positive X: cylinders, arcs, faces and the fillet of the nose.
  void beyondTheAxis_data() {
    QTest::addColumn<QString>("program");
    QTest::newRow("cylinder") << "G0 X~30 Z2\nG1 Z-10\nX~44\nG0 Z2\n";
    QTest::newRow("arc") << "G0 X~20 Z2\nG1 Z0\n@ X~40 Z-10 R10\nG1 X~44\nG0 Z2\n";
    QTest::newRow("face") << "G0 X~44 Z-1\nG1 X0\nG0 Z2\n";
    QTest::newRow("groove") << "G0 X~44 Z-20\nG1 X~30\nZ-22\nG0 X~44\n";
    QTest::newRow("thread") << "G0 X~44 Z5\nX~38\nG33 Z-20 K1.5\nG0 X~44\n";
    QTest::newRow("rapid") << "G0 X~44 Z-20\nG0 X~30 Z-22\n";
  }
  void beyondTheAxis() {
    QFETCH(QString, program);
    // The orientations 2 and 3 of LinuxCNC point to the chuck, inwards and outwards.
    for (const double nose : {0.0, 0.4}) {
      ProgramSetup setup;
      setup.reference = {120.0, 100.0};
      setup.standard = {nose, 2, {0, 0}};
      setup.tools[3] = {nose, 3, {0, 0}};
      const auto part = [&](const char* sign, const char* arc, const char* tool) {
        const QString text = "G7 F100 S500 M3\n" + QString(tool) + "G0 X" + sign + "80 Z5\n" +
                             QString(program).replace("~", sign).replace("@", arc) + "M2\n";
        return simulate(text.toStdString(), setup, TurnedProfile(kSimulatedBar, kFineSpacing));
      };
      const Simulated usual = part("", "G3", ""), same = part("-", "G2", ""), mirror = part("-", "G2", "M61 Q3\n");
      QVERIFY(usual.isRun && !usual.passes.empty());
      QVERIFY(same.part == usual.part && mirror.part == usual.part);
      QCOMPARE(same.collisions.size(), usual.collisions.size());
      QCOMPARE(same.passes.size(), usual.passes.size());
    }
  }

  // A face that goes over the axis by its nose is not a tool beyond it, and takes the middle away.
  void overTheAxis() {
    const Simulated face = simulate("G7 F100 S500 M3\nG0 X44 Z-1\nG1 X-1.6\nG0 Z5\nX44\n", 0.8);
    QVERIFY(face.isRun && face.collisions.empty());
    QVERIFY(face.notes.empty());
  }

  void timesOfAPassBeginWithIt() {
    const Simulated simulated =
        simulate("G21 G18 G7\nF60 S500 M3\nG0 X44 Z2\nX38\nG1 Z-20\nX44\nG0 Z2\nX36\nG1 Z-20\n");
    QVERIFY(simulated.passes.size() >= 2);
    for (const TurningPass& pass : simulated.passes) {
      QCOMPARE(pass.times.front(), 0.0);
      double distance = 0.0;
      for (std::size_t i = 1; i < pass.path.size(); ++i) distance += (pass.path[i] - pass.path[i - 1]).norm();
      QVERIFY(std::abs(pass.times.back() - distance) < 1e-6);  // at 1 mm/s
    }
  }
};

HANDWHEEL_TEST(ProgramSimulationTest)
#include "ProgramSimulationTest.moc"
