// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HandLathe.h"
#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Kind = PointerEvent::Kind;

// Sends a mouse event seen along y, so that a position of the view is (x, z) of the half plane of the tool.
ToolReply mouseAt(HandLathe& lathe, Kind kind, double x, double z, PointerButton button = PointerButton::First) {
  PointerEvent event;
  event.kind = kind;
  event.button = button;
  event.ray = {Vec3(x, -500.0, z), Vec3::UnitY()};
  return lathe.runner.pointer(event);
}

ToolReply handAt(HandLathe& lathe, Kind kind, double x, double z) {
  PointerEvent event;
  event.kind = kind;
  event.button = PointerButton::First;
  event.device = Pose(Eigen::Translation3d(x, 0.0, z));
  return lathe.runner.pointer(event);
}

// A tick of a device that feels nothing.
void tickOfHand(HandLathe& lathe, double x, double z, bool isHeld) {
  TipState tip;
  tip.position = Vec3(x, 0.0, z);
  tip.buttons = isHeld ? 1u : 0u;
  tip.isRestart = false;
  SimulationInputs& inputs = *lathe.tool->channel()->inputs;
  const std::uint32_t gesture = inputs.gestureAt(tip);
  while (!inputs.push({tip, tip.position, gesture})) std::this_thread::yield();
}

bool comesTo(const HandLathe& lathe, const ProfilePoint& position) {
  return QTest::qWaitFor([&] { return (lathe.tool->moment()->tip - position).norm() < 1e-6; });
}

// 3 mm of the end to a radius, by the automatic feed of 0.2 mm in a turn.
bool turnEndTo(HandLathe& lathe, double radius) {
  if (!lathe.wind(LatheAxis::Carriage, 100.5) || !lathe.wind(LatheAxis::Cross, radius)) return false;
  lathe.send(LatheCommand::Kind::Feed, -0.2);
  const bool isThere = QTest::qWaitFor([&] { return lathe.slide(kCarriageAxis) < 97.0; });
  lathe.send(LatheCommand::Kind::Feed, 0.0);
  return isThere && QTest::qWaitFor([&] { return lathe.machine().feed == 0.0; });
}

// ⌀50 × 100 mm with a bore of ⌀20 through it.
SnapshotPointer tubeToBore() {
  WorkpieceSnapshot tube;
  TurnedProfile profile(tube.stock, 0.05);
  for (std::size_t i = 0; i < profile.size(); ++i) profile.limitInner(i, 10.0);
  tube.part = std::make_shared<const TurnedPart>(TurnedPart::of(std::move(profile), {}, 0.1));
  return std::make_shared<const WorkpieceSnapshot>(std::move(tube));
}

}  // namespace

// A hand at the manual lathe: it drags the tool by the mouse or a device, touches off, and reads the roughness.
class ManualLatheHandTest : public QObject {
  Q_OBJECT

 private slots:
  // Wherever the mouse takes the tool, this follows it from there, by as much as the mouse moves.
  void theMouseDragsTheTool() {
    HandLathe lathe;
    const ProfilePoint from = lathe.tool->moment()->tip;
    QCOMPARE(mouseAt(lathe, Kind::Press, 60.0, 80.0), ToolReply::Used);
    QVERIFY(lathe.tool->isLive());
    QCOMPARE(mouseAt(lathe, Kind::Drag, 55.0, 92.0), ToolReply::Used);
    QVERIFY(comesTo(lathe, from + ProfilePoint(-5.0, 12.0)));
    QCOMPARE(mouseAt(lathe, Kind::Drag, 62.0, 79.0), ToolReply::Used);
    QVERIFY(comesTo(lathe, from + ProfilePoint(2.0, -1.0)));
    QCOMPARE(mouseAt(lathe, Kind::Release, 62.0, 79.0), ToolReply::Used);
    QVERIFY(!lathe.tool->isLive());
    QCOMPARE(lathe.document.history()->count(), 0);  // it was beside the bar
  }

