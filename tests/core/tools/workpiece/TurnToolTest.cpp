// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/TurnTool.h"

#include "TestClass.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/WorkpieceKind.h"
#include "tools/ToolRunner.h"

#include <QtTest>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

using namespace handwheel;

namespace {

// A clock whose speed the test sets; waiting for it is short.
class HandClock : public ServoClock {
 public:
  std::int64_t now() noexcept override { return m_now; }
  void waitUntil(std::int64_t) noexcept override { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }
  void set(std::int64_t now) { m_now = now; }

 private:
  std::atomic<std::int64_t> m_now{0};
};

// A bar of 50 × 100 mm and the tool on it, seen from the front: the plane of the tool is y = 0.
struct TurningFixture {
  WorkpieceKind kind;
  std::unique_ptr<Document> made = kind.make(DocumentKinds::blank(kind));
  WorkpieceDocument& document = static_cast<WorkpieceDocument&>(*made);
  MonotonicClock clock;
  Service simulation{"simulation"};
  ToolRunner runner;
  TurnTool* tool = nullptr;

  explicit TurningFixture(ServoClock* other = nullptr, const TurnTool::Start& start = {.spacing = 0.1}) {
    auto started = std::make_unique<TurnTool>(document, SimulationServices{other ? *other : clock, simulation}, start);
    tool = started.get();
    runner.start(std::move(started), document);
  }
  void event(PointerEvent::Kind kindOfEvent, double x, double z, std::optional<double> time = {}) {
    PointerEvent event;
    event.time = time;
    event.kind = kindOfEvent;
    event.button = kindOfEvent == PointerEvent::Kind::Hover ? PointerButton::None : PointerButton::First;
    event.ray = {Vec3(x, -500.0, z), Vec3::UnitY()};
    runner.pointer(event);
  }
  // A tick of a device that feels nothing.
  void tick(double x, double z, bool isHeld) {
    TipState tip;
    tip.position = Vec3(x, 0.0, z);
    tip.buttons = isHeld ? 1u : 0u;
    tip.isRestart = false;
    SimulationInputs& inputs = *tool->channel()->inputs;
    const std::uint32_t gesture = inputs.gestureAt(tip);
    while (!inputs.push({tip, tip.position, gesture})) std::this_thread::yield();
  }
  void deviceEvent(PointerEvent::Kind kindOfEvent, double x, double z) {
    PointerEvent event;
    event.kind = kindOfEvent;
    event.button = PointerButton::First;
    event.device = Pose(Eigen::Translation3d(x, 0.0, z));
    runner.pointer(event);
  }
  // Into the bar and out again, with the button held.
  void plunge(double depth, double z) {
    for (double x = 27.0; x > 26.0 - depth; x -= 0.05) tick(x, z, true);
    for (double x = 26.0 - depth; x < 27.0; x += 0.05) tick(x, z, true);
  }
  // A whole gesture of a device.
  void plungeByDevice(double depth, double z) {
    tick(27.0, z, true);
    deviceEvent(PointerEvent::Kind::Press, 27.0, z);
    plunge(depth, z);
    tick(27.0, z, false);
    deviceEvent(PointerEvent::Kind::Release, 27.0, z);
  }
  // Returns the least radius in the simulation, which is not in the document; 25: nothing was cut.
  double leastShown() const {
    double least = 25.0;
    for (const DisplayPart& part : tool->preview().replaced->parts) {
      for (const Vec3& p : part.soup->points) {
        if (p.z() > 1.0 && p.z() < 99.0) least = std::min(least, std::hypot(p.x(), p.y()));
      }
    }
    return least;
  }
  void pass(double x, double from, double to) {
    event(PointerEvent::Kind::Press, std::copysign(std::max(27.0, std::abs(x)), x), from);  // beside the bar
    for (int i = 0; i <= 20; ++i) event(PointerEvent::Kind::Drag, x, from + (to - from) * i / 20.0);
    event(PointerEvent::Kind::Release, x, to);
  }
  double radiusAt(double z) const {
    const TurnedProfile& profile = document.workpiece().part->profile;
    return profile.radius(static_cast<std::size_t>(std::lround(z / profile.spacing())));
  }
};

}  // namespace

