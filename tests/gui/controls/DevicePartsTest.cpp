// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ControlsTestMain.h"
#include "DeviceScenes.h"
#include "panels/device/AxisBars.h"
#include "panels/device/ButtonLamps.h"
#include "panels/device/DeviceText.h"
#include "panels/device/ForceTrace.h"
#include "panels/device/MappingForm.h"
#include "panels/device/SafetyActionHold.h"
#include "panels/device/TimingPlot.h"

#include <rapidcheck.h>
#include <QTest>
#include <limits>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

// The parts of the device panel, by their values.
class DevicePartsTest : public QObject {
  Q_OBJECT

 private slots:
  void traceKeepsTenSeconds();
  void traceKeepsThePeaks();
  void traceStartsAnew();
  void safetyIsHeld();
  void everySafetyActionHasWords();
  void homingIsTheDevicesOwn();
  void dataSheetLeavesOutWhatIsNot();
  void barsOfEveryTick();
  void lateTicksAreReported();
  void axesStayAPermutation();
  void mappingByProperties();
  void mappingSuitsTheDevice();
  void bars();
  void turnsByTheSmallerAngle();
  void lamps();
  void theHandIsLed();
};

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

SafetyActions only(SafetyAction action) {
  SafetyActions actions;
  actions.add(action);
  return actions;
}

const Property* find(const std::vector<Property>& properties, const std::string& id) {
  for (const Property& property : properties) {
    if (property.id == id) return &property;
  }
  return nullptr;
}

}  // namespace

void DevicePartsTest::traceKeepsTenSeconds() {
  QVERIFY(rc::check("ten seconds, and no more than their points", [] {
    ForceTrace trace;
    double time = 0.0;
    for (const double step : *rc::gen::container<std::vector<double>>(
             3000, rc::gen::map(rc::gen::inRange(0, 40000), [](int us) { return us * 1e-6; }))) {
      trace.add({time += step, 1.0, 1.0});
      RC_ASSERT(trace.size() <= ForceTrace::kSeconds / ForceTrace::kSpacing + 1);
    }
    RC_ASSERT(time - trace.at(0).time <= ForceTrace::kSeconds + ForceTrace::kSpacing);
    RC_ASSERT(time - trace.last().time < ForceTrace::kSpacing);
    for (std::size_t i = 1; i < trace.size(); ++i) {
      RC_ASSERT(trace.at(i).time - trace.at(i - 1).time >= ForceTrace::kSpacing);
    }
  }));
}

void DevicePartsTest::traceKeepsThePeaks() {
  ForceTrace trace;
  trace.add({1.0, 2.0, 1.0});
  trace.add({1.001, 7.0, kNaN});
  trace.add({1.002, kNaN, 3.0});
  trace.add({1.5, 0.0, 0.0});
  QCOMPARE(trace.size(), std::size_t(2));
  QCOMPARE(trace.at(0).asked, 7.0);
  QCOMPARE(trace.at(0).sent, 3.0);
}

void DevicePartsTest::traceStartsAnew() {
  ForceTrace trace;
  for (const double time : {5.0, 6.0, kNaN, kInfinity}) trace.add({time, 1.0, 1.0});
  QCOMPARE(trace.size(), std::size_t(2));
  trace.add({0.0, 2.0, 2.0});  // another loop
  QCOMPARE(trace.size(), std::size_t(1));
  QCOMPARE(trace.last().asked, 2.0);
  trace.add({1e9, 3.0, 3.0});
  QCOMPARE(trace.size(), std::size_t(1));
}

void DevicePartsTest::safetyIsHeld() {
  SafetyActionHold memory;
  QVERIFY(memory.add({}, 0.0).isEmpty());
  QVERIFY(memory.add(only(SafetyAction::Clamp), 1.0).has(SafetyAction::Clamp));
  const SafetyActions both = memory.add(only(SafetyAction::Slew), 1.5);
  QCOMPARE(both.bits(), only(SafetyAction::Clamp).bits() | only(SafetyAction::Slew).bits());
  QCOMPARE(memory.add({}, 1.0 + 1.01 * SafetyActionHold::kHold).bits(), only(SafetyAction::Slew).bits());
  QVERIFY(memory.add({}, 1.5 + 1.01 * SafetyActionHold::kHold).isEmpty());
  memory.add(only(SafetyAction::Ramp), 3.0);
  QVERIFY(memory.add({}, 0.1).isEmpty());  // time of another loop
  memory.add(only(SafetyAction::Ramp), 0.2);
  QVERIFY(memory.add({}, kNaN).isEmpty());
}