  // The view's z is that of the document, in which the bar may lie anywhere.
  void theMouseDragsWhereTheBarLies() {
    HandLathe lathe;
    QVERIFY(lathe.document.setProperty("position", 30.0));
    const ProfilePoint from = lathe.tool->moment()->tip;
    mouseAt(lathe, Kind::Press, from.x(), from.y() + 30.0);
    mouseAt(lathe, Kind::Drag, 40.0, 145.0);
    QVERIFY(comesTo(lathe, {40.0, 115.0}));
  }

  // Releasing the wheels stops the slides, however far the mouse has gone.
  void lettingGoStopsTheSlides() {
    HandLathe lathe(std::chrono::milliseconds(1));
    const double from = lathe.slide(kCarriageAxis);
    mouseAt(lathe, Kind::Press, 60.0, 100.0);
    mouseAt(lathe, Kind::Drag, 60.0, 450.0);
    QVERIFY(QTest::qWaitFor([&] { return lathe.slide(kCarriageAxis) > from; }));
    mouseAt(lathe, Kind::Release, 60.0, 450.0);
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().demands == std::array<double, kLatheAxes>{}; }));
    const double there = lathe.slide(kCarriageAxis);
    QTest::qWait(100);
    QCOMPARE(lathe.slide(kCarriageAxis), there);
  }

  // Events that do not move the tool are left to the camera.
  void whatDoesNotTakeTheTool() {
    HandLathe lathe;
    QCOMPARE(mouseAt(lathe, Kind::Press, 60.0, 80.0, PointerButton::Second), ToolReply::Ignored);
    QCOMPARE(mouseAt(lathe, Kind::Drag, 60.0, 90.0), ToolReply::Ignored);
    QCOMPARE(mouseAt(lathe, Kind::Release, 60.0, 90.0), ToolReply::Ignored);
    QCOMPARE(mouseAt(lathe, Kind::Hover, 60.0, 90.0), ToolReply::Ignored);
    QCOMPARE(handAt(lathe, Kind::Release, 60.0, 90.0), ToolReply::Ignored);
    PointerEvent along;  // the axis: no position in the plane
    along.kind = Kind::Press;
    along.button = PointerButton::First;
    along.ray = {Vec3(10.0, 0.0, 500.0), -Vec3::UnitZ()};
    QCOMPARE(lathe.runner.pointer(along), ToolReply::Ignored);
    mouseAt(lathe, Kind::Press, 60.0, 80.0);
    QCOMPARE(mouseAt(lathe, Kind::Press, 60.0, 80.0), ToolReply::Ignored);  // it is taken
    QCOMPARE(handAt(lathe, Kind::Press, 60.0, 80.0), ToolReply::Ignored);
    QCOMPARE(handAt(lathe, Kind::Drag, 60.0, 80.0), ToolReply::Ignored);
  }

  // A hand at a device holds the tip: from the button on until it is let go, which ends the pass as one step.
  void aDeviceCutsAPass() {
    HandLathe lathe;
    QVERIFY(lathe.spin() && lathe.wind(LatheAxis::Carriage, 101.0) && lathe.wind(LatheAxis::Cross, 26.0));
    tickOfHand(lathe, 26.0, 101.0, false);
    QCOMPARE(handAt(lathe, Kind::Press, 26.0, 101.0), ToolReply::Used);
    QVERIFY(lathe.tool->isLive());
    QCOMPARE(mouseAt(lathe, Kind::Press, 60.0, 80.0), ToolReply::Ignored);  // one hand at a time
    tickOfHand(lathe, 26.0, 101.0, true);
    tickOfHand(lathe, 23.0, 101.0, true);
    QVERIFY(comesTo(lathe, {23.0, 101.0}));
    tickOfHand(lathe, 23.0, 96.0, true);
    QVERIFY(comesTo(lathe, {23.0, 96.0}));
    tickOfHand(lathe, 23.0, 96.0, false);
    QCOMPARE(handAt(lathe, Kind::Release, 23.0, 96.0), ToolReply::Used);
    QCOMPARE(lathe.document.history()->count(), 1);
    QVERIFY(std::abs(lathe.radiusAt(98.5) - 23.0) < 0.03);  // the work bends a little
    QCOMPARE(lathe.radiusAt(90.0), 25.0);
    QCOMPARE(lathe.document.workpiece().part->passes.size(), std::size_t{1});
  }

  // One that cuts nothing leaves the slides where the hand has brought them, and no step.
  void aDeviceMovesTheSlides() {
    HandLathe lathe;
    tickOfHand(lathe, 45.0, 120.0, false);
    QCOMPARE(handAt(lathe, Kind::Press, 45.0, 120.0), ToolReply::Used);
    tickOfHand(lathe, 45.0, 120.0, true);
    tickOfHand(lathe, 40.0, 130.0, true);
    QVERIFY(comesTo(lathe, {40.0, 130.0}));
    tickOfHand(lathe, 40.0, 130.0, false);
    QCOMPARE(handAt(lathe, Kind::Release, 40.0, 130.0), ToolReply::Used);
    QVERIFY(comesTo(lathe, {40.0, 130.0}));
    QVERIFY(!lathe.tool->isLive());
    QCOMPARE(lathe.document.history()->count(), 0);
  }

  // The button is pressed on the far side of the bar, 70 mm from the tool: this stays where it is, and follows the hand
  // by as much as it moves. It is not drawn through the bar to the hand.
  void aDeviceTakesTheToolWhereItIs() {
    HandLathe lathe;
    QVERIFY(lathe.spin() && lathe.wind(LatheAxis::Carriage, 60.0) && lathe.wind(LatheAxis::Cross, 26.0));
    const ProfilePoint from = lathe.tool->moment()->tip;
    tickOfHand(lathe, -30.0, 20.0, false);
    QCOMPARE(handAt(lathe, Kind::Press, -30.0, 20.0), ToolReply::Used);
    tickOfHand(lathe, -30.0, 20.0, true);
    QVERIFY(QTest::qWaitFor([&] { return lathe.tool->channel()->patch.read().gesture != 0; }));
    QVERIFY((lathe.tool->moment()->tip - from).norm() < 1e-9);
    tickOfHand(lathe, -31.5, 22.0, true);
    QVERIFY(comesTo(lathe, from + ProfilePoint(-1.5, 2.0)));
    tickOfHand(lathe, -31.5, 22.0, false);
    QCOMPARE(handAt(lathe, Kind::Release, -31.5, 22.0), ToolReply::Used);
    QVERIFY(lathe.tool->collisions().empty());
    // The next press begins anew, from anywhere.
    const ProfilePoint there = lathe.tool->moment()->tip;
    tickOfHand(lathe, 80.0, 150.0, false);
    QCOMPARE(handAt(lathe, Kind::Press, 80.0, 150.0), ToolReply::Used);
    tickOfHand(lathe, 80.0, 150.0, true);
    tickOfHand(lathe, 85.0, 150.0, true);
    QVERIFY(comesTo(lathe, there + ProfilePoint(5.0, 0.0)));
    tickOfHand(lathe, 85.0, 150.0, false);
    QCOMPARE(handAt(lathe, Kind::Release, 85.0, 150.0), ToolReply::Used);
  }

  // A turner who has measured ⌀49.5 enters it where the tool touches: from there on the read-out shows diameters, and Z
  // from the face. Each is a step of its own.
  void touchingOff() {
    HandLathe lathe;
    QVERIFY(!lathe.tool->isTouchedOff()[0] && !lathe.tool->preview().label);
    lathe.runner.deliver([&] { lathe.tool->touchOff(true, 49.5); });
    QVERIFY(lathe.tool->isTouchedOff()[0] && !lathe.tool->isTouchedOff()[1]);
    QCOMPARE(lathe.tool->readout().x(), 49.5);
    QVERIFY(lathe.wind(LatheAxis::Cross, lathe.slide(kCrossAxis) + 1.0));
    QVERIFY(std::abs(lathe.tool->readout().x() - 51.5) < 1e-9);  // in diameter
    lathe.runner.deliver([&] { lathe.tool->touchOff(false, 0.0); });
    QVERIFY(lathe.wind(LatheAxis::Carriage, lathe.slide(kCarriageAxis) - 3.0));
    QVERIFY(std::abs(lathe.tool->readout().y() + 3.0) < 1e-9);
    const auto label = lathe.tool->preview().label;
    QVERIFY(label && label->figures.size() == 2);
    QCOMPARE(label->figures[0].prefix, std::string("⌀"));
    QCOMPARE(label->figures[1].prefix, std::string("Z"));
    QCOMPARE(lathe.document.history()->count(), 2);
    lathe.undo();
    QVERIFY(lathe.tool->isTouchedOff()[0] && !lathe.tool->isTouchedOff()[1]);
  }

  // The tool is 20 mm before the bar. Z 5 is given to where it stands, so the zero is 5 mm nearer to the chuck, and
  // after 3 mm towards the chuck the tip is at Z 2, whichever tool asks.
  void theZOfAFaceIsKnownOnceThereIsAZero() {
    HandLathe lathe;
    QVERIFY(!lathe.tool->touchedSize(false));
    lathe.runner.deliver([&] { lathe.tool->touchOff(false, 5.0); });
    QVERIFY(lathe.wind(LatheAxis::Carriage, lathe.slide(kCarriageAxis) - 3.0));
    QVERIFY(lathe.tool->touchedSize(false) && std::abs(*lathe.tool->touchedSize(false) - 2.0) < 1e-9);
    QVERIFY(!lathe.tool->touchesEnd());
    const double gap = lathe.tool->touchGap(false);
    QVERIFY(lathe.wind(LatheAxis::Carriage, lathe.slide(kCarriageAxis) - gap));
    QVERIFY(lathe.tool->touchesEnd());
    QVERIFY(std::abs(*lathe.tool->touchedSize(false) - (2.0 - gap)) < 1e-9);
  }

  // With a read-out in radius the value is one, too.
  void touchingOffInRadius() {
    HandLathe lathe;
    lathe.runner.setSetting("shows_diameter", false);
    lathe.runner.deliver([&] { lathe.tool->touchOff(true, 24.75); });
    QCOMPARE(lathe.tool->readout().x(), 24.75);
    QVERIFY(lathe.wind(LatheAxis::Cross, lathe.slide(kCrossAxis) + 1.0));
    QVERIFY(std::abs(lathe.tool->readout().x() - 25.75) < 1e-9);
    QCOMPARE(lathe.tool->preview().label->figures.front().prefix, std::string("R"));
  }

  // Marks of a nose of 0.8 mm at 0.2 mm in a turn: Ra = f² / (32 r), 1.56 µm. Of a bar, and beside it, nothing is
  // known.
  void theRoughnessUnderTheTool() {
    HandLathe lathe;
    QVERIFY(!lathe.tool->roughnessHere());  // 20 mm before the face
    QVERIFY(lathe.spin() && turnEndTo(lathe, 23.0));
    QCOMPARE(lathe.tool->moment()->tool->noseRadius, 0.8);
    QVERIFY(lathe.wind(LatheAxis::Cross, 30.0) && lathe.wind(LatheAxis::Carriage, 98.5));
    const std::optional<double> roughness = lathe.tool->roughnessHere();
    QVERIFY(roughness && std::abs(*roughness - 1e3 * 0.04 / (32.0 * 0.8)) < 0.02);
    QVERIFY(lathe.wind(LatheAxis::Carriage, 60.0) && !lathe.tool->roughnessHere());
  }

  // A motor of 1.3 kW is asked for more by 2 mm at 0.2 mm in a turn. The warning is there while it cuts, and the same
  // afterwards.
  void warningsStay() {
    HandLathe lathe;
    lathe.runner.setSetting("power", 1.3);
    QVERIFY(lathe.tool->warnings().empty());
    QVERIFY(lathe.spin() && turnEndTo(lathe, 23.0));
    const std::vector<LatheWarning> during = lathe.tool->warnings();
    const auto isOfPower = [](const LatheWarning& w) { return w.warning.rule == CutWarning::Rule::Power; };
    const auto power = std::find_if(during.begin(), during.end(), isOfPower);
    QVERIFY(power != during.end());
    QCOMPARE(power->warning.limit, 1.3);
    QVERIFY(power->warning.value > 1.3 && power->tool == "right-roughing");
    QVERIFY(lathe.endPass());
    QVERIFY(lathe.tool->warnings() == during);
  }

  // The pass that undo would remove is named while it is cut. If a drill is fitted, it may be the cutting tool.
  void whatIsUnderWay() {
    HandLathe lathe;
    QVERIFY(lathe.tool->underWay().isEmpty());
    QVERIFY(lathe.spin() && turnEndTo(lathe, 23.0));
    QCOMPARE(lathe.tool->underWay(), QStringLiteral("Turning pass 1"));
    QVERIFY(lathe.endPass());
    QVERIFY(lathe.tool->underWay().isEmpty());
    lathe.runner.setSetting("fitting", 2.0);
    QVERIFY(turnEndTo(lathe, 22.0));
    QCOMPARE(lathe.tool->underWay(), QStringLiteral("Pass 2"));
  }

  // By keys: the spindle starts and stops, and the post indexes, past its last tool to the first.
  void spindleAndPostByKeys() {
    HandLathe lathe;
    QCOMPARE(lathe.runner.perform("spindle"), ToolReply::Used);
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().direction == 1; }));
    QCOMPARE(lathe.runner.perform("spindle"), ToolReply::Used);
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().direction == 0; }));
    LatheSetup two = lathe.tool->setup();
    two.stations.resize(2);
    QVERIFY(lathe.tool->setUp(two, "Set up"));
    QCOMPARE(lathe.runner.perform("next-tool"), ToolReply::Used);
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().tool == 1; }));
    QVERIFY(lathe.tool->moment()->tool->id == two.stations[1].tool);
    lathe.runner.perform("next-tool");
    QVERIFY(QTest::qWaitFor([&] { return lathe.machine().tool == 0; }));
    QCOMPARE(lathe.runner.perform("dance"), ToolReply::Ignored);
  }

  // A boring bar in the bore that undo has narrowed cannot be drawn out across it: it is put where it stood when the
  // part was as it is again.
  void undoInABore() {
    HandLathe lathe(tubeToBore());
    QVERIFY(!lathe.tool->mount(0, "boring-12"));
    const std::array<double, kLatheAxes> beside = lathe.machine().slides;
    const ProfilePoint clamped = lathe.tool->moment()->tip - ProfilePoint(beside[kCrossAxis], beside[kCarriageAxis]);
    QVERIFY(lathe.spin() && lathe.wind(LatheAxis::Cross, 11.0 - clamped.x()));
    QVERIFY(lathe.wind(LatheAxis::Carriage, 102.0 - clamped.y()));
    lathe.send(LatheCommand::Kind::Feed, -0.2);
    QVERIFY(QTest::qWaitFor([&] { return lathe.tool->moment()->tip.y() < 97.0; }));
    QVERIFY(lathe.endPass() && lathe.tool->collisions().empty());
    lathe.undo();
    QCOMPARE(lathe.tool->returnCount(), 1);
    QCOMPARE(lathe.machine().slides, beside);
    QVERIFY(lathe.machine().direction == 1);  // the spindle goes on
    QVERIFY(lathe.wind(LatheAxis::Carriage, beside[kCarriageAxis] - 5.0) && lathe.tool->collisions().empty());
  }
};

HANDWHEEL_TEST(ManualLatheHandTest)
#include "ManualLatheHandTest.moc"
