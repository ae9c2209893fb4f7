// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheRun.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

using ThreadDo = LatheCommand::Kind;

constexpr StockCylinder kThreadStock{40.0, 100.0, 0.0};
constexpr double kThreadTick = 0.001;  // s
constexpr double kPitch = 1.5, kRadius = 20.0;

// 2000 N for each mm² of the chip, whatever its shape.
class ChipLaw : public CuttingForceModel {
 public:
  CutForces at(const CutConditions& cut) const noexcept override { return {2000.0 * cut.depth * cut.feed, 0.0, 0.0}; }
  bool covers(const CutConditions&) const noexcept override { return true; }
};

// mm²: a groove of 60° that is this deep, mm, with its bottom rounded: the V with its corner at the middle of the
// flanks, without the area between that corner and the circle.
double sectionOfGroove(double depth, double nose) {
  const double root = std::sqrt(3.0);
  return (depth + nose) * (depth + nose) / root - nose * nose * (root - M_PI / 3.0);
}

// A law with a force across the work, too, so that the work yields to the tool.
class BendingLaw : public ChipLaw {
 public:
  CutForces at(const CutConditions& cut) const noexcept override {
    return {2000.0 * cut.depth * cut.feed, 0.0, 2000.0 * cut.depth * cut.feed};
  }
};

// A lathe with the threading tool in the post.
struct ThreadLathe {
  explicit ThreadLathe(double depthLimit = 0.0, std::shared_ptr<CuttingForceModel> law = std::make_shared<ChipLaw>()) {
    LatheSetup setup = defaultLatheSetup(kThreadStock);
    for (LatheSlot& slot : setup.stations) slot.position = slot.offset = {0.0, 0.0};
    setup.stations[0].tool = "threading-60";
    setup.depthLimit = depthLimit;
    LatheMaterial material;
    material.laws.assign(shippedLatheTools().size(), std::move(law));
    run.emplace(setup, shippedLatheTools(), TurnedProfile(kThreadStock, 0.05),
                LatheMachine::initialState(setup, kThreadStock), std::make_shared<const LatheMaterial>(material));
  }
  // Goes on as after a pass was written into the document: with the same part and slides, and no memory.
  void goOnAnew() {
    run =
        LatheRun(run->machine().setup(), shippedLatheTools(), run->profile(), run->machine().state(), run->material());
  }
  // Draws the tool straight out across the bed by 4 mm by the power traverse.
  bool isDrawnOutRapidly() {
    const double r = tip().x();
    once({{ThreadDo::Rapid, LatheAxis::Cross, 1.0}});
    pass(0.08);
    once({{ThreadDo::Rapid, LatheAxis::Cross, 0.0}});
    return tip().x() > r + 3.9 && run->collisions().empty();
  }
  LatheStep once(std::initializer_list<LatheCommand> commands = {}) {
    const LatheStep step = run->step(kThreadTick, std::vector<LatheCommand>(commands));
    removed += step.cut.volume;
    return step;
  }
  void pass(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kThreadTick)); ++i) once();
  }
  void go(double r, double z) {
    once({{ThreadDo::MoveTip, LatheAxis::Carriage, r, z}});
    for (int i = 0; i < 20000 && (tip() - ProfilePoint(r, z)).norm() > 1e-9; ++i) once();
    once({{ThreadDo::Release}});
  }
  void spin(double speed) {
    once({{ThreadDo::Spindle, LatheAxis::Carriage, speed > 0.0 ? 1.0 : 0.0}});
    if (speed > 0.0) once({{ThreadDo::Speed, LatheAxis::Carriage, speed}});
    pass(1.0);
  }
  // Follows the lead screw from before the end of the bar to a height; the tool stays in its groove.
  void threadTo(double depth, double z) {
    go(kRadius + 5.0, 104.0);
    go(kRadius - depth, 104.0);
    once({{ThreadDo::HalfNut, LatheAxis::Carriage, -kPitch}});
    for (int i = 0; i < 60'000 && tip().y() > z; ++i) once();
  }
  ProfilePoint tip() const { return run->machine().tip(); }
  double nose() const { return run->tool()->noseRadius; }
  bool isUncut() const { return run->profile() == TurnedProfile(kThreadStock, 0.05); }

  std::optional<LatheRun> run;
  double removed = 0.0;
};

}  // namespace

