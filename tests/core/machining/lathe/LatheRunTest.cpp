// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheRun.h"

#include "LatheAtWork.h"
#include "TestClass.h"
#include "machining/lathe/LatheJson.h"

#include <rapidcheck.h>

#include <QtTest>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using CommandKind = Lathe::CommandKind;

constexpr StockCylinder kBlank = Lathe::kBlank;
constexpr double kStep = Lathe::kStep;

}  // namespace

class LatheRunTest : public QObject {
  Q_OBJECT

 private slots:
  // 2 mm off a length of 30 mm by the automatic feed: the diameter, the time, the volume, depth of cut and feed.
  void aCylinderByTheFeed() {
    Lathe lathe;
    lathe.spindle(600.0);
    lathe.go(18.0, 101.0);
    const double before = lathe.run.profile().volume();
    lathe.removed = 0.0;
    lathe.once({{CommandKind::Feed, LatheAxis::Carriage, -0.2}});
    lathe.pass(10.0);  // 100 turns: 20 mm
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(std::abs(lathe.run.machine().tip().y() - (101.0 - 20.0)) < 0.01);
    for (const double z : {83.0, 90.0, 99.0}) QVERIFY(std::abs(lathe.radiusAt(z) - 18.0) < 1e-3);
    QCOMPARE(lathe.radiusAt(80.0), 20.0);
    const double ring = M_PI * (400.0 - 324.0) * 19.0;
    QVERIFY(std::abs(lathe.removed / ring - 1.0) < 0.02);
    QVERIFY(std::abs((before - lathe.run.profile().volume()) / lathe.removed - 1.0) < 0.001);
    double depth = 0.0, feed = 0.0;
    for (int i = 0; i < 100; ++i) {
      const LatheStep step = lathe.once();
      depth += step.depthOfCut() / 100.0;
      feed = step.feed();
    }
    QVERIFY(std::abs(depth - 2.0) < 0.05);
    QVERIFY(std::abs(feed - 0.2) < 1e-6);
  }