void DevicePartsTest::everySafetyActionHasWords() {
  std::set<QString> sentences;
  SafetyActions all;
  for (const SafetyAction action :
       {SafetyAction::DeviceFault, SafetyAction::NotFinite, SafetyAction::Passivity, SafetyAction::SpeedDamping,
        SafetyAction::SpeedCut, SafetyAction::Ramp, SafetyAction::Watchdog, SafetyAction::Slew, SafetyAction::Clamp}) {
    all.add(action);
    const QStringList words = DeviceText::safety(only(action));
    QCOMPARE(words.size(), 1);
    sentences.insert(words.front());
  }
  QCOMPARE(sentences.size(), std::size_t(9));
  QCOMPARE(DeviceText::safety(all).size(), 9);
  QVERIFY(DeviceText::safety({}).isEmpty());
  std::set<QString> states;
  for (const DeviceStatus status : {DeviceStatus::Absent, DeviceStatus::Starting, DeviceStatus::NeedsHoming,
                                    DeviceStatus::Ready, DeviceStatus::Failed}) {
    states.insert(DeviceText::status(status));
    QCOMPARE(DeviceText::advice(status, "any").isEmpty(), status == DeviceStatus::Ready);
  }
  QCOMPARE(states.size(), std::size_t(5));
}

// Only a Falcon finds its position at the ends of its travel.
void DevicePartsTest::homingIsTheDevicesOwn() {
  std::set<QString> advices;
  for (const char* const driver : {"falcon", "openhaptics", "haply"}) {
    const QString advice = DeviceText::advice(DeviceStatus::NeedsHoming, driver);
    advices.insert(advice);
    QCOMPARE(advice.contains("all the way"), QString(driver) == "falcon");
    QVERIFY(advice.contains("no force until then"));
  }
  QCOMPARE(advices.size(), std::size_t(3));
}

void DevicePartsTest::dataSheetLeavesOutWhatIsNot() {
  QStringList lines;
  for (const auto& line : DeviceText::dataSheet(falconView().capabilities, QLocale::c())) {
    lines << line.name + ": " + line.value;
  }
  QCOMPARE(lines, QStringList({"Measured axes: 3", "Actuated axes: 3", "Buttons: 4", "Largest force: 8 N",
                               "Stiffness: 3 N/mm", "Damping: 0.02 N·s/mm", "Internal damping: 0.002 N·s/mm",
                               "Radius of the workspace: 40 mm", "Servo rate: 1000 Hz", "Delay: 1 ms"}));
  const auto mouse = DeviceText::dataSheet(spaceMouseView().capabilities, QLocale::c());
  QCOMPARE(mouse[1].value, QString("none"));
}

// For any counts, the bars hold all of them, lie within the times and are not too many.
void DevicePartsTest::barsOfEveryTick() {
  QVERIFY(rc::check("every tick is in a bar", [] {
    TimingHistogram histogram(5e-6);
    const auto times = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-10, 2000));  // us
    for (const int time : times) histogram.add(time * 1e-6);
    const Plot plot = timingPlot(countsOf(histogram), "Lateness", QLocale::c());
    const PlotSeries& bars = plot.series.at(0);
    double ticks = 0.0;
    for (const QPointF& bar : bars.points) ticks += bar.y();
    RC_ASSERT(ticks == static_cast<double>(times.size()));
    RC_ASSERT(bars.points.size() <= 40u);
    for (const QPointF& bar : bars.points) {
      RC_ASSERT(bar.y() >= 1.0);
      RC_ASSERT(bar.x() > 0.0);
      RC_ASSERT(bar.x() <= 256 * 5.0 + bars.barWidth);
    }
  }));
}

void DevicePartsTest::lateTicksAreReported() {
  TimingHistogram histogram(5e-6);
  for (int i = 0; i < 98; ++i) histogram.add(12e-6);
  histogram.add(102e-6);
  histogram.add(402e-6);
  TimingCounts counts = countsOf(histogram);
  QCOMPARE(counts.median, 15e-6);  // the upper end of the bin of 10 to 15
  QCOMPARE(counts.most, 105e-6);
  QCOMPARE(counts.longest, 405e-6);
  QVERIFY(!counts.isOpen);
  histogram.add(0.05);
  QVERIFY(countsOf(histogram).isOpen);
}

void DevicePartsTest::axesStayAPermutation() {
  QVERIFY(rc::check("each axis of the device moves one of the view", [] {
    WorkspaceMapping mapping;
    const auto edits = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, 3), rc::gen::inRange(-2, 9)));
    for (const auto& [axis, choice] : edits) {
      const char* const id = std::array{"right", "up", "near"}[static_cast<std::size_t>(axis)];
      mapping = withProperty(mapping, id, static_cast<double>(choice));
      RC_ASSERT(std::abs(std::abs(mapping.viewFromDevice().determinant()) - 1.0) < 1e-12);
      if (choice < 0 || choice > 5) continue;
      const Property shown = *find(mappingProperties(mapping, {}), id);
      RC_ASSERT(std::get<double>(shown.value) == choice);
    }
  }));
}

