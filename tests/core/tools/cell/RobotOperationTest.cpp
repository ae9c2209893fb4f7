// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/RobotOperation.h"

#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

OperationValues robotValues(const std::vector<std::pair<const char*, std::string>>& words) {
  OperationValues values(robotOperation());
  for (const auto& [id, word] : words) values.setValid(id, word);
  return values;
}

}  // namespace

// Robots are added to a cell, removed, and chosen.
class RobotOperationTest : public QObject {
  Q_OBJECT

 private slots:
  void valuesThatFitTogether() {
    for (const auto& values : {robotValues({{"add", "ur5"}, {"name", "left"}, {"at", "1,2,3"}, {"turn", "0,0,1"}}),
                               robotValues({{"remove", "left"}}), robotValues({{"choose", "left"}})})
      QCOMPARE(problemOfRobotValues(values), std::string());
    for (const auto& values : {robotValues({}), robotValues({{"add", "ur5"}, {"remove", "left"}}),
                               robotValues({{"remove", "left"}, {"choose", "left"}})})
      QCOMPARE(problemOfRobotValues(values), std::string("one of add, remove and choose is needed"));
    for (const auto& [id, word] : {std::pair("name", "right"), std::pair("at", "1,2,3"), std::pair("turn", "0,0,1")})
      QCOMPARE(problemOfRobotValues(robotValues({{"choose", "left"}, {id, word}})),
               std::string("name, at and turn need add"));
  }

  // A quarter turn about z and 1.5 m to the side: its x axis points along the y axis of the first robot.
  void added() {
    OperationValues values = robotValues({{"add", "ur5"}, {"name", "left"}});
    values.setValid("at", std::vector<double>{100.0, 1500.0, -20.0});
    values.setValid("turn", std::vector<double>{0.0, 0.0, 0.5 * M_PI});
    const auto two = changed(values, ArmCell().content());
    QCOMPARE(two.robot->arms.size(), std::size_t{2});
    QCOMPARE(two.robot->arms[1].name, std::string("left"));
    const Pose base = basePose(two.robot->model, two.robot->arms[1]);
    QVERIFY((base * Vec3(10.0, 0.0, 1.0) - Vec3(100.0, 1510.0, -19.0)).norm() < 1e-6);
    // Without a name it has that of its description, without a pose it is at the first robot.
    const auto plain = changed(robotValues({{"add", "ur5"}}), ArmCell().content());
    QVERIFY(!plain.robot->arms[1].name.empty());
    QVERIFY(basePose(plain.robot->model, plain.robot->arms[1]).isApprox(Pose::Identity(), 1e-9));
  }

  void chosenAndRemoved() {
    const RobotCellSnapshot two = changed(robotValues({{"add", "ur5"}, {"name", "left"}}), ArmCell().content());
    const std::string first = two.robot->arms[0].name;
    QCOMPARE(activeArm(*two.robot, *two.plans).name, first);
    const RobotCellSnapshot chosen = changed(robotValues({{"choose", "left"}}), two);
    QCOMPARE(activeArm(*chosen.robot, *chosen.plans).name, std::string("left"));
    QVERIFY(chosen.robot == two.robot && chosen.joints == two.joints);
    const RobotCellSnapshot back = changed(robotValues({{"choose", first}}), chosen);
    QCOMPARE(activeArm(*back.robot, *back.plans).name, first);
    const RobotCellSnapshot rest = changed(robotValues({{"remove", "left"}}), chosen);
    QCOMPARE(rest.robot->arms.size(), std::size_t{1});
    QCOMPARE(activeArm(*rest.robot, *rest.plans).name, first);
    QVERIFY(withRobotsChanged(robotValues({{"remove", first}}), rest, {}).error().code == CellError::OnlyRobot);
  }

  void robotsThatAreMissing() {
    const RobotCellSnapshot cell = ArmCell().content();
    for (const char* const verb : {"remove", "choose"}) {
      const auto missing = withRobotsChanged(robotValues({{verb, "right"}}), cell, {});
      QVERIFY(!missing && missing.error().code == CellError::ArmMissing);
      QCOMPARE(missing.error().arguments, std::vector<std::string>{"right"});
    }
  }

 private:
  static RobotCellSnapshot changed(const OperationValues& values, const RobotCellSnapshot& cell) {
    auto made = withRobotsChanged(values, cell, values.isSet("add") ? cellOf(*libraryTable("ur5")) : nullptr);
    if (!made) qFatal("refused: %s", made.error().code->id);
    return std::move(made).value();
  }
};

HANDWHEEL_TEST(RobotOperationTest)
#include "RobotOperationTest.moc"