  void everySpindleSpeed() {
    Lathe lathe;
    lathe.once({{CommandKind::Feed, LatheAxis::Carriage, -0.2}});
    lathe.pass(0.5);  // at rest nothing is fed
    QCOMPARE(lathe.run.machine().tip().y(), 120.0);
    LatheSetup fast = Lathe::exactSetup();
    fast.spindle.largestSpeed = 10'000.0;
    fast.spindle.acceleration = 10'000.0;
    Lathe quick(fast);
    quick.spindle(10'000.0);
    QVERIFY(std::abs(quick.run.machine().state().speed - 10'000.0) < 1e-9);
    // Constant surface speed: v = π d n, and the clamp towards the axis.
    quick.go(20.5, 120.0);
    quick.once({{CommandKind::SurfaceSpeed, LatheAxis::Carriage, 120.0, 3000.0}});
    quick.pass(1.5);
    QVERIFY(std::abs(quick.run.machine().state().speed - 120'000.0 / (M_PI * 41.0)) < 1.0);
    quick.go(0.0, 120.0);
    quick.pass(1.0);
    QVERIFY(std::abs(quick.run.machine().state().speed - 3000.0) < 1e-6);
    quick.once({{CommandKind::SurfaceSpeed, LatheAxis::Carriage, 120.0, 0.0}});
    quick.pass(2.0);
    QVERIFY(std::abs(quick.run.machine().state().speed - 10'000.0) < 1e-6);
  }

  // A wheel that turns back moves its slide only after the backlash.
  void dialsAndBacklash() {
    LatheSetup setup = Lathe::exactSetup();
    setup.dials[1].backlash = 0.3;
    Lathe lathe(setup);
    const double r = lathe.run.machine().tip().x();
    lathe.once({{CommandKind::Turn, LatheAxis::Cross, 1.0}});
    lathe.pass(0.1);
    QVERIFY(std::abs(lathe.run.machine().tip().x() - (r + 1.0 - 0.15)) < 1e-9);
    lathe.once({{CommandKind::Turn, LatheAxis::Cross, -0.2}});
    lathe.pass(0.1);
    QVERIFY(std::abs(lathe.run.machine().tip().x() - (r + 0.85)) < 1e-9);
    lathe.once({{CommandKind::Turn, LatheAxis::Cross, -0.2}});
    lathe.pass(0.1);
    QVERIFY(std::abs(lathe.run.machine().tip().x() - (r + 0.75)) < 1e-9);
  }

  // The compound slide at 30° makes a cone of 30°.
  void aTaperByTheCompoundSlide() {
    LatheSetup setup = Lathe::exactSetup();
    setup.compoundAngle = -30.0;  // r falls with z
    Lathe lathe(setup);
    lathe.spindle(800.0);
    lathe.go(17.0, 100.5);
    lathe.once({{CommandKind::Turn, LatheAxis::Compound, -4.0}});
    lathe.pass(30.0);
    QVERIFY(lathe.run.collisions().empty());
    const double slope = (lathe.radiusAt(98.0) - lathe.radiusAt(99.0)) / 1.0;
    QVERIFY(std::abs(slope - std::tan(30.0 * M_PI / 180.0)) < 0.02);
  }

  // Touching off as a student does it: the tool is not where the read-out says, until it was set.
  void touchingOff() {
    LatheSetup setup = defaultLatheSetup(kBlank);
    setup.stations[1].position = {1.37, -2.1};
    const std::array<double, kLatheAxes> slides{70.0, 25.0, 3.0, 0.0};
    const ProfilePoint tip = tipAt(setup, setup.stations[1], slides);
    QVERIFY((readoutAt(setup, setup.stations[1], slides) - tip).norm() > 1.0);
    setup.stations[1] = touchedOff(setup, setup.stations[1], slides, true, tip.x());
    setup.stations[1] = touchedOff(setup, setup.stations[1], slides, false, 0.0);
    QVERIFY(setup.stations[1].hasOffset[0] && setup.stations[1].hasOffset[1]);
    const std::array<double, kLatheAxes> elsewhere{60.0, 21.0, 1.0, 0.0};
    const ProfilePoint displacement = tipAt(setup, setup.stations[1], elsewhere) - tip;
    const ProfilePoint shown = readoutAt(setup, setup.stations[1], elsewhere);
    QVERIFY(std::abs(shown.x() - (tip.x() + displacement.x())) < 1e-12 &&
            std::abs(shown.y() - displacement.y()) < 1e-12);
    QVERIFY(touchedOff(setup, setup.stations[1], slides, true, std::nan("")) == setup.stations[1]);
  }

  void drillingFromTheTailstock() {
    LatheSetup setup = Lathe::exactSetup();
    setup.tailstock.fitting = LatheFitting::Drill;
    setup.tailstock.drill = "drill-10";
    setup.tailstock.position = 105.0;
    Lathe lathe(setup);
    lathe.go(60.0, 140.0);
    lathe.once({{CommandKind::Turn, LatheAxis::Quill, 3.0}});  // in front of the part
    lathe.pass(0.5);
    lathe.spindle(900.0);
    lathe.once({{CommandKind::Turn, LatheAxis::Quill, 30.0}});
    lathe.pass(10.0);
    QVERIFY2(lathe.run.collisions().empty(), lathe.run.collisions().empty() ? "" : "crash");
    QVERIFY(std::abs(lathe.run.machine().quillTip() - 72.0) < 1e-9);
    QVERIFY(std::abs(lathe.innerAt(90.0) - 5.0) < 1e-9);
    QCOMPARE(lathe.innerAt(71.9), 0.0);
  }

  void aCentreStopsAtThePart() {
    LatheSetup setup = Lathe::exactSetup();
    setup.tailstock.fitting = LatheFitting::Centre;
    setup.tailstock.position = 110.0;
    Lathe lathe(setup);
    lathe.go(90.0, 100.0);
    lathe.once({{CommandKind::Turn, LatheAxis::Quill, 50.0}});
    lathe.pass(2.0);
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(lathe.run.machine().quillTip() > 99.8 && lathe.run.machine().quillTip() < 100.2);
    QVERIFY(lathe.run.profile() == TurnedProfile(kBlank, 0.02));
  }

  void crashes_data() {
    QTest::addColumn<int>("cause");
    QTest::addColumn<int>("struck");
    QTest::addColumn<int>("moving");
    const auto row = [](const char* name, CrashCause cause, LathePart moving, LathePart struck) {
      QTest::newRow(name) << static_cast<int>(cause) << static_cast<int>(struck) << static_cast<int>(moving);
    };
    row("at rest", CrashCause::SpindleAtRest, LathePart::CuttingEdge, LathePart::Work);
    row("rapid", CrashCause::Rapid, LathePart::CuttingEdge, LathePart::Work);
    row("backwards", CrashCause::Reversed, LathePart::CuttingEdge, LathePart::Work);
    row("jaws", CrashCause::Contact, LathePart::CuttingEdge, LathePart::Jaws);
    row("chuck", CrashCause::Contact, LathePart::Slide, LathePart::Chuck);
    row("holder", CrashCause::Contact, LathePart::Holder, LathePart::Work);
    row("too deep", CrashCause::TooDeep, LathePart::CuttingEdge, LathePart::Work);
    row("tailstock", CrashCause::Contact, LathePart::CuttingEdge, LathePart::Fitting);
    row("indexed", CrashCause::Contact, LathePart::CuttingEdge, LathePart::Work);
  }

  // Each kind of crash: the spindle stops, the part is unchanged, the tool stays clear, and it is recorded once.
  void crashes() {
    QFETCH(int, cause);
    QFETCH(int, struck);
    QFETCH(int, moving);
    const QByteArray name = QTest::currentDataTag();
    LatheSetup setup = Lathe::exactSetup();
    if (name == "tailstock") setup.tailstock.fitting = LatheFitting::Centre, setup.tailstock.position = 108.0;
    if (name == "chuck") setup.chuck.diameter = 240.0;
    Lathe lathe(setup);
    const auto turnTo = [&](LatheAxis axis, double mm) {
      lathe.once({{CommandKind::Turn, axis, mm}});
      lathe.pass(4.0);
    };
    if (name != "at rest") lathe.spindle(600.0);
    if (name == "at rest") {
      lathe.go(19.0, 102.0);
      turnTo(LatheAxis::Carriage, -5.0);
    } else if (name == "rapid") {
      lathe.go(19.0, 102.0);
      lathe.once({{CommandKind::Rapid, LatheAxis::Carriage, -1.0}});
      lathe.pass(1.0);
    } else if (name == "backwards") {
      lathe.once({{CommandKind::Spindle, LatheAxis::Carriage, -1.0}});
      lathe.pass(2.0);
      lathe.go(19.0, 102.0);
      turnTo(LatheAxis::Carriage, -5.0);
    } else if (name == "jaws") {
      lathe.go(25.0, 50.0);
      turnTo(LatheAxis::Carriage, -45.0);
    } else if (name == "chuck") {
      // A tool that is longer than the jaws are high: the slide meets the body.
      lathe.go(41.0, 60.0);
      turnTo(LatheAxis::Carriage, -40.0);
    } else if (name == "holder") {
      lathe.once({{CommandKind::Tool, LatheAxis::Carriage, 7.0}});  // grooving, 8 mm deep
      lathe.go(22.0, 60.0);
      lathe.once({{CommandKind::Feed, LatheAxis::Cross, -0.1}});
      lathe.pass(12.0);
    } else if (name == "too deep") {
      lathe.go(5.0, 101.0);
      turnTo(LatheAxis::Carriage, -5.0);
    } else if (name == "tailstock") {
      lathe.go(20.0, 150.0);
      turnTo(LatheAxis::Cross, -25.0);
    } else if (name == "indexed") {
      LatheSetup longer = setup;
      longer.stations[1].position = {-5.0, -5.0};
      Lathe other(longer);
      other.spindle(600.0);
      other.go(20.5, 60.0);
      const TurnedProfile before = other.run.profile();
      other.once({{CommandKind::Tool, LatheAxis::Carriage, 1.0}});
      QCOMPARE(other.run.collisions().size(), std::size_t{1});
      QVERIFY(other.run.collisions().front().cause == CrashCause::Contact);
      QCOMPARE(other.run.machine().state().tool, 0u);
      QVERIFY(other.run.profile() == before);
      return;
    }
    QVERIFY(!lathe.run.collisions().empty());
    const LatheCollision& crash = lathe.run.collisions().front();
    QCOMPARE(static_cast<int>(crash.cause), cause);
    QCOMPARE(static_cast<int>(crash.struck), struck);
    QCOMPARE(static_cast<int>(crash.moving), moving);
    QCOMPARE(lathe.run.collisions().size(), std::size_t{1});
    QVERIFY(crash.time > 0.0 && crash.position.allFinite());
    QCOMPARE(lathe.run.machine().state().speed, 0.0);
    QCOMPARE(lathe.run.machine().state().feed, 0.0);
    if (name == "at rest" || name == "rapid" || name == "jaws" || name == "too deep")
      QVERIFY(lathe.run.profile() == TurnedProfile(kBlank, 0.02));
    // The tool can be moved back freely.
    const std::size_t count = lathe.run.collisions().size();
    lathe.once({{CommandKind::Turn, LatheAxis::Cross, 30.0}});
    const double r = lathe.run.machine().tip().x();
    lathe.pass(1.0);
    QCOMPARE(lathe.run.collisions().size(), count);
    QVERIFY(lathe.run.machine().tip().x() > r + 5.0);
  }

  // A tube of 40 mm with a bore of 24 mm on jaws that press outward: its outside is free up to the chuck, and the jaws
  // are in the bore up to z = 20.
  void jawsGripInside() {
    LatheSetup setup = Lathe::exactSetup();
    setup.chuck.gripsInside = true;
    setup.stations[1].tool = "boring-12";
    const TurnedProfile tube =
        TurnedProfile::fromRadii(std::vector<double>(5001, 20.0), std::vector<double>(5001, 12.0), 100.0);
    Lathe lathe(setup, tube);
    QCOMPARE(lathe.run.gripped(), 12.0);
    lathe.spindle(600.0);
    lathe.go(21.0, 10.0);
    lathe.once({{CommandKind::Feed, LatheAxis::Cross, -0.1}});
    lathe.pass(2.0);  // 20 turns: 2 mm
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(std::abs(lathe.radiusAt(10.8) - 19.0) < 0.03);  // the middle of the nose
    lathe.once({{CommandKind::Feed, LatheAxis::Cross, 0.0}});
    lathe.go(40.0, 10.0);
    lathe.go(40.0, 130.0);
    lathe.once({{CommandKind::Tool, LatheAxis::Carriage, 1.0}});
    lathe.go(11.0, 110.0);
    const TurnedProfile before = lathe.run.profile();
    lathe.once({{CommandKind::Turn, LatheAxis::Carriage, -100.0}});
    lathe.pass(4.0);
    QCOMPARE(lathe.run.collisions().size(), std::size_t{1});
    const LatheCollision& crash = lathe.run.collisions().front();
    QVERIFY(crash.cause == CrashCause::Contact && crash.moving == LathePart::CuttingEdge);
    QVERIFY(crash.struck == LathePart::Jaws);
    const double z = lathe.run.machine().tip().y();
    QVERIFY2(z > 20.0 - 1e-6 && z < 20.5, qPrintable(QString::number(z)));
    QVERIFY(lathe.run.profile() == before);
  }

  void theDepthLimitHolds() {
    LatheSetup setup = Lathe::exactSetup();
    setup.depthLimit = 1.0;
    Lathe lathe(setup);
    lathe.spindle(600.0);
    lathe.go(18.0, 101.0);
    lathe.once({{CommandKind::Feed, LatheAxis::Carriage, -0.2}});
    lathe.pass(10.0);
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(lathe.run.machine().tip().y() > 99.0);
    QCOMPARE(lathe.run.machine().state().feed, 0.0);
    QVERIFY(lathe.run.machine().state().speed > 0.0);
    lathe.go(19.2, 101.0);
    lathe.once({{CommandKind::Feed, LatheAxis::Carriage, -0.2}});
    lathe.pass(10.0);
    QVERIFY(std::abs(lathe.radiusAt(90.0) - 19.2) < 1e-3);
  }

  // A hand pushes through material no faster than it can.
  void aHandIsSlowInMaterial() {
    Lathe lathe;
    lathe.spindle(600.0);
    lathe.go(18.0, 101.0);
    lathe.once({{CommandKind::Turn, LatheAxis::Carriage, -50.0}});
    lathe.pass(1.0);  // 10 turns
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(std::abs(lathe.run.machine().tip().y() - (100.0 - 10.0 * 0.5)) < 0.8);
  }

  // Two wheels at once are no faster than one: the travel of the tool counts, and the marks agree.
  void twoHandsAreAsSlow() {
    Lathe lathe;
    lathe.spindle(600.0);
    lathe.go(19.0, 101.0);
    lathe.once({{CommandKind::Turn, LatheAxis::Carriage, -50.0}, {CommandKind::Turn, LatheAxis::Cross, -5.0}});
    lathe.pass(0.5);
    double fastest = 0.0;
    for (int i = 0; i < 300; ++i) {
      const LatheStep step = lathe.once();
      if (!step.cut.isEmpty()) fastest = std::max(fastest, (step.to - step.from).norm() / step.turns);
    }
    QVERIFY2(std::abs(fastest - 0.5) < 1e-9, qPrintable(QString::number(fastest)));
    QVERIFY(lathe.run.collisions().empty());
  }

  // Paper removes a limited depth, at any pressure.
  void abrasivesGiveWay() {
    LatheSetup setup = Lathe::exactSetup();
    setup.stations[0].tool = "paper-240";
    Lathe lathe(setup);
    lathe.spindle(600.0);
    lathe.go(20.5, 60.0);
    lathe.once({{CommandKind::Turn, LatheAxis::Cross, -2.0}});
    lathe.pass(0.2);
    const double before = lathe.radiusAt(60.0);
    lathe.pass(2.0);  // 20 turns
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(std::abs((before - lathe.radiusAt(60.0)) - 20.0 * 0.0003) < 2e-4);
  }

  // It is pressed no deeper than the limit, and goes on there; and where it is put to work already in the part it takes
  // no more than it can.
  void abrasivesKeepTheDepthLimit() {
    LatheSetup setup = Lathe::exactSetup();
    setup.stations[0].tool = "disk-100";
    setup.depthLimit = 0.1;
    Lathe lathe(setup);
    lathe.spindle(600.0);
    lathe.go(20.5, 60.0);
    lathe.once({{CommandKind::Turn, LatheAxis::Cross, -2.0}});
    lathe.pass(0.3);
    QVERIFY(lathe.run.collisions().empty());
    QVERIFY(lathe.deepest < 1e-3);
    const double before = lathe.radiusAt(60.0);
    QVERIFY2(lathe.run.machine().tip().x() > before - 0.1 - 1e-9,
             qPrintable(QString::number(lathe.run.machine().tip().x())));
    lathe.pass(5.0);
    QVERIFY(lathe.radiusAt(60.0) < before - 0.05);
    LatheState state = lathe.run.machine().state();
    LatheRun other(setup, shippedLatheTools(), TurnedProfile(kBlank, 0.02), state);  // the bar is whole again
    const LatheStep first =
        other.step(kStep, std::vector<LatheCommand>{{CommandKind::Turn, LatheAxis::Carriage, -0.1}});
    QVERIFY2(first.cut.depth <= 0.01 * first.turns + 1e-9, qPrintable(QString::number(first.cut.depth)));
  }

  // A lead that is a part of the lead screw's pitch finds its thread again; 0.1 mm more would be another thread.
  void theHalfNut() {
    Lathe lathe;
    lathe.spindle(200.0);
    const auto phase = [&] {
      const LatheState& state = lathe.run.machine().state();
      const double pitches = (lathe.run.machine().tip().y() + 1.5 * state.turns) / 1.5;
      return pitches - std::floor(pitches);
    };
    std::vector<double> phases;
    for (int i = 0; i < 3; ++i) {
      lathe.go(25.0, 105.0 + 0.37 * i);
      lathe.once({{CommandKind::HalfNut, LatheAxis::Carriage, -1.5}});
      lathe.pass(1.5);
      QVERIFY(lathe.run.machine().state().isNutClosed);
      const double z = lathe.run.machine().tip().y(), turns = lathe.run.machine().state().turns;
      lathe.pass(1.0);
      QVERIFY(std::abs((z - lathe.run.machine().tip().y()) - 1.5 * (lathe.run.machine().state().turns - turns)) < 1e-9);
      phases.push_back(phase());
      lathe.once({{CommandKind::HalfNut, LatheAxis::Carriage, 0.0}});
    }
    for (const double p : phases) QVERIFY(std::abs(std::remainder(p - phases.front(), 1.0)) < 1e-6);
  }

  void theSameCommandsGiveTheSameBytes() {
    QVERIFY(rc::check("two runs of random commands agree, and material only leaves", [] {
      Lathe a(Lathe::exactSetup(), 0.5), b(Lathe::exactSetup(), 0.5);
      double volume = a.run.profile().volume();
      for (int i = 0; i < 200; ++i) {
        std::vector<LatheCommand> commands;
        if (*rc::gen::inRange(0, 3) == 0) {
          LatheCommand command;
          command.kind = static_cast<CommandKind>(*rc::gen::inRange(0, 10));
          command.axis = static_cast<LatheAxis>(*rc::gen::inRange(0, 4));
          command.value = 0.5 * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-100, 100));
          command.other = 0.5 * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-10, 250));
          commands.push_back(command);
        }
        const LatheStep one = a.run.step(0.01, commands), two = b.run.step(0.01, commands);
        RC_ASSERT(one.to == two.to && one.cut.volume == two.cut.volume);
        RC_ASSERT(a.run.profile().volume() <= volume + 1e-6);
        volume = a.run.profile().volume();
        RC_ASSERT(a.run.machine().tip().allFinite());
      }
      RC_ASSERT(a.run.profile() == b.run.profile());
      RC_ASSERT(a.run.machine().state() == b.run.machine().state());
      RC_ASSERT(a.run.collisions() == b.run.collisions());
    }));
  }

  void nothingOfNoNumber() {
    Lathe lathe;
    const LatheState before = lathe.run.machine().state();
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (int kind = 0; kind < 10; ++kind) {
      for (const double bad : {nan, inf, -inf})
        lathe.once({{static_cast<CommandKind>(kind), LatheAxis::Cross, bad, 1.0},
                    {static_cast<CommandKind>(kind), LatheAxis::Cross, 1.0, bad}});
    }
    LatheState after = lathe.run.machine().state();
    after.time = before.time;
    QVERIFY(after == before);
    lathe.run.step(nan, {});
    lathe.run.step(0.0, {});
    QVERIFY(lathe.run.machine().tip().allFinite());
    lathe.once({{CommandKind::Tool, LatheAxis::Carriage, 1e9}, {CommandKind::Turn, LatheAxis::Quill, 1e300}});
    lathe.pass(0.1);
    QCOMPARE(lathe.run.machine().state().tool, 0u);
    QVERIFY(lathe.run.machine().tip().allFinite());
  }

  void jsonKeepsSetups() {
    LatheSetup setup = defaultLatheSetup(kBlank);
    setup.chuck.gripsInside = true;
    setup.tailstock = {LatheFitting::Drill, "drill-10", 123.0, 30.0, 50.0};
    setup.dials[2].backlash = 0.1;
    setup.stations[3] = touchedOff(setup, setup.stations[3], {1, 2, 3, 4}, false, 7.0);
    setup.depthLimit = 0.5;
    setup.showsDiameter = false;
    const Result<LatheSetup> back = latheSetupFrom(toJson(setup));
    QVERIFY(back.hasValue() && *back == setup);
    nlohmann::json bad = toJson(setup);
    bad["slots"] = nlohmann::json::array();
    QVERIFY(!latheSetupFrom(bad));
    bad = toJson(setup);
    bad["dials"]["cross"]["divisions"] = 0;
    QVERIFY(!latheSetupFrom(bad));
    bad = toJson(setup);
    bad["spindle"]["least_speed"] = 1e300;
    QVERIFY(!latheSetupFrom(bad));
    QVERIFY(!latheSetupFrom(nlohmann::json(3)) && !latheSetupFrom(nlohmann::json::object()));
  }
};

HANDWHEEL_TEST(LatheRunTest)
#include "LatheRunTest.moc"
