// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HandLathe.h"
#include "TestClass.h"
#include "machining/force/CuttingFeel.h"

#include <QtTest>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

struct LatheSettingRow {
  const char* id;
  double asked, expected;
  std::function<double(const LatheSetup&)> of;
};

// A value within the limits, and one beyond each end of them.
const std::vector<LatheSettingRow>& numbersOfTheLathe() {
  static const std::vector<LatheSettingRow> kRows = {
      {"depth_limit", 1.5, 1.5, [](const LatheSetup& l) { return l.depthLimit; }},
      {"depth_limit", 500.0, 100.0, [](const LatheSetup& l) { return l.depthLimit; }},
      {"power", 5.5, 5.5, [](const LatheSetup& l) { return l.spindle.power; }},
      {"power", -1.0, 0.0, [](const LatheSetup& l) { return l.spindle.power; }},
      {"torque", 60.0, 60.0, [](const LatheSetup& l) { return l.spindle.torque; }},
      {"torque", 1e4, 1e3, [](const LatheSetup& l) { return l.spindle.torque; }},
      {"wear", 0.3, 0.3, [](const LatheSetup& l) { return l.wear; }},
      {"wear", 3.0, CuttingFeel::kMostWear, [](const LatheSetup& l) { return l.wear; }},
      {"compound_angle", 30.0, 30.0, [](const LatheSetup& l) { return l.compoundAngle; }},
      {"compound_angle", -200.0, -90.0, [](const LatheSetup& l) { return l.compoundAngle; }},
      {"grip", 35.0, 35.0, [](const LatheSetup& l) { return l.chuck.grip; }},
      {"grip", -3.0, 0.0, [](const LatheSetup& l) { return l.chuck.grip; }},
      {"tailstock", 180.0, 180.0, [](const LatheSetup& l) { return l.tailstock.position; }},
      {"tailstock", 1e9, 1e4, [](const LatheSetup& l) { return l.tailstock.position; }}};
  return kRows;
}

PropertyValue shownSetting(const ManualLatheTool& tool, const std::string& id) {
  for (const Property& property : tool.settings())
    if (property.id == id) return property.value;
  return std::string("there is no such setting");
}

}  // namespace

// The lathe is set up by the settings of its tool: each change is a step of the document, which undo takes back.
class ManualLatheSettingsTest : public QObject {
  Q_OBJECT

 private slots:
  // In work on an exercise the machine is the teacher's: its motor, its jaws, its wear. How the student reads it, and
  // sets its slides, is free. A drill may be mounted only if it is one of the tools of the exercise.
  void theMachineOfAnExercise() {
    HandLathe lathe;
    const auto nothing = std::make_shared<const nlohmann::json>(nlohmann::json::object());
    lathe.document.assign(AssignedExercise{nothing, nothing}, false);
    const LatheSetup before = lathe.tool->setup();
    for (const char* const id : {"power", "torque", "wear", "backlash", "grip"}) lathe.runner.setSetting(id, 0.7);
    lathe.runner.setSetting("grips_inside", true);
    QVERIFY(lathe.tool->setup() == before);
    int fixed = 0;
    for (const Property& property : lathe.tool->settings()) fixed += property.editable ? 0 : 1;
    QCOMPARE(fixed, 6);
    lathe.runner.setSetting("compound_angle", 5.0);
    QCOMPARE(lathe.tool->setup().compoundAngle, 5.0);
    LatheSetup few = lathe.tool->setup();
    few.allowed = {"right-roughing"};
    QVERIFY(lathe.tool->setUp(few, "Set up"));
    lathe.runner.setSetting("fitting", 2.0);
    QVERIFY(lathe.tool->setup().tailstock.fitting == LatheFitting::None);
    few.allowed.push_back("drill-6");
    QVERIFY(lathe.tool->setUp(few, "Set up"));
    lathe.runner.setSetting("fitting", 2.0);
    QCOMPARE(lathe.tool->setup().tailstock.drill, std::string("drill-6"));
  }

  void numbersAreBroughtIntoTheirLimits() {
    for (const LatheSettingRow& row : numbersOfTheLathe()) {
      HandLathe lathe;
      const LatheSetup before = lathe.tool->setup();
      lathe.runner.setSetting(row.id, row.asked);
      QCOMPARE(row.of(lathe.tool->setup()), row.expected);
      QVERIFY2(shownSetting(*lathe.tool, row.id) == PropertyValue(row.expected), row.id);
      QCOMPARE(lathe.document.history()->count(), 1);
      lathe.undo();
      QVERIFY2(lathe.tool->setup() == before, row.id);
    }
  }

