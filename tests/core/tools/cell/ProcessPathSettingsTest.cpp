// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ProcessPathSettings.h"

#include "../ToolEvents.h"
#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/RobotChanges.h"
#include "tools/cell/ProcessPathOperation.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const std::vector<std::string> kProcessEnds{"above", "home"};

double shownEnd(const OperationValues& values, std::string_view end) {
  const std::vector<Property> all = processPathSettings(values, kProcessEnds);
  return std::get<double>(propertyNamed(all, end)->value);
}

}  // namespace

// The settings of paths along curves, as the tool and the panel of a path show them.
class ProcessPathSettingsTest : public QObject {
  Q_OBJECT

 private slots:
  // A path ends at configurations of its own robot.
  void ends() {
    auto two = withRobotAdded(ArmCell().content(),
                              {cellOf(*libraryTable("ur5")), "second", poseOf({0, 3000, 0}, Vec3::Zero())});
    QVERIFY(two.hasValue());
    CellPlans plans;
    plans.configurations = {{"a", two->joints, ""}, {"b", two->joints, "second"}, {"c", two->joints, ""}};
    QCOMPARE(processEnds(*two->robot, plans), (std::vector<std::string>{"a", "c"}));
    plans.arm = "second";
    QCOMPARE(processEnds(*two->robot, plans), std::vector<std::string>{"b"});
  }

  // Nowhere else, where the robot is, or one of the configurations; a name that is none of these is nowhere.
  void endsShown() {
    OperationValues values(processPathOperation());
    QCOMPARE(shownEnd(values, "from"), 0.0);
    const std::pair<const char*, double> all[] = {{"here", 1.0}, {"above", 2.0}, {"home", 3.0}, {"gone", 0.0}};
    for (const auto& [name, shown] : all) {
      values.setValid("from", std::string(name));
      QCOMPARE(shownEnd(values, "from"), shown);
      QCOMPARE(shownEnd(values, "to"), 0.0);
    }
    const auto settings = processPathSettings(values, kProcessEnds);
    QCOMPARE(propertyNamed(settings, "to")->choices.size(), std::size_t{4});
    QCOMPARE(propertyNamed(settings, "to")->choices[3], std::string("home"));
  }

  // Any choice is shown as chosen.
  void endsTaken() {
    OperationValues values(processPathOperation());
    for (const double choice : {1.0, 2.0, 3.0, 0.0}) {
      takeProcessSetting(values, kProcessEnds, "to", choice);
      QCOMPARE(shownEnd(values, "to"), choice);
      QCOMPARE(values.isSet("to"), choice > 0.0);
    }
    takeProcessSetting(values, kProcessEnds, "to", 3.0);
    QCOMPARE(values.text("to"), std::string("home"));
    for (const double beyond : {4.0, -1.0}) {
      values.setValid("to", std::string("home"));
      takeProcessSetting(values, kProcessEnds, "to", beyond);
      QVERIFY(!values.isSet("to"));
    }
  }

  // The clearance is none until it is given; the other numbers have their standards.
  void numbers() {
    OperationValues values(processPathOperation());
    const auto shown = [&](const char* id) {
      const auto all = processPathSettings(values, kProcessEnds);
      return std::get<double>(propertyNamed(all, id)->value);
    };
    QCOMPARE(shown("clearance"), 0.0);
    QCOMPARE(shown("speed"), 50.0);
    takeProcessSetting(values, kProcessEnds, "clearance", 3.0);
    takeProcessSetting(values, kProcessEnds, "speed", 1e9);  // brought down to what can be
    QCOMPARE(shown("clearance"), 3.0);
    QCOMPARE(shown("speed"), 1e4);
  }

  // A path keeps its kind of curve, and says whose settings these are.
  void ofAPath() {
    const OperationValues values(processPathOperation());
    const auto all = settingsOfStoredPath(values, kProcessEnds);
    QCOMPARE(all.size() + 1, processPathSettings(values, kProcessEnds).size());
    QVERIFY(!propertyNamed(all, "along"));
    for (const Property& each : all) QCOMPARE(each.group, std::string("Process of the path"));
  }
};

HANDWHEEL_TEST(ProcessPathSettingsTest)
#include "ProcessPathSettingsTest.moc"