class TurnToolTest : public QObject {
  Q_OBJECT

 private slots:
  // A nose of 1 mm whose centre moves 23 mm beside the axis leaves a radius of 22 mm.
  void aPassIsOneUndoStep() {
    TurningFixture fixture;
    QVERIFY(!fixture.document.workpiece().part);
    fixture.pass(23.0, 30.0, 60.0);
    QCOMPARE(fixture.document.history()->count(), 1);
    for (const double z : {30.0, 45.0, 60.0}) QVERIFY(std::abs(fixture.radiusAt(z) - 22.0) < 1e-9);
    QCOMPARE(fixture.radiusAt(10.0), 25.0);
    fixture.pass(-20.0, 30.0, 40.0);  // from the other side it is the same part
    QCOMPARE(fixture.document.history()->count(), 2);
    QVERIFY(std::abs(fixture.radiusAt(35.0) - 19.0) < 1e-9);
    const TurnedProfile after = fixture.document.workpiece().part->profile;
    fixture.document.history()->undo();
    QVERIFY(std::abs(fixture.radiusAt(35.0) - 22.0) < 1e-9);
    fixture.document.history()->undo();
    QVERIFY(!fixture.document.workpiece().part);
    fixture.document.history()->redo();
    fixture.document.history()->redo();
    QVERIFY(fixture.document.workpiece().part->profile == after);
    // The stored passes give the same part.
    TurnedProfile again(fixture.document.workpiece().stock, after.spacing());
    for (const auto& pass : fixture.document.workpiece().part->passes) cut(again, *pass);
    QVERIFY(again == after);
  }

  // An exercise gives the nose, and the feed beyond which it says that the hand is too fast: while it cuts, with the
  // figure at the pointer, and once the pass is done.
  void aFeedThatIsTooHigh() {
    TurningFixture fixture(nullptr, {.spacing = 0.1, .noseRadius = 0.8, .largestFeed = 1.0});
    QCOMPARE(std::get<double>(fixture.tool->settings().front().value), 0.8);
    const double turns = latheOf(fixture.document.workpiece()).spindle.speed / 60.0;  // a second
    const auto drag = [&](double x, double feed) {
      const double seconds = 20.0 / (feed * turns);
      fixture.event(PointerEvent::Kind::Press, 27.0, 30.0, 0.0);
      for (int i = 0; i <= 400; ++i)
        fixture.event(PointerEvent::Kind::Drag, x, 30.0 + i / 20.0, 1.0 + seconds * i / 400);
    };
    const auto says = [&] { return fixture.tool->actions().front().effect.find("too fast") != std::string::npos; };
    drag(24.8, 0.2);
    QVERIFY(!says());
    fixture.event(PointerEvent::Kind::Release, 24.8, 50.0, 1000.0);
    QVERIFY(fixture.document.workpiece().part && !fixture.tool->tooFast());
    drag(23.8, 2.0);
    QTRY_VERIFY(says());
    QVERIFY(std::abs(fixture.tool->preview().label->figures.back().value - 2.0) < 0.05);
    fixture.event(PointerEvent::Kind::Release, 23.8, 50.0, 1000.0);
    QVERIFY(fixture.tool->tooFast() && std::abs(*fixture.tool->tooFast() - 2.0) < 0.05);
  }