// Threads by the half-nut: the cut, its load, and the free moves of the tool.
class LatheThreadTest : public QObject {
  Q_OBJECT

 private slots:
  // The first pass removes all of its groove, the next ones only their additional depth; a repeated pass removes
  // nothing.
  void theChipIsWhatTheGrooveGrowsBy() {
    ThreadLathe lathe;
    lathe.spin(200.0);
    double before = 0.0;
    for (const double depth : {0.5, 0.8, 0.8}) {
      lathe.threadTo(depth, 85.0);
      const LatheLoad& load = lathe.run->load();
      const double section = sectionOfGroove(depth, lathe.nose()), chip = section - before;
      QVERIFY2(std::abs(load.forces.cutting - 2000.0 * chip) < 2000.0 * 0.05 * section,
               qPrintable(QString::number(load.forces.cutting)));
      if (chip > 0.0) {
        QVERIFY(load.isCutting);
        // The chip is as wide as both flanks are long, and so much thinner than the lead, which a feed would be.
        QVERIFY(load.cut.depth > depth && load.cut.depth < 2.0 * (depth + lathe.nose()) / std::cos(M_PI / 6.0));
        QVERIFY(load.cut.feed < 0.5 * depth && std::abs(load.cut.depth * load.cut.feed - chip) < 0.05 * section);
        QVERIFY(std::abs(load.torque - load.forces.cutting * (kRadius - 0.4 * depth) / 1000.0) < 0.02 * load.torque);
        QVERIFY(load.power > 0.0);
      }
      before = section;
      lathe.once({{ThreadDo::Turn, LatheAxis::Cross, 5.0}});
      lathe.pass(0.2);
      lathe.once({{ThreadDo::HalfNut}});
      lathe.pass(0.7);
    }
    QVERIFY(lathe.run->collisions().empty());
    QVERIFY(lathe.isUncut());  // the profile is the envelope
  }

  // Guldin's theorem: the section times the path of its centroid, on the helix.
  void theVolume() {
    ThreadLathe lathe;
    lathe.spin(200.0);
    lathe.threadTo(0.6, 90.0);
    const double before = lathe.removed;
    const double z = lathe.tip().y();
    lathe.pass(2.0);
    const double turns = (z - lathe.tip().y()) / kPitch, section = sectionOfGroove(0.6, lathe.nose());
    const double around = 2.0 * M_PI * (kRadius - 0.6 / 3.0);  // a third of the depth, of the sharp V
    QVERIFY2(std::abs((lathe.removed - before) / (section * around * turns) - 1.0) < 0.02,
             qPrintable(QString::number((lathe.removed - before) / (section * around * turns))));
  }

  // A spindle that has too little torque stalls in a thread as in any cut.
  void aThreadLoadsTheSpindle() {
    ThreadLathe lathe;
    LatheSetup weak = lathe.run->machine().setup();
    weak.spindle.power = 0.0;
    weak.spindle.torque = 5.0;  // N·m; a groove of 0.8 mm takes 17
    LatheMaterial material;
    material.laws.assign(shippedLatheTools().size(), std::make_shared<ChipLaw>());
    lathe.run.emplace(weak, shippedLatheTools(), TurnedProfile(kThreadStock, 0.05),
                      LatheMachine::initialState(weak, kThreadStock), std::make_shared<const LatheMaterial>(material));
    lathe.spin(200.0);
    lathe.threadTo(0.8, 85.0);
    QCOMPARE(lathe.run->collisions().size(), std::size_t{1});
    QVERIFY(lathe.run->collisions().front().cause == CrashCause::Overload);
  }