void DevicePartsTest::mappingByProperties() {
  WorkspaceMapping mapping;
  mapping.sceneFromView.translation() = Vec3(1, 2, 3);
  mapping = withProperty(mapping, "up", 5.0);  // Z, inverted; Y goes where Z was
  QCOMPARE(Vec3(mapping.viewFromDevice() * Vec3(1, 2, 3)), Vec3(1, -3, 2));
  mapping = withProperty(mapping, "scale", 2.5);
  mapping = withProperty(mapping, "gain", 0.5);
  mapping = withProperty(mapping, "dead", 3.0);
  mapping = withProperty(mapping, "turnDead", 0.1);
  mapping = withProperty(mapping, "rate", true);
  mapping = withProperty(mapping, "rateGain", 4.0);
  mapping = withProperty(mapping, "turnGain", 6.0);
  mapping = withProperty(mapping, "clutch", 3.0);
  QCOMPARE(mapping.scale, 2.5);
  QCOMPARE(mapping.forceGain, 0.5);
  QCOMPARE(mapping.deadZone, 3.0);
  QCOMPARE(mapping.angularDeadZone, 0.1);
  QVERIFY(mapping.isRateControl);
  QCOMPARE(mapping.rateGain, 4.0);
  QCOMPARE(mapping.angularRateGain, 6.0);
  QCOMPARE(mapping.clutchButtons, 4u);
  QCOMPARE(Vec3(mapping.sceneFromView.translation()), Vec3(1, 2, 3));
  QCOMPARE(withProperty(mapping, "clutch", 32.0).clutchButtons, 1u << 31);
  QCOMPARE(withProperty(mapping, "clutch", 0.0).clutchButtons, 0u);
  for (const double wrong : {0.0, -1.0, 1e300}) QVERIFY(withProperty(mapping, "scale", wrong).scale > 0.0);
  for (const double wrong : {kNaN, kInfinity, -kInfinity}) {
    for (const char* id : {"scale", "gain", "dead", "clutch", "right", "other"}) {
      const WorkspaceMapping same = withProperty(mapping, id, wrong);
      QCOMPARE(same.scale, 2.5);
      QCOMPARE(same.deadZone, 3.0);
      QCOMPARE(same.clutchButtons, 4u);
      QCOMPARE(Vec3(same.viewFromDevice() * Vec3(1, 2, 3)), Vec3(1, -3, 2));
    }
  }
}

void DevicePartsTest::mappingSuitsTheDevice() {
  WorkspaceMapping mapping;
  mapping.clutchButtons = 0b110;
  const auto haptic = mappingProperties(mapping, falconView().capabilities);
  QVERIFY(find(haptic, "gain"));
  QVERIFY(!find(haptic, "turnDead"));
  QVERIFY(!find(haptic, "rateGain"));
  QCOMPARE(find(haptic, "clutch")->choices.size(), std::size_t(5));
  QCOMPARE(std::get<double>(find(haptic, "clutch")->value), 2.0);
  mapping.isRateControl = true;
  const auto pointing = mappingProperties(mapping, spaceMouseView().capabilities);
  QVERIFY(!find(pointing, "gain"));
  QVERIFY(find(pointing, "turnDead"));
  QVERIFY(find(pointing, "turnGain"));
}

void DevicePartsTest::bars() {
  AxisBars bars;
  bars.setDevice(falconView().capabilities);
  DeviceState state;
  state.position = {10.0, -80.0, kNaN};
  bars.showState(state);
  QCOMPARE(bars.text(), QString("X 10.0 mm, Y -80.0 mm, Z —"));
  QCOMPARE(bars.share(0), 0.25);
  QCOMPARE(bars.share(1), -1.0);
  QCOMPARE(bars.share(2), 0.0);
  bars.setWords({QStringLiteral("along (Z)"), QString()});
  QCOMPARE(bars.text(0), QString("X along (Z) 10.0 mm"));
  QCOMPARE(bars.text(1), QString("Y -80.0 mm"));
  bars.setWords({});
  QCOMPARE(bars.text(0), QString("X 10.0 mm"));
  DeviceCapabilities gripping;
  gripping.inputs = 7;
  bars.setDevice(gripping);
  QCOMPARE(bars.axes(), std::size_t(7));
  bars.showState(state);
  bars.resize(60, bars.sizeHint().height());
  bars.grab();  // also where there is no room
}

