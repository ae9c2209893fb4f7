// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LatheAtWork.h"
#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using HoldCommand = Lathe::CommandKind;

}  // namespace

// Cases in which the work stops a tool without a crash, and in which it does not.
class LatheHoldTest : public QObject {
  Q_OBJECT

 private slots:
  // The edge of 95° leans: in a cut of 3 mm its nose is 0.2 mm behind the front of the jaws when it meets
  // them further out. Drawn straight back it is no second crash, and nothing leaves the work, which is at rest.
  void drawnBackFromTheJaws() {
    LatheSetup setup = Lathe::exactSetup();
    setup.chuck.grip = 90.0;
    Lathe lathe(setup);
    lathe.spindle(600.0);
    lathe.go(17.0, 101.0);
    lathe.once({{HoldCommand::Feed, LatheAxis::Carriage, -0.4}});
    lathe.pass(5.0);
    QCOMPARE(lathe.run.collisions().size(), std::size_t{1});
    QVERIFY(lathe.run.collisions().front().struck == LathePart::Jaws);
    QCOMPARE(lathe.run.machine().state().speed, 0.0);
    const TurnedProfile before = lathe.run.profile();
    lathe.once({{HoldCommand::Turn, LatheAxis::Cross, 2.0}});
    lathe.pass(1.0);
    lathe.once({{HoldCommand::Turn, LatheAxis::Carriage, 0.1}});  // a little to the side, in front of the jaws
    lathe.pass(1.0);
    lathe.once({{HoldCommand::Turn, LatheAxis::Cross, 30.0}});
    lathe.pass(2.0);
    QCOMPARE(lathe.run.collisions().size(), std::size_t{1});
    QVERIFY(std::abs(lathe.run.machine().tip().x() - 49.0) < 1e-6);
    QVERIFY(lathe.run.profile() == before);
    // Pushed in again it crashes again.
    lathe.once({{HoldCommand::Turn, LatheAxis::Cross, -40.0}});
    lathe.pass(2.0);
    QCOMPARE(lathe.run.collisions().size(), std::size_t{2});
  }

  // A file is laid on: turned in as far as past the axis, it is pressed 60 N / 20 N/mm = 3 mm into the work at most,
  // which is said, and takes 0.002 mm in each turn.
  void aFileIsLaidOn_data() {
    QTest::addColumn<bool>("isByFeed");
    QTest::newRow("by hand") << false;
    QTest::newRow("by the feed") << true;
  }
  void aFileIsLaidOn() {
    QFETCH(bool, isByFeed);
    LatheSetup setup = Lathe::exactSetup();
    setup.stations[0].tool = "file-flat";
    Lathe lathe(setup);
    lathe.spindle(600.0);
    lathe.go(20.5, 60.0);
    const double turns = lathe.run.machine().state().turns;
    if (isByFeed)
      lathe.once({{HoldCommand::Feed, LatheAxis::Cross, -1.0}});
    else
      lathe.once({{HoldCommand::Turn, LatheAxis::Cross, -60.0}});
    lathe.pass(5.0);
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(lathe.run.machine().state().speed > 0.0);
    QCOMPARE(lathe.run.machine().state().feed, 0.0);
    QVERIFY(lathe.run.machine().tip().x() > 20.0 - 3.0 - 0.11);  // it follows the removed material
    const double most = 0.002 * (lathe.run.machine().state().turns - turns);
    QVERIFY(20.0 - lathe.radiusAt(60.0) > 0.5 * most && 20.0 - lathe.radiusAt(60.0) < most + 1e-6);
    QVERIFY2(lathe.deepest < 2.1e-5, qPrintable(QString::number(lathe.deepest)));  // depth of 0.01 turns
    const auto& warnings = lathe.run.warnings().all();
    QCOMPARE(warnings.size(), std::size_t{1});
    QVERIFY(warnings.front().warning.rule == CutWarning::Rule::Pressing && warnings.front().tool == "file-flat");
    QCOMPARE(warnings.front().warning.limit, 3.0);
    QVERIFY(warnings.front().warning.value > 3.0);
    // It slides along the work, and is drawn back freely.
    lathe.once({{HoldCommand::Turn, LatheAxis::Carriage, -5.0}});
    lathe.pass(2.0);
    QVERIFY(std::abs(lathe.run.machine().tip().y() - 55.0) < 1e-9);
    lathe.once({{HoldCommand::Turn, LatheAxis::Cross, 30.0}});
    lathe.pass(9.0);
    QVERIFY(lathe.run.machine().tip().x() > 45.0);
    QVERIFY(lathe.run.collisions().empty());
  }

  // Put past the axis, as by a part that undo has brought back, it takes no more either, and not the whole bar.
  void aFilePastTheAxis() {
    LatheSetup setup = Lathe::exactSetup();
    setup.stations[0].tool = "file-flat";
    LatheState state = LatheMachine::initialState(setup, Lathe::kBlank);
    state.wheels[0] = state.slides[0] = 60.0;
    state.wheels[1] = state.slides[1] = -2.0;
    state.direction = 1;
    state.speed = state.setSpeed = 600.0;
    LatheRun run(setup, shippedLatheTools(), TurnedProfile(Lathe::kBlank, 0.02), state);
    const LatheStep first =
        run.step(Lathe::kStep, std::vector<LatheCommand>{{HoldCommand::Turn, LatheAxis::Carriage, -0.1}});
    QVERIFY(first.turns > 0.0);
    QVERIFY2(first.cut.depth > 0.0 && first.cut.depth <= 0.002 * first.turns + 1e-9,
             qPrintable(QString::number(first.cut.depth)));
  }
};

HANDWHEEL_TEST(LatheHoldTest)
#include "LatheHoldTest.moc"