  // All wheels get the same play; the dial of the cross slide shows it.
  void backlashIsThatOfAllDials() {
    HandLathe lathe;
    lathe.runner.setSetting("backlash", 0.15);
    for (const LatheDial& dial : lathe.tool->setup().dials) QCOMPARE(dial.backlash, 0.15);
    QVERIFY(shownSetting(*lathe.tool, "backlash") == PropertyValue(0.15));
    lathe.runner.setSetting("backlash", 5.0);
    for (const LatheDial& dial : lathe.tool->setup().dials) QCOMPARE(dial.backlash, 2.0);
  }

  void switches() {
    HandLathe lathe;
    lathe.runner.setSetting("grips_inside", true);
    QVERIFY(lathe.tool->setup().chuck.gripsInside);
    lathe.runner.setSetting("shows_diameter", false);
    QVERIFY(!lathe.tool->setup().showsDiameter && lathe.tool->setup().chuck.gripsInside);
    QCOMPARE(lathe.document.history()->count(), 2);
    // Chips are a matter of display: no step of the document.
    lathe.runner.setSetting("chips", false);
    QVERIFY(shownSetting(*lathe.tool, "chips") == PropertyValue(false));
    QCOMPARE(lathe.document.history()->count(), 2);
  }

  // Without a mounted drill one of 10 mm is taken; a mounted one stays.
  void theTailstockTakesADrill() {
    HandLathe lathe;
    lathe.runner.setSetting("fitting", 1.0);
    QVERIFY(lathe.tool->setup().tailstock.fitting == LatheFitting::Centre);
    QVERIFY(lathe.tool->setup().tailstock.drill.empty());
    lathe.runner.setSetting("fitting", 2.0);
    QVERIFY(lathe.tool->setup().tailstock.fitting == LatheFitting::Drill);
    QCOMPARE(lathe.tool->setup().tailstock.drill, std::string("drill-10"));
    QVERIFY(!lathe.tool->mount(0, "drill-12"));
    lathe.runner.setSetting("fitting", 0.0);
    QVERIFY(!lathe.tool->setup().tailstock.isUsed());
    lathe.runner.setSetting("fitting", 2.0);
    QCOMPARE(lathe.tool->setup().tailstock.drill, std::string("drill-12"));
  }

  // An invalid or unchanged value of a setting changes nothing and leaves no step.
  void whatIsNoValueChangesNothing() {
    HandLathe lathe;
    const LatheSetup before = lathe.tool->setup();
    const std::pair<const char*, PropertyValue> kWrong[] = {{"grip", std::string("20")},
                                                            {"grip", std::numeric_limits<double>::quiet_NaN()},
                                                            {"grips_inside", 1.0},
                                                            {"fitting", 3.0},
                                                            {"fitting", -1.0},
                                                            {"spoon", 1.0},
                                                            {"chips", 1.0},
                                                            {"backlash", true},
                                                            {"power", before.spindle.power}};
    for (const auto& [id, value] : kWrong) lathe.runner.setSetting(id, value);
    QVERIFY(lathe.tool->setup() == before);
    QVERIFY(shownSetting(*lathe.tool, "chips") == PropertyValue(true));
    QCOMPARE(lathe.document.history()->count(), 0);
    LatheSetup impossible = before;
    impossible.stations.clear();
    QVERIFY(!lathe.tool->setUp(impossible, "Set up") && lathe.tool->setup() == before);
  }

  // They are the document's, so that no other document gets them.
  void settingsStayWithTheDocument() {
    HandLathe lathe, other;
    lathe.runner.setSetting("compound_angle", 45.0);
    QVERIFY(!lathe.tool->remembersSettings());
    QCOMPARE(lathe.document.workpiece().lathe->compoundAngle, 45.0);
    QVERIFY(shownSetting(*other.tool, "compound_angle") == PropertyValue(0.0));
    QCOMPARE(lathe.tool->id(), std::string("lathe"));
    QCOMPARE(lathe.tool->needs(), std::vector<std::string>{"simulation"});
  }
};

HANDWHEEL_TEST(ManualLatheSettingsTest)
#include "ManualLatheSettingsTest.moc"
