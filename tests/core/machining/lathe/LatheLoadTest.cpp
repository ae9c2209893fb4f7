// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LoadedLathe.h"
#include "TestClass.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

class LatheLoadTest : public QObject {
  Q_OBJECT

 private slots:
  // Within its limits the spindle holds its speed.
  void aCutWithinTheLimits() {
    LoadedLathe lathe(setupWith(3.0, 100.0));
    lathe.turnDown(18.0, 0.2, 5.0);
    QCOMPARE(lathe.speed(), 600.0);
    QVERIFY(!lathe.run.load().isOverloaded);
    QVERIFY(!lathe.warningOf(Rule::Power) && !lathe.warningOf(Rule::Torque));
    QVERIFY(lathe.run.collisions().empty());
  }

  // If a cut needs more power, the spindle slows down to the speed at which the motor has it: P = T ω / η.
  void tooMuchPower() {
    LoadedLathe lathe(setupWith(1.0, 100.0));
    lathe.turnDown(17.0, 0.4, 8.0);  // 2400 N on an arm of 18.5 mm: 44 N·m, 2.8 kW at 600 r/min
    const double torque = 2000.0 * 3.0 * 0.4 * 0.0185, speed = 1000.0 * 0.8 / torque * 60.0 / (2.0 * M_PI);
    QVERIFY(speed > 100.0 && speed < 200.0);
    QVERIFY2(std::abs(lathe.speed() / speed - 1.0) < 0.1, qPrintable(QString::number(lathe.speed())));
    QVERIFY(lathe.run.collisions().empty());
    const LatheWarning* const warning = lathe.warningOf(Rule::Power);
    QVERIFY(warning && warning->tool == "right-roughing" && warning->time > 2.0);
    QVERIFY(std::abs(warning->warning.value / (torque * 600.0 * 2.0 * M_PI / 60.0 / 800.0) - 1.0) < 0.15);
    QCOMPARE(warning->warning.limit, 1.0);
    // It continues in the part, slower, and removes the same material.
    QVERIFY(std::abs(lathe.radiusAt(99.0) - 17.0) < 1e-3);
    // Out of the cut it comes back.
    lathe.send({Lever::Feed, LatheAxis::Carriage, 0.0});
    lathe.send({Lever::MoveTip, LatheAxis::Carriage, 30.0, 105.0});
    lathe.pass(3.0);
    QCOMPARE(lathe.speed(), 600.0);
  }

  // More torque than the spindle has at any speed: it stalls, which is a crash.
  void tooMuchTorque() {
    LoadedLathe lathe(setupWith(0.0, 20.0));
    lathe.turnDown(17.0, 0.4, 8.0);
    QCOMPARE(lathe.speed(), 0.0);
    QCOMPARE(lathe.run.machine().state().direction, 0);
    QCOMPARE(lathe.run.machine().state().feed, 0.0);
    QCOMPARE(lathe.run.collisions().size(), std::size_t{1});
    const LatheCollision& stall = lathe.run.collisions().front();
    QVERIFY(stall.cause == CrashCause::Overload && stall.tool == "right-roughing");
    QVERIFY(lathe.warningOf(Rule::Torque));
    QVERIFY(lathe.warningOf(Rule::Torque)->time < stall.time);
    // It does not fall within a tick: the excess slows it down.
    QVERIFY(stall.time > 2.3);
    // The tool can be moved out freely.
    lathe.send({Lever::MoveTip, LatheAxis::Carriage, 30.0, 105.0});
    lathe.pass(2.0);
    QCOMPARE(lathe.run.collisions().size(), std::size_t{1});
  }

  void noLimits() {
    LoadedLathe lathe(setupWith(0.0, 0.0));
    lathe.turnDown(12.0, 0.5, 5.0);
    QCOMPARE(lathe.speed(), 600.0);
    QVERIFY(!lathe.warningOf(Rule::Power) && !lathe.warningOf(Rule::Torque));
  }

  // A slender shaft is deflected by F x³ / 3EI, and is left thicker by that.
  void slenderWorkGivesWay() {
    const StockCylinder slender{12.0, 170.0, 0.0};
    LatheSetup setup = setupWith(0.0, 0.0);
    setup.chuck.grip = 20.0;
    LoadedLathe lathe(setup, 500.0, slender);
    lathe.turnDown(5.5, 0.2, 6.0);
    const double force = 500.0 * 0.5 * 0.2, cutHeight = 140.0, modulus = 210e3;
    const double moment = M_PI * std::pow(2.0 * 5.9, 4) / 64.0;  // a bar that is turned at its end only
    const double bent = force * std::pow(cutHeight - 20.0 + 6.0, 3) / (3.0 * modulus * moment);
    const double z = lathe.run.machine().tip().y();
    QVERIFY(z < 162.0 && z > 150.0);
    const double left = lathe.radiusAt(z + 2.0) - 5.5;
    QVERIFY2(left > 0.5 * bent && left < 2.0 * bent, qPrintable(QString("%1 %2").arg(left).arg(bent)));
    QVERIFY(lathe.warningOf(Rule::Slenderness) && lathe.warningOf(Rule::Deflection));
    QVERIFY(std::abs(lathe.warningOf(Rule::Slenderness)->warning.value - 150.0 / 12.0) < 0.5);
    QVERIFY(!lathe.warningOf(Rule::Power));
  }

