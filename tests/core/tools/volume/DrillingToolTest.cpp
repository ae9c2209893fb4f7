// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/DrillingTool.h"

#include "TestClass.h"
#include "document/volume/VolumeKind.h"
#include "tools/ToolRunner.h"
#include "volume/VolumeSampler.h"
#include "volume/drilling/DrillReview.h"

#include <QtTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

// A ball of 20 mm and a drill on it, seen from above.
struct DrillFixture {
  VolumeKind kind;
  std::unique_ptr<Document> made = kind.make(DocumentKinds::blank(kind));
  VolumeDocument& document = static_cast<VolumeDocument&>(*made);
  MonotonicClock clock;
  Service simulation{"simulation"};
  ToolRunner runner;
  DrillingTool* tool = nullptr;

  explicit DrillFixture(const char* task = nullptr) {
    if (task) {
      const nlohmann::json exercise = {{"subject", "drilling"}, {"task", nlohmann::json::parse(task)}};
      document.assign({std::make_shared<const nlohmann::json>(exercise),
                       std::make_shared<const nlohmann::json>(nlohmann::json::object())},
                      false);
    }
    auto started = std::make_unique<DrillingTool>(document, SimulationServices{clock, simulation});
    tool = started.get();
    runner.start(std::move(started), document);
  }
  ToolReply event(PointerEvent::Kind what, double x, double y, Modifiers modifiers = {}) {
    PointerEvent event;
    event.kind = what;
    event.button = what == PointerEvent::Kind::Hover ? PointerButton::None : PointerButton::First;
    event.ray = {Vec3(x, y, 500.0), -Vec3::UnitZ()};
    event.modifiers = modifiers;
    return runner.pointer(event);
  }
  double setting(const char* id) const {
    for (const Property& property : tool->settings())
      if (property.id == id) return std::get<double>(property.value);
    return -1.0;
  }
  double depthAt(const Vec3& p) const { return VolumeSampler(document.volume()->volume).depthAt(p).depth; }
};

}  // namespace

class DrillingToolTest : public QObject {
  Q_OBJECT