  // Beside the nose of 1 mm: diameter and height of its theoretical corner, where a shoulder comes to be, and how deep
  // the nose is below the surface before the pass.
  void theLabelSaysWhereTheNoseIs() {
    TurningFixture fixture;
    const auto figures = [&] {
      std::vector<double> values;
      if (const auto label = fixture.tool->preview().label)
        for (const ToolLabel::Figure& figure : label->figures) values.push_back(figure.value);
      return values;
    };
    const auto isNear = [](const std::vector<double>& a, const std::vector<double>& b) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                        [](double x, double y) { return std::abs(x - y) < 1e-9; });
    };
    QVERIFY(figures().empty());
    fixture.event(PointerEvent::Kind::Hover, 27.0, 45.0);
    QVERIFY(isNear(figures(), {52.0, 44.0, 0.0}));
    QCOMPARE(fixture.tool->preview().label->figures[0].prefix, std::string("⌀"));
    fixture.event(PointerEvent::Kind::Press, 27.0, 45.0);
    fixture.event(PointerEvent::Kind::Drag, 24.8, 45.0);
    QTRY_VERIFY(fixture.leastShown() < 24.0);
    QVERIFY(isNear(figures(), {47.6, 44.0, -1.2}));  // also when that surface is gone
    fixture.event(PointerEvent::Kind::Release, 24.8, 45.0);
    fixture.event(PointerEvent::Kind::Hover, 26.0, 45.0);
    fixture.event(PointerEvent::Kind::Press, 26.0, 45.0);
    fixture.event(PointerEvent::Kind::Drag, 24.3, 45.0);
    QVERIFY(isNear(figures(), {46.6, 44.0, -0.5}));  // figures of the part after the last pass
    QCOMPARE(fixture.runner.perform("revert"), ToolReply::Used);
    fixture.event(PointerEvent::Kind::Hover, 27.0, 110.0);  // beyond its end there is no surface
    QVERIFY(isNear(figures(), {52.0, 109.0}));
    fixture.event(PointerEvent::Kind::Hover, 90.0, 45.0);
    QVERIFY(figures().empty());
    PointerEvent held;  // for a device, the position is that of its displayed tip
    held.device = Pose(Eigen::Translation3d(20.0, 0.0, 50.0));
    held.proxy = Vec3(26.0, 0.0, 50.0);
    fixture.runner.pointer(held);
    QVERIFY(isNear(figures(), {50.0, 49.0, 0.0}));
  }

  // A click on the part cuts nothing, wherever it lands; from there a drag cuts as deep as it goes inwards.
  void theMouseBeginsAtTheSurface() {
    TurningFixture fixture;
    for (const double x : {24.0, 3.0, 0.0, -10.0}) {
      fixture.event(PointerEvent::Kind::Press, x, 50.0);
      fixture.event(PointerEvent::Kind::Release, x, 50.0);
    }
    QCOMPARE(fixture.document.history()->count(), 0);
    fixture.event(PointerEvent::Kind::Press, 10.0, 50.0);
    fixture.event(PointerEvent::Kind::Drag, 8.0, 50.0);
    fixture.event(PointerEvent::Kind::Drag, 8.0, 60.0);
    fixture.event(PointerEvent::Kind::Release, 8.0, 60.0);
    for (const double z : {50.0, 55.0, 60.0}) QVERIFY(std::abs(fixture.radiusAt(z) - 23.0) < 1e-3);
    QCOMPARE(fixture.radiusAt(40.0), 25.0);
  }

  // With the tool for a bore a click on the solid bar cuts nothing either; a drag bores from the upper end.
  void theMouseBores() {
    TurningFixture fixture;
    QVERIFY(fixture.tool->settings().size() >= 5);
    fixture.runner.setSetting("side", 1.0);
    for (const double x : {24.0, 8.0, 0.0, -10.0}) {
      fixture.event(PointerEvent::Kind::Press, x, 50.0);
      fixture.event(PointerEvent::Kind::Release, x, 50.0);
    }
    QCOMPARE(fixture.document.history()->count(), 0);
    fixture.event(PointerEvent::Kind::Press, 8.0, 50.0);
    fixture.event(PointerEvent::Kind::Drag, 8.0, 20.0);
    fixture.event(PointerEvent::Kind::Release, 8.0, 20.0);
    QVERIFY(fixture.document.workpiece().part);
    const TurnedProfile& part = fixture.document.workpiece().part->profile;
    QVERIFY(std::abs(part.inner(900) - 9.0) < 1e-9);  // the nose has the radius 1
    QCOMPARE(part.inner(500), 0.0);
    QCOMPARE(part.radius(900), 25.0);
    // Within the bore it begins at the wall.
    fixture.event(PointerEvent::Kind::Press, 20.0, 90.0);
    fixture.event(PointerEvent::Kind::Drag, 21.0, 90.0);
    fixture.event(PointerEvent::Kind::Release, 21.0, 90.0);
    QVERIFY(std::abs(fixture.document.workpiece().part->profile.inner(900) - 10.0) < 1e-9);
  }

  // The cutting method is that of the settings, and the pass remembers it.
  void thePassKeepsItsMethod() {
    TurningFixture fixture;
    fixture.runner.setSetting("method", 1.0);
    fixture.runner.setSetting("resolution", 2.0);
    fixture.pass(23.0, 30.0, 60.0);
    const TurningPass& pass = *fixture.document.workpiece().part->passes[0];
    QVERIFY(pass.method == TurningMethod::Poles);
    QCOMPARE(pass.resolution, 2.0);
    TurnedProfile again(fixture.document.workpiece().stock, 0.1);
    cut(again, pass);
    QVERIFY(again == fixture.document.workpiece().part->profile);
  }

  // The history tells the result of a pass, and that it has parted the bar.
  void theHistorySaysWhatAPassHasDone() {
    TurningFixture fixture;
    fixture.pass(23.0, 30.0, 60.0);
    const double removed =
        fixture.document.workpiece().stock.volume() - fixture.document.workpiece().part->profile.volume();
    QVERIFY(removed > 1000.0);
    QCOMPARE(fixture.document.history()->text(0),
             QStringLiteral("Turning pass 1: −%1 mm³").arg(QLocale().toString(removed, 'f', 0)));
    fixture.pass(0.5, 80.0, 82.0);
    QCOMPARE(fixture.document.workpiece().part->profile.pieces().size(), std::size_t{2});
    QVERIFY(fixture.document.history()->text(1).startsWith("Turning pass 2: −"));
    QVERIFY(fixture.document.history()->text(1).contains("2 piece"));
  }

  // The simulation works on its own thread: its cuts are shown within a few of its steps.
  void whatIsCutIsShownBeforeItIsCommitted() {
    TurningFixture fixture;
    const auto before = fixture.tool->preview().replaced;
    QVERIFY(before && fixture.tool->preview().replaced == before);  // an unchanged part costs nothing
    fixture.event(PointerEvent::Kind::Press, 27.0, 50.0);
    fixture.event(PointerEvent::Kind::Drag, 20.0, 50.0);
    const auto shownRadius = [&] {
      double least = 25.0;
      for (const DisplayPart& part : fixture.tool->preview().replaced->parts) {
        for (const Vec3& p : part.soup->points) {
          if (std::abs(p.z() - 50.0) < 0.04) least = std::min(least, std::hypot(p.x(), p.y()));
        }
      }
      return least;
    };
    QTRY_VERIFY(std::abs(shownRadius() - 19.0) < 1e-9);
    QCOMPARE(fixture.document.history()->count(), 0);
    QVERIFY(!fixture.tool->preview().lines.empty());
  }

  void escapeDropsThePass() {
    TurningFixture fixture;
    fixture.event(PointerEvent::Kind::Press, 23.0, 50.0);
    fixture.event(PointerEvent::Kind::Drag, 20.0, 50.0);
    QCOMPARE(fixture.runner.perform("revert"), ToolReply::Used);
    fixture.event(PointerEvent::Kind::Release, 20.0, 50.0);
    QCOMPARE(fixture.document.history()->count(), 0);
    fixture.pass(24.0, 10.0, 20.0);  // and the next one begins anew
    QVERIFY(std::abs(fixture.radiusAt(15.0) - 23.0) < 1e-9);
    QCOMPARE(fixture.document.workpiece().part->profile.radius(500), 25.0);
  }

  // The hand continues with the button held after the pass was dropped: it cuts nothing until the button is pressed
  // again, and the next pass begins there.
  void aDroppedPassOfADeviceIsOver_data() {
    QTest::addColumn<int>("drop");
    QTest::addRow("Esc") << 0;
    QTest::addRow("undo") << 1;
    QTest::addRow("another nose") << 2;
    QTest::addRow("the tool is chosen with the button held") << 3;
  }
  void aDroppedPassOfADeviceIsOver() {
    QFETCH(int, drop);
    TurningFixture fixture;
    if (drop == 1) QVERIFY(fixture.document.setProperty("chord", 0.02));
    if (drop != 3) {
      fixture.tick(27.0, 20.0, true);
      fixture.deviceEvent(PointerEvent::Kind::Press, 27.0, 20.0);
    }
    fixture.plunge(5.0, 20.0);
    if (drop != 3) QTRY_VERIFY(fixture.leastShown() < 20.5);
    if (drop == 0) QCOMPARE(fixture.runner.perform("revert"), ToolReply::Used);
    if (drop == 1) fixture.document.history()->undo();
    if (drop == 2) fixture.runner.setSetting("nose_radius", 2.0);
    fixture.plunge(5.0, 30.0);
    fixture.tick(27.0, 30.0, false);
    fixture.deviceEvent(PointerEvent::Kind::Release, 27.0, 30.0);
    QTest::qWait(20);  // some steps
    QCOMPARE(fixture.leastShown(), 25.0);
    QVERIFY(!fixture.document.workpiece().part);
    fixture.plungeByDevice(5.0, 80.0);
    QVERIFY(std::abs(fixture.radiusAt(80.0) - (drop == 2 ? 19.0 : 20.0)) < 0.06);
    for (const double z : {20.0, 30.0, 50.0}) QCOMPARE(fixture.radiusAt(z), 25.0);
  }

  // One hand at a time: the mouse neither cuts in a pass of the device nor ends it, and a device does not cut in one of
  // the mouse.
  void theOtherHandDoesNotTakePart() {
    TurningFixture fixture;
    fixture.tick(27.0, 20.0, true);
    fixture.deviceEvent(PointerEvent::Kind::Press, 27.0, 20.0);
    fixture.pass(20.0, 60.0, 70.0);
    fixture.plunge(5.0, 20.0);
    QVERIFY(!fixture.document.workpiece().part);
    fixture.deviceEvent(PointerEvent::Kind::Release, 27.0, 20.0);
    QVERIFY(std::abs(fixture.radiusAt(20.0) - 20.0) < 0.06);
    QCOMPARE(fixture.radiusAt(65.0), 25.0);
    fixture.tick(27.0, 20.0, false);
    fixture.event(PointerEvent::Kind::Press, 27.0, 60.0);
    fixture.event(PointerEvent::Kind::Drag, 24.0, 60.0);
    fixture.plunge(5.0, 40.0);
    fixture.event(PointerEvent::Kind::Release, 24.0, 60.0);
    QVERIFY(std::abs(fixture.radiusAt(60.0) - 23.0) < 1e-9);
    QCOMPARE(fixture.radiusAt(40.0), 25.0);
  }

  // The file promises seconds, also of the mouse.
  void thePointsOfTheMouseHaveTheirTimes() {
    HandClock clock;
    TurningFixture fixture(&clock);
    const std::vector<double> expected{0.0, 0.25, 0.5, 2.0};
    for (const double time : expected) {
      clock.set(static_cast<std::int64_t>((5.0 + time) * kNanoseconds));
      const bool isFirst = time == 0.0;
      fixture.event(isFirst ? PointerEvent::Kind::Press : PointerEvent::Kind::Drag, isFirst ? 27.0 : 23.0, 50.0 + time);
    }
    fixture.event(PointerEvent::Kind::Release, 23.0, 52.0);
    const std::vector<double>& times = fixture.document.workpiece().part->passes.front()->times;
    QCOMPARE(times.size(), expected.size());
    for (std::size_t i = 0; i < times.size(); ++i) QVERIFY(std::abs(times[i] - expected[i]) < 1e-9);
  }

  // A busy window comes to several moves of the mouse at once: each has the time at which it happened.
  void lateMovesHaveTheirOwnTimes() {
    HandClock clock;  // stands still
    TurningFixture fixture(&clock);
    fixture.event(PointerEvent::Kind::Press, 27.0, 50.0, 70.0);
    fixture.event(PointerEvent::Kind::Drag, 23.0, 50.0, 70.25);
    fixture.event(PointerEvent::Kind::Drag, 23.0, 51.0, 71.5);
    fixture.event(PointerEvent::Kind::Drag, 23.0, 52.0);  // not known: no earlier than the one before
    fixture.event(PointerEvent::Kind::Release, 23.0, 52.0);
    QCOMPARE(fixture.document.workpiece().part->passes.front()->times, (std::vector<double>{0.0, 0.25, 1.5, 1.5}));
  }

  // Outside of the view no nose is shown, except in a pass; a double click is the camera's.
  void theMouseLeaves() {
    TurningFixture fixture;
    fixture.event(PointerEvent::Kind::Hover, 27.0, 45.0);
    QVERIFY(fixture.tool->preview().label);
    fixture.event(PointerEvent::Kind::Leave, 27.0, 45.0);
    QVERIFY(!fixture.tool->preview().label && !fixture.tool->isLive());
    fixture.event(PointerEvent::Kind::Press, 27.0, 45.0);
    fixture.event(PointerEvent::Kind::Leave, 27.0, 45.0);
    QVERIFY(fixture.tool->preview().label && fixture.tool->isLive());
    PointerEvent twice;
    twice.kind = PointerEvent::Kind::DoubleClick;
    QCOMPARE(fixture.runner.pointer(twice), ToolReply::Ignored);
    QCOMPARE(fixture.tool->needs(), std::vector<std::string>{"simulation"});
    for (const ToolKey& key : TurnTool::keys()) QVERIFY(fixture.runner.perform(key.action) == ToolReply::Used);
    QVERIFY(!fixture.tool->isLive());  // Esc, the only one, drops the pass
  }

  void besideTheBarNothingIsCommitted() {
    TurningFixture fixture;
    fixture.pass(40.0, 10.0, 90.0);
    QCOMPARE(fixture.document.history()->count(), 0);
    QVERIFY(!fixture.document.workpiece().part);
  }

  // An undo under the tool: the next pass cuts what the document has.
  void followsTheDocument() {
    TurningFixture fixture;
    fixture.pass(15.0, 10.0, 90.0);
    fixture.document.history()->undo();
    fixture.pass(23.0, 40.0, 50.0);
    QCOMPARE(fixture.radiusAt(20.0), 25.0);
  }

  // The size of a bar that was cut stays; undone, it may change again.
  void aCutBarKeepsItsSize() {
    TurningFixture fixture;
    fixture.pass(23.0, 40.0, 50.0);
    QVERIFY(!fixture.document.setProperty("diameter", 60.0));
    QVERIFY(!fixture.document.setProperty("length", 60.0));
    QVERIFY(fixture.document.setProperty("chord", 0.02));
    QVERIFY(fixture.document.setProperty("position", 5.0));
    for (int i = 0; i < 3; ++i) fixture.document.history()->undo();
    QVERIFY(fixture.document.setProperty("diameter", 60.0));
  }
};

HANDWHEEL_TEST(TurnToolTest)
#include "TurnToolTest.moc"