  // A drill presses along the axis: a slender bar, of 12 mm and 150 mm out of the chuck, is not turned there, so that
  // nothing bends away from it nor swings.
  void drillingIsNoTurning() {
    const StockCylinder slender{12.0, 170.0, 0.0};
    LatheSetup setup = setupWith(0.0, 0.0);
    setup.tailstock.fitting = LatheFitting::Drill;
    setup.tailstock.drill = "drill-6";
    setup.tailstock.position = 175.0;
    LoadedLathe lathe(setup, 500.0, slender);
    lathe.send({Lever::MoveTip, LatheAxis::Carriage, 60.0, 210.0});
    lathe.pass(2.0);
    lathe.send({Lever::Spindle, LatheAxis::Carriage, 1.0});
    lathe.pass(1.0);
    lathe.send({Lever::Turn, LatheAxis::Quill, 20.0});
    lathe.pass(5.0);
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(std::abs(lathe.run.profile().inner(lathe.run.profile().size() - 100) - 3.0) < 1e-9);
    for (const Rule rule : {Rule::Slenderness, Rule::Deflection, Rule::Chatter}) QVERIFY(!lathe.warningOf(rule));
  }

  // A drill of 20 mm by the formula of Sandvik's handbook, at the feed that the hand gives it: kc = 1500 (f/2 · sin
  // 59°)^-0.22 for medium carbon steel, M = kc D² f / 8, Ff = kc D f sin 59° / 4, P = M 2 pi n, of which 80 % reach it.
  void aDrillHasTheForcesOfADrill() {
    LatheSetup setup = setupWith(0.0, 0.0);
    setup.tailstock.fitting = LatheFitting::Drill;
    setup.tailstock.drill = "drill-20";
    setup.tailstock.position = 103.0;
    const LatheTools tools = shippedLatheTools();
    const auto material = std::make_shared<const LatheMaterial>(
        latheMaterial(WorkMaterials::standard().called("medium-carbon-steel"), ForceLaw::Kienzle, tools));
    LoadedLathe lathe(setup);
    lathe.run = LatheRun(setup, tools, TurnedProfile(kLoadedShaft, 0.05),
                         LatheMachine::initialState(setup, kLoadedShaft), material);
    lathe.send({Lever::MoveTip, LatheAxis::Carriage, 60.0, 140.0});
    lathe.pass(2.0);
    lathe.send({Lever::Spindle, LatheAxis::Carriage, 1.0});
    lathe.pass(1.0);
    lathe.send({Lever::Turn, LatheAxis::Quill, 20.0});
    bool isSeen = false;
    for (int i = 0; i < 400 && !isSeen; ++i) {
      lathe.pass(0.05);
      isSeen = lathe.run.load().isCutting && lathe.run.profile().inner(lathe.run.profile().size() - 200) > 9.9;
    }
    QVERIFY(isSeen);
    const LatheLoad& load = lathe.run.load();
    const double feed = load.cut.feed, sine = std::sin(59.0 * M_PI / 180.0);
    const double specific = 1500.0 * std::pow(0.5 * feed * sine, -0.22), torque = specific * 0.4 * feed / 8.0;
    QVERIFY2(std::abs(load.torque / torque - 1.0) < 0.02, qPrintable(QString("%1 %2").arg(load.torque).arg(torque)));
    QVERIFY(std::abs(load.power / (torque * lathe.speed() * M_PI / 30.0 / 800.0) - 1.0) < 0.02);
    QVERIFY(std::abs(load.forces.feed / (specific * 20.0 * feed * sine / 4.0) - 1.0) < 0.02);
    QCOMPARE(load.forces.norm(), load.forces.feed);
  }