// The hand moves by the mouse and by keys, one axis at a time; buttons by their numbers. A device that somebody holds
// does not move.
void DevicePartsTest::theHandIsLed() {
  AxisBars bars;
  ButtonLamps lamps;
  DeviceInUse view = falconView();
  view.capabilities.inputs = 6;
  bars.setDevice(view.capabilities);
  bars.resize(400, bars.sizeHint().height());
  lamps.setCount(4);
  lamps.resize(200, 40);
  std::vector<HandPose> led;
  std::vector<int> pressed;
  connect(&bars, &AxisBars::handLed, this, [&](const HandPose& hand) { led.push_back(hand); });
  connect(&lamps, &ButtonLamps::toggled, this, [&](int button) { pressed.push_back(button); });
  const auto pull = [&bars](std::size_t axis, double share) {
    const QRectF bar = bars.barRect(axis);
    const QPointF at(bar.center().x() + 0.5 * share * bar.width(), bar.center().y());
    QTest::mouseClick(&bars, Qt::LeftButton, {}, at.toPoint());
  };
  pull(2, 0.5);
  QTest::mouseClick(&lamps, Qt::LeftButton, {}, lamps.lampRect(0).center());
  QVERIFY(led.empty() && pressed.empty());
  bars.setLed(true);
  lamps.setLed(true);
  HandPose hand;
  hand.position = {5.0, 0.0, 0.0};
  bars.showHand(hand);
  pull(2, 0.5);
  QVERIFY(std::abs(led.back().position.z() - 20.0) < 0.5 && led.back().position.x() == 5.0);  // half of 40 mm
  QTest::keyClick(&bars, Qt::Key_Home);
  QCOMPARE(led.back().position, Vec3(5.0, 0.0, 0.0));
  QTest::keyClick(&bars, Qt::Key_Up);
  QTest::keyClick(&bars, Qt::Key_Right);
  QTest::keyClick(&bars, Qt::Key_PageDown);
  QCOMPARE(led.back().position, Vec3(5.0, -9.0, 0.0));
  QTest::keyClick(&bars, Qt::Key_Left, Qt::ControlModifier);
  QCOMPARE(led.back().position, Vec3(5.0, -9.0, 0.0) + Vec3(0.0, -0.1, 0.0));
  QTest::keyClick(&bars, Qt::Key_Right, Qt::ControlModifier);
  // A click on the number chooses the axis, and does not throw the hand to the end.
  const std::size_t before = led.size();
  pull(0, 1.5);
  QCOMPARE(led.size(), before);
  QTest::keyClick(&bars, Qt::Key_PageUp);
  QVERIFY((led.back().position - Vec3(15.0, -9.0, 0.0)).norm() < 1e-9);
  pull(0, 1.0);
  QTest::keyClick(&bars, Qt::Key_PageUp);  // no further than it reaches
  QVERIFY((led.back().position - Vec3(40.0, -9.0, 0.0)).norm() < 1e-9);
  pull(5, 0.5);
  const Eigen::AngleAxisd turn(led.back().orientation);
  QVERIFY(std::abs(turn.angle() * turn.axis().z() / kRadiansPerDegree - 90.0) < 2.0);
  QTest::mouseClick(&lamps, Qt::LeftButton, {}, lamps.lampRect(2).center());
  QTest::keyClick(&lamps, Qt::Key_1);
  QTest::keyClick(&lamps, Qt::Key_5);  // there is none
  QCOMPARE(pressed, (std::vector<int>{2, 0}));
}

// A turn is shown as an angle about an axis, not above 180°: a turn by 350° is one by -10°.
void DevicePartsTest::turnsByTheSmallerAngle() {
  AxisBars bars;
  bars.setDevice(spaceMouseView().capabilities);
  DeviceState state;
  state.orientation = Eigen::AngleAxisd(350.0 * kRadiansPerDegree, Vec3(0, 1, 0));
  bars.showState(state);
  QCOMPARE(bars.text(4), QString("RY -10.0°"));
  state.orientation.coeffs() *= -1.0;  // the same turn
  bars.showState(state);
  QCOMPARE(bars.text(4), QString("RY -10.0°"));
  state.orientation.setIdentity();
  bars.showState(state);
  QCOMPARE(bars.text(4), QString("RY 0.0°"));
  state.orientation.coeffs().setConstant(kNaN);
  bars.showState(state);
  QCOMPARE(bars.text(4), QString("RY —"));
}

void DevicePartsTest::lamps() {
  ButtonLamps lamps;
  lamps.setCount(40);
  lamps.showButtons(0x80000001u);
  QCOMPARE(lamps.text(), QString("Held: 1, 32"));
  QVERIFY(lamps.heightForWidth(100) > lamps.heightForWidth(1000));
  lamps.resize(300, lamps.heightForWidth(300));
  const QImage held = lamps.grab().toImage();
  lamps.showButtons(0);
  QCOMPARE(lamps.text(), QString("No button is held"));
  QVERIFY(lamps.grab().toImage() != held);
  lamps.setCount(0);
  QVERIFY(lamps.isHidden());
  QCOMPARE(lamps.heightForWidth(100), 0);
}

HANDWHEEL_CONTROLS_TEST(DevicePartsTest)
#include "DevicePartsTest.moc"