 private slots:
  // Held, the drill goes in; released, the hole is one undo step with its figures.
  void aHole() {
    DrillFixture fixture;
    fixture.runner.setSetting("diameter", PropertyValue(4.0));
    fixture.runner.setSetting("feed", PropertyValue(20.0));
    const auto before = fixture.document.volume();
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > 30.0; }, 20'000));
    QCOMPARE(fixture.event(PointerEvent::Kind::Release, 0.0, 0.0), ToolReply::Used);
    QCOMPARE(fixture.document.history()->count(), 1);
    QVERIFY(fixture.document.history()->undoText().startsWith(QStringLiteral("Drill: −")));
    QVERIFY(fixture.depthAt({0.0, 0.0, 18.0}) < 0.0);
    QVERIFY(fixture.depthAt({3.0, 0.0, 18.0}) > 0.0);
    QVERIFY(fixture.setting("max_thrust") > 0.0 && fixture.setting("energy") > 0.0);
    fixture.document.history()->undo();
    QCOMPARE(fixture.document.volume(), before);
  }

  // The record of a hole reproduces the volume, with the same figures; undo removes both.
  void theHoleIsKept() {
    DrillFixture fixture;
    fixture.runner.setSetting("feed", PropertyValue(20.0));
    const auto before = fixture.document.volume();
    fixture.event(PointerEvent::Kind::Press, 1.0, 2.0);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > 30.0; }, 20'000));
    fixture.event(PointerEvent::Kind::Release, 1.0, 2.0);
    const auto after = fixture.document.volume();
    QCOMPARE(after->holes.size(), std::size_t{1});
    const auto review = reviewDrilling(before->volume, fixture.tool->hole()->plan.value(), after->holes);
    QVERIFY(review.has_value());
    QCOMPARE(countedMaterial(review->left), countedMaterial(after->volume));
    QCOMPARE(review->figures.thrust, fixture.tool->hole()->figures.thrust);
    QCOMPARE(review->figures.torque, fixture.tool->hole()->figures.torque);
    // Shown to four digits, so to half of the last one.
    for (const auto& [id, exact] :
         {std::pair("max_thrust", review->figures.thrust), std::pair("max_torque", review->figures.torque),
          std::pair("removed", fixture.tool->hole()->removed)}) {
      const double shown = fixture.setting(id);
      QVERIFY(std::abs(shown / exact - 1.0) <= 5.001e-4);
      QCOMPARE(shown, QString::number(exact, 'g', 4).toDouble());
    }
    fixture.document.history()->undo();
    QVERIFY(fixture.document.volume()->holes.empty());
  }

  // Held again within the hole, it goes on along it, not across its wall; and what is undone is not shown any more.
  void goesOnAlongItsHole() {
    DrillFixture fixture;
    fixture.runner.setSetting("head", PropertyValue(1.0));
    fixture.runner.setSetting("diameter", PropertyValue(6.0));
    fixture.runner.setSetting("feed", PropertyValue(20.0));
    fixture.event(PointerEvent::Kind::Press, 1.0, 2.0);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > 100.0; }, 20'000));
    fixture.event(PointerEvent::Kind::Release, 1.0, 2.0);
    const auto axisOf = [&](std::size_t hole) {
      const DrillRecord& record = *fixture.document.volume()->holes[hole];
      return record.poses[record.poses.size() - 1].direction();
    };
    const Vec3 axis = axisOf(0);
    const double thrust = fixture.setting("max_thrust");
    fixture.event(PointerEvent::Kind::Press, 2.5, 2.0);  // the ray meets the cone or the wall
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > 50.0; }, 20'000));
    fixture.event(PointerEvent::Kind::Release, 2.5, 2.0);
    QCOMPARE(fixture.document.volume()->holes.size(), std::size_t{2});
    QVERIFY((axisOf(1) - axis).norm() < 1e-6);
    QVERIFY(fixture.setting("max_thrust") < 1.2 * thrust);
    fixture.document.history()->undo();
    QCOMPARE(fixture.setting("max_thrust"), -1.0);
  }

  // In an exercise the drill is that of the task, and it says where the head must not be.
  void inAnExercise() {
    DrillFixture fixture(R"({"stock": "skull", "entry": [0, 0, 20], "direction": [0, 0, -1], "tolerance": 1,
                         "forbidden": [[0, 0, 0, 15]], "drill": "burr:4", "spindle_speed": 1500, "feed": 20,
                         "material": "porcine-bone"})");
    for (const Property& property : fixture.tool->settings()) QCOMPARE(property.editable, property.id == "feed");
    fixture.runner.setSetting("diameter", PropertyValue(9.0));
    QCOMPARE(fixture.tool->setup().tool.diameter, 4.0);
    QCOMPARE(fixture.tool->setup().material.id, std::string("porcine-bone"));
    QVERIFY(std::abs(fixture.tool->setup().spindle - 50.0 * M_PI) < 1e-9);
    const auto says = [&](const char* text) { return fixture.tool->actions().front().effect == text; };
    QVERIFY(says("drill across the surface"));
    fixture.event(PointerEvent::Kind::Press, 0.0, 0.0);
    QVERIFY(QTest::qWaitFor([&] { return says("in the forbidden region: release the button"); }, 20'000));
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    // 5 mm below the surface at 20 mm/s, known one step of the simulation later at most.
    const auto hole = fixture.tool->hole();
    for (std::size_t i = 0; i < hole->moments.size(); ++i) {
      const DrillMoment& moment = hole->moments[i];
      QVERIFY(std::abs(moment.forbidden - (moment.depth - 5.0)) < 1e-3);
      QVERIFY(moment.deviation < 1e-3);
    }
    // Beside the path by 3 mm.
    fixture.event(PointerEvent::Kind::Press, 3.0, 0.0);
    QVERIFY(QTest::qWaitFor([&] { return says("beside the planned path"); }, 20'000));
    fixture.runner.perform("revert");
  }

  // Undoing a hole in the forbidden region, or dropping it before it is done, begins another try; the failed one stays
  // known. A continued hole and a redone one belong to the same try.
  void triesOfAnExercise() {
    DrillFixture fixture(R"({"stock": "skull", "entry": [0, 0, 20], "direction": [0, 0, -1], "tolerance": 1,
                         "forbidden": [[0, 0, 0, 15]], "drill": "ball:4", "spindle_speed": 1500, "feed": 20,
                         "material": "porcine-bone"})");
    const auto drillUntil = [&](double removed) {
      fixture.event(PointerEvent::Kind::Press, 0.0, 0.0);
      return QTest::qWaitFor([&] { return fixture.setting("removed") > removed; }, 20'000);
    };
    const auto state = [&] {
      const auto work = std::static_pointer_cast<const VolumeSnapshot>(fixture.document.snapshot());
      return triesOf(work->tried.get(), work->holes);
    };
    // Asked twice, the document gives the same value: with a hole it needs no copy for what was tried.
    const auto isSettled = [&] { return fixture.document.snapshot() == fixture.document.volume(); };
    QVERIFY(isSettled());
    // A ball of 4 mm has removed 5 mm³ about 1 mm deep; the region begins 5 mm deep, seconds later.
    fixture.runner.setSetting("feed", PropertyValue(1.0));
    QCOMPARE(fixture.setting("tries"), 0.0);
    QVERIFY(drillUntil(5.0));
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QVERIFY(isSettled());
    QCOMPARE(state().count, 1u);
    QVERIFY(state().failed.empty());
    fixture.runner.setSetting("feed", PropertyValue(20.0));
    fixture.event(PointerEvent::Kind::Press, 0.0, 0.0);
    const auto isIn = [&] {
      const auto hole = fixture.tool->hole();
      return hole && hole->figures.forbidden > 0.0;
    };
    QVERIFY(QTest::qWaitFor(isIn, 20'000));
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    const double entered = fixture.tool->hole()->figures.forbidden;
    QCOMPARE(state().count, 1u);
    QVERIFY(state().failed.empty());  // it is there to be marked
    fixture.document.history()->undo();
    QCOMPARE(state().failed.size(), std::size_t{1});
    QCOMPARE(state().failed[0].number, 1u);
    QCOMPARE(state().failed[0].forbidden, entered);
    QVERIFY(!isSettled());  // the volume from before that hole knows nothing of it
    fixture.document.history()->redo();
    QVERIFY(state().failed.empty());
    fixture.document.history()->undo();
    fixture.runner.setSetting("feed", PropertyValue(1.0));
    QVERIFY(drillUntil(5.0));
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(state().count, 2u);
    QCOMPARE(fixture.setting("tries"), 2.0);
    // Dropped while it is drilled.
    fixture.runner.setSetting("feed", PropertyValue(20.0));
    fixture.event(PointerEvent::Kind::Press, 0.0, 0.0);
    QVERIFY(QTest::qWaitFor(isIn, 20'000));
    fixture.runner.perform("revert");
    QCOMPARE(state().count, 2u);
    QCOMPARE(state().failed.size(), std::size_t{2});
    // Work that is handed in during drilling includes the present hole.
    fixture.runner.setSetting("feed", PropertyValue(1.0));
    QVERIFY(drillUntil(5.0));
    const std::size_t holes = fixture.document.volume()->holes.size();
    fixture.document.settle();
    QCOMPARE(fixture.document.volume()->holes.size(), holes + 1);
    QCOMPARE(state().count, 3u);
  }

  // Tries are counted in exercises alone.
  void noTriesOutsideOfExercises() {
    DrillFixture fixture;
    fixture.runner.setSetting("feed", PropertyValue(20.0));
    fixture.event(PointerEvent::Kind::Press, 0.0, 0.0);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > 5.0; }, 20'000));
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QVERIFY(!fixture.document.tried());
    QCOMPARE(fixture.setting("tries"), -1.0);
  }

  // A saw stands upright on the surface and goes straight in: the slot is as wide as the saw. It has a width that
  // others have not, never more than its radius.
  void aSaw() {
    DrillFixture fixture;
    QCOMPARE(fixture.setting("width"), -1.0);
    fixture.runner.setSetting("head", PropertyValue(3.0));
    QVERIFY(fixture.tool->setup().tool.shape == DrillShape::Saw);
    fixture.runner.setSetting("width", PropertyValue(100.0));
    QCOMPARE(fixture.setting("width"), fixture.tool->setup().tool.radius());
    fixture.runner.setSetting("diameter", PropertyValue(16.0));
    QCOMPARE(fixture.setting("width"), 8.0);
    fixture.runner.setSetting("width", PropertyValue(2.0));
    fixture.runner.setSetting("feed", PropertyValue(20.0));
    fixture.event(PointerEvent::Kind::Press, 0.0, 0.0);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > 30.0; }, 20'000));
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    // From above it cuts across x, along y.
    QVERIFY(fixture.depthAt({0.0, 0.0, 19.0}) < 0.0 && fixture.depthAt({0.0, 2.5, 19.3}) < 0.0);
    QVERIFY(fixture.depthAt({1.6, 0.0, 19.0}) > 0.0 && fixture.depthAt({-1.6, 0.0, 19.0}) > 0.0);
    const auto hole = fixture.document.volume()->holes.front();
    QVERIFY(hole->setup.tool.shape == DrillShape::Saw && hole->setup.tool.width == 2.0);
    // A drill beside its slot begins on the surface, and goes across it.
    fixture.runner.setSetting("head", PropertyValue(0.0));
    fixture.runner.setSetting("diameter", PropertyValue(4.0));
    fixture.event(PointerEvent::Kind::Press, 3.0, 0.0);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > 5.0; }, 20'000));
    fixture.event(PointerEvent::Kind::Release, 3.0, 0.0);
    const auto& beside = fixture.document.volume()->holes.back()->poses;
    QVERIFY(beside[0].direction().z() > 0.9 && beside[0].position().z() > 15.0);
    QVERIFY(std::abs(beside[0].position().x() - beside[beside.size() - 1].position().x()) < 1.0);
  }

  // A key holds the feed and lets it go on; there is none to hold before. Pecks are a setting.
  void theFeedIsHeld() {
    DrillFixture fixture;
    fixture.runner.setSetting("feed", PropertyValue(20.0));
    fixture.runner.setSetting("peck", PropertyValue(2.0));
    QCOMPARE(fixture.setting("peck"), 2.0);
    QCOMPARE(fixture.runner.perform("hold"), ToolReply::Ignored);
    fixture.event(PointerEvent::Kind::Press, 0.0, 0.0);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > 5.0; }, 20'000));
    QCOMPARE(fixture.runner.perform("hold"), ToolReply::Used);
    QCOMPARE(std::string(fixture.tool->actions().front().effect), std::string("the feed is held"));
    const std::size_t held = fixture.tool->hole()->moments.size();
    QVERIFY(QTest::qWaitFor([&] { return fixture.tool->hole()->moments.size() > held + 6; }, 20'000));
    const auto now = fixture.tool->hole();
    QCOMPARE(now->moments[now->moments.size() - 1].depth, now->moments[now->moments.size() - 4].depth);
    QCOMPARE(fixture.runner.perform("hold"), ToolReply::Used);
    QVERIFY(QTest::qWaitFor([&] { return fixture.setting("removed") > now->removed; }, 20'000));
    fixture.event(PointerEvent::Kind::Release, 0.0, 0.0);
    QCOMPARE(fixture.document.history()->count(), 1);
  }

  // Beside the part the camera has the mouse; what is discarded leaves nothing.
  void nothingIsDone() {
    DrillFixture fixture;
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 30.0, 0.0), ToolReply::Ignored);
    QCOMPARE(fixture.event(PointerEvent::Kind::Press, 0.0, 0.0), ToolReply::Used);
    QVERIFY(fixture.tool->isLive());
    QCOMPARE(fixture.runner.perform("revert"), ToolReply::Used);
    QVERIFY(!fixture.tool->isLive());
    QCOMPARE(fixture.document.history()->count(), 0);
  }

  // Until the simulation tells it, the resistance is the thrust of the whole section by the feed.
  void resistance() {
    DrillFixture fixture;
    fixture.runner.setSetting("diameter", PropertyValue(4.0));
    const double narrow = fixture.tool->feelAtDevice().resistance;
    fixture.runner.setSetting("diameter", PropertyValue(8.0));
    const double wide = fixture.tool->feelAtDevice().resistance;
    // kp π r² / (1 + ktc r ω): linear in the radius where the spindle does most of the work.
    const double spindle = 1000.0 * 2.0 * M_PI / 60.0;
    QVERIFY(std::abs(narrow / (250.0 * M_PI * 4.0 / (1.0 + 1.64 * 2.0 * spindle)) - 1.0) < 1e-6);
    QVERIFY(std::abs(wide / narrow - 2.0) < 0.02);
  }
};

HANDWHEEL_TEST(DrillingToolTest)
#include "DrillingToolTest.moc"