  // A shaft of one diameter is its own beam; a thick foot takes no part in the bending near the end.
  void beams() {
    const TurnedProfile bar(kLoadedShaft, 0.05);
    const SlenderWork whole = beamOf(bar, 20.0, 100.0);
    QVERIFY(std::abs(whole.diameter - 40.0) < 1e-9 && std::abs(whole.length - 80.0) < 1e-6);
    QCOMPARE(whole.position, whole.length);
    // Two lengths: δ = F/3E (a³ - b³)/I₁ + b³/I₂, with b the length of the thinner one at the end.
    std::vector<double> radii(2001);
    for (std::size_t i = 0; i < radii.size(); ++i) radii[i] = i <= 1200 ? 20.0 : 10.0;
    const TurnedProfile stepped = TurnedProfile::fromRadii(radii, 100.0);
    const SlenderWork beam = beamOf(stepped, 20.0, 100.0);
    const double a = 80.0, b = 40.0, e = 3.0 * 210e3;
    const auto moment = [](double r) { return M_PI * std::pow(r, 4) / 4.0; };
    const double expected = 100.0 / e * ((a * a * a - b * b * b) / moment(20.0) + b * b * b / moment(10.0));
    QVERIFY(std::abs(deflection(beam, 100.0) / expected - 1.0) < 0.01);
    const SlenderWork beside = beamOf(bar, 20.01, 10.0);  // between two samples
    QVERIFY(beside.position == 0.0 && beside.diameter == 40.0 && std::abs(beside.length - 79.99) < 1e-6);
  }

  // Material that is faced off to the centre and past it, or parted off, holds nothing: the work stays that of ⌀40,
  // which protrudes by 75 mm, about twice its diameter, and four times are recommended.
  void facingIsNotSlender_data() {
    QTest::addColumn<double>("z");
    QTest::newRow("between two samples") << 99.52;
    QTest::newRow("at a sample") << 99.5;
  }
  void facingIsNotSlender() {
    QFETCH(double, z);
    LatheSetup setup = setupWith(0.0, 0.0);
    setup.chuck.grip = 25.0;
    LoadedLathe lathe(setup, 500.0);
    lathe.send({Lever::Spindle, LatheAxis::Carriage, 1.0});
    lathe.send({Lever::MoveTip, LatheAxis::Carriage, 21.0, z});
    lathe.pass(3.0);
    lathe.send({Lever::Feed, LatheAxis::Cross, -0.2});
    lathe.pass(12.0);
    QVERIFY(lathe.run.machine().tip().x() < -0.5);
    QVERIFY(!lathe.run.profile().hasMaterial(lathe.run.profile().size() - 1));
    QVERIFY(lathe.run.collisions().empty());
    for (const Rule rule : {Rule::Slenderness, Rule::Deflection, Rule::Chatter}) QVERIFY(!lathe.warningOf(rule));
  }

  // Each breach of a rule is recorded once, at its worst.
  void warningsAreRecordedOnce() {
    LatheWarnings warnings;
    warnings.judge({{Rule::Power, 3.5, 3.0}}, 1.0, "a");
    warnings.judge({{Rule::Power, 4.0, 3.0}, {Rule::Rubbing, 0.005, 0.009}}, 1.1, "a");
    warnings.judge({{Rule::Power, 3.2, 3.0}, {Rule::Rubbing, 0.002, 0.009}}, 1.2, "a");
    QCOMPARE(warnings.all().size(), std::size_t{2});
    QCOMPARE(warnings.all()[0].warning.value, 4.0);
    QCOMPARE(warnings.all()[0].time, 1.0);
    QCOMPARE(warnings.all()[1].warning.value, 0.002);
    warnings.judge({{Rule::Power, 3.2, 3.0}}, 4.0, "a");  // later
    warnings.judge({{Rule::Power, 3.2, 3.0}}, 4.1, "b");  // another tool
    QCOMPARE(warnings.all().size(), std::size_t{4});
    for (int i = 0; i < 5000; ++i) warnings.judge({{Rule::Power, 5.0, 3.0}}, 10.0 * i, "a");
    QCOMPARE(warnings.all().size(), LatheWarnings::kMost);
  }

  // By name, by id, and the usual one for other words; a worn tool needs more.
  void materials() {
    const WorkMaterials& all = WorkMaterials::standard();
    QCOMPARE(all.called("brass").id, std::string("brass"));
    QCOMPARE(all.called("GREY CAST IRON, ferritic-pearlitic").id, std::string("grey-iron"));
    QCOMPARE(all.called("").id, std::string(kUsualMaterial));
    const LatheTools tools = shippedLatheTools();
    for (const ForceLaw law : {ForceLaw::Kosilova, ForceLaw::Kienzle, ForceLaw::Network}) {
      const LatheMaterial material = latheMaterial(all.called("brass"), law, tools);
      QCOMPARE(material.laws.size(), tools.size());
      for (std::size_t i = 0; i < tools.size(); ++i) QCOMPARE(material.lawOf(i) == nullptr, tools[i]->isAbrasive());
      QVERIFY(!material.lawOf(tools.size()));
      QVERIFY(material.modulus < 200e3);
    }
  }
};

HANDWHEEL_TEST(LatheLoadTest)
#include "LatheLoadTest.moc"