  // By hand as fast as a hand is, and by the power traverse: out of the groove nothing is pushed into the work.
  void theWayOutIsFree_data() {
    QTest::addColumn<bool>("isRapid");
    QTest::addColumn<bool>("isOpened");
    QTest::addColumn<bool>("isAtRest");
    for (int i = 0; i < 8; ++i) QTest::addRow("%d", i) << ((i & 1) != 0) << ((i & 2) != 0) << ((i & 4) != 0);
  }
  void theWayOutIsFree() {
    QFETCH(bool, isRapid);
    QFETCH(bool, isOpened);
    QFETCH(bool, isAtRest);
    ThreadLathe lathe;
    lathe.spin(200.0);
    lathe.threadTo(0.8, 85.0);
    if (isAtRest) lathe.spin(0.0);
    if (isOpened) lathe.once({{ThreadDo::HalfNut}});
    const double r = lathe.tip().x();
    if (isRapid)
      lathe.once({{ThreadDo::Rapid, LatheAxis::Cross, 1.0}});
    else
      lathe.once({{ThreadDo::Turn, LatheAxis::Cross, 4.0}});
    lathe.pass(0.08);
    if (isRapid) lathe.once({{ThreadDo::Rapid, LatheAxis::Cross, 0.0}});
    QVERIFY2(lathe.tip().x() > r + 3.9, qPrintable(QString::number(lathe.tip().x() - r)));
    QVERIFY(lathe.run->collisions().empty());
    // If the nut is opened, the work turns on against an edge that goes no further along it: a ring.
    QCOMPARE(lathe.isUncut(), !isOpened || isAtRest);
    if (isOpened && !isAtRest) {
      double least = kRadius;
      for (std::size_t i = 0; i < lathe.run->profile().size(); ++i)
        least = std::min(least, lathe.run->profile().radius(i));
      QVERIFY(std::abs(least - r) < 2e-3);
    }
  }

  // The nut is opened and the tool stays in the groove for as long as the turner likes: the pass is written meanwhile.
  // The work has turned on against the edge, so the groove ends in a ring, and drawing the tool out is no crash.
  void outOfTheGrooveLater() {
    for (const bool isBending : {false, true}) {
      std::shared_ptr<CuttingForceModel> law = std::make_shared<ChipLaw>();
      if (isBending) law = std::make_shared<BendingLaw>();
      ThreadLathe lathe(0.0, std::move(law));
      lathe.spin(200.0);
      lathe.threadTo(0.8, 85.0);
      QVERIFY(lathe.isUncut());
      lathe.once({{ThreadDo::HalfNut}});
      lathe.pass(1.0);
      const ProfilePoint tip = lathe.tip();
      double least = kRadius;
      for (std::size_t i = 0; i < lathe.run->profile().size(); ++i)
        least = std::min(least, lathe.run->profile().radius(i));
      QVERIFY2(std::abs(least - tip.x()) < 2e-3, qPrintable(QString::number(least - tip.x())));
      lathe.goOnAnew();
      QVERIFY(lathe.run->isClear());
      QVERIFY(lathe.isDrawnOutRapidly());
    }
  }

  // The work springs back against a tool whose feed has stopped. A turner draws it straight out, also rapidly, also
  // after a rest; along the work it is a crash.
  void outOfASprungCut() {
    for (const bool isAnew : {false, true}) {
      for (const LatheAxis axis : {LatheAxis::Cross, LatheAxis::Carriage}) {
        ThreadLathe lathe(0.0, std::make_shared<BendingLaw>());
        lathe.spin(200.0);
        lathe.go(kRadius + 5.0, 60.0);
        lathe.once({{ThreadDo::Feed, LatheAxis::Cross, -0.2}});
        for (int i = 0; i < 60'000 && lathe.tip().x() > kRadius - 2.0; ++i) lathe.once();
        lathe.once({{ThreadDo::Feed, LatheAxis::Cross, 0.0}});
        if (isAnew) lathe.goOnAnew();
        if (axis == LatheAxis::Cross) {
          QVERIFY(lathe.isDrawnOutRapidly());
          continue;
        }
        lathe.once({{ThreadDo::Rapid, axis, 1.0}});
        lathe.pass(0.08);
        QCOMPARE(lathe.run->collisions().size(), std::size_t{1});
        QVERIFY(lathe.run->collisions().front().cause == CrashCause::Rapid);
      }
    }
  }

  // Pushed deeper it is a crash as anywhere: at rest, and by the power traverse.
  void theWayInIsNot() {
    for (const bool isAtRest : {true, false}) {
      ThreadLathe lathe;
      lathe.spin(200.0);
      lathe.threadTo(0.8, 85.0);
      if (isAtRest) lathe.spin(0.0);
      QVERIFY(lathe.run->collisions().empty());
      if (isAtRest)
        lathe.once({{ThreadDo::Turn, LatheAxis::Cross, -0.5}});
      else
        lathe.once({{ThreadDo::Rapid, LatheAxis::Cross, -1.0}});
      lathe.pass(0.1);
      QCOMPARE(lathe.run->collisions().size(), std::size_t{1});
      QVERIFY(lathe.run->collisions().front().cause == (isAtRest ? CrashCause::SpindleAtRest : CrashCause::Rapid));
    }
  }

  // Back through its own groove with the nut closed, as it is done with leads that the lead screw does not know.
  void theSpindleIsReversedInTheGroove() {
    ThreadLathe lathe;
    lathe.spin(200.0);
    lathe.threadTo(0.8, 85.0);
    const double z = lathe.tip().y();
    lathe.once({{ThreadDo::Spindle, LatheAxis::Carriage, -1.0}});
    lathe.pass(3.0);
    QVERIFY(lathe.run->collisions().empty());
    QVERIFY(lathe.tip().y() > z + 5.0);
  }

  // For a thread it counts from the existing groove.
  void theDepthLimitIsThatOfAPass() {
    ThreadLathe lathe(0.5);
    lathe.spin(200.0);
    for (const double depth : {0.4, 0.8}) {
      lathe.threadTo(depth, 85.0);
      QVERIFY(lathe.tip().y() <= 85.0);
      lathe.once({{ThreadDo::Turn, LatheAxis::Cross, 5.0}});
      lathe.pass(0.2);
      lathe.once({{ThreadDo::HalfNut}});
    }
    lathe.go(kRadius + 5.0, 104.0);
    lathe.go(kRadius - 1.4, 104.0);
    lathe.once({{ThreadDo::HalfNut, LatheAxis::Carriage, -kPitch}});
    lathe.pass(5.0);
    QVERIFY(lathe.tip().y() > 98.0);  // held
    QVERIFY(lathe.run->collisions().empty());
  }

  // The groove that a pass has left in the document is the begin of the next run; a left-hand one, too.
  void theThreadsOfThePart() {
    for (const bool isLeft : {false, true}) {
      const auto tool = toolNamed(shippedLatheTools(), "threading-60");
      const TurnedProfile part(kThreadStock, 0.05);
      ThreadCut thread;
      thread.pitch = kPitch;
      thread.isLeft = isLeft;
      thread.offset = 0.3;
      TurningPass pass;
      pass.tool = tool;
      pass.noseRadius = tool->noseRadius;
      pass.thread = thread;
      pass.path = {{kRadius - 0.6, 90.0}, {kRadius - 0.6, 40.0}};
      pass.times = {0.0, 10.0};
      const ThreadsBeingCut threads(PartThreads::with(nullptr, pass));
      for (const double angle : {0.0, 2.0, 21.0, -7.5}) {
        const double z = 60.3 + thread.rise() * angle / (2.0 * M_PI);
        QVERIFY(threads.chipAt(part, *tool, {{kRadius - 0.6, z}, angle}).depth < 1e-9);
        const double deeper = threads.chipAt(part, *tool, {{kRadius - 0.75, z}, angle}).section;
        const double expected = sectionOfGroove(0.75, tool->noseRadius) - sectionOfGroove(0.6, tool->noseRadius);
        QVERIFY(std::abs(deeper / expected - 1.0) < 0.05);
        // Half a pitch beside it the bar is whole.
        const double beside = threads.chipAt(part, *tool, {{kRadius - 0.3, z + 0.5 * kPitch}, angle}).section;
        QVERIFY(std::abs(beside / sectionOfGroove(0.3, tool->noseRadius) - 1.0) < 0.05);
      }
    }
  }
};

HANDWHEEL_TEST(LatheThreadTest)
#include "LatheThreadTest.moc"
