// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

// A path file: joint 1 comes to these values (rad), along straight lines of the tool. bent: joint 5, rad.
QByteArray lineThrough(std::initializer_list<double> values, double bent) {
  nlohmann::json waypoints = nlohmann::json::array();
  for (const double value : values) {
    nlohmann::json waypoint;
    waypoint["joints"]["joint_1"] = value;
    waypoint["joints"]["joint_2"] = 0.5;
    waypoint["joints"]["joint_5"] = bent;
    if (!waypoints.empty()) waypoint["motion"] = "linear";
    waypoints.push_back(waypoint);
  }
  nlohmann::json path;
  path["places"] = waypoints;
  return QByteArray::fromStdString(path.dump());
}

}  // namespace

// Output of the command "verify" for paths that are not free.
class VerificationTest : public QObject {
  Q_OBJECT

 private slots:
  // A program with another tool than the cell, which has none, is verified with its own. Where it is opened in the cell
  // the remark has both.
  void theToolOfAProgram() {
    const PlannedCell cell;
    const auto program = [](const QByteArray& tool) -> QByteArray {
      const QByteArray joints = ",0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine," + tool + ";\n";
      return "MODULE m\nPERS tooldata grip:=[TRUE,[[0,0,150],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\nPROC main()\n"
             "MoveAbsJ [[60" +
             joints + "MoveAbsJ [[80" + joints + "ENDPROC\nENDMODULE\n";
    };
    cell.put("grip.mod", program("grip"));
    cell.put("none.mod", program("tool0"));
    const QByteArray both = "at 0, 0, 150 mm, that of the cell at 0, 0, 0 mm";
    const Ran grip = cell.run({"verify", "cell.handwheel", "grip.mod"});
    QVERIFY2(grip.code == 0 && grip.err.contains("warning: The tool centre point is that of the program, 0, 0, 150 mm"),
             grip.err);
    const Ran none = cell.run({"verify", "cell.handwheel", "none.mod"});
    QVERIFY2(none.code == 0 && !none.err.contains("centre point of the program"), none.err);
    const auto remarksOn = [&](const char* file) {
      const Ran opened = cell.run({"configuration", "cell.handwheel", "--open", file, "-o", "o.handwheel", "--json"});
      return jsonOf(opened.out)["remarks"];
    };
    QCOMPARE(remarksOn("grip.mod").size(), std::size_t{1});
    QVERIFY(remarksOn("grip.mod")[0].get<std::string>().find(both.toStdString()) != std::string::npos);
    QVERIFY(remarksOn("none.mod").empty());
  }

  // The tool is led through the box, about 440 mm before the base, with the wrist bent all the time. Along a straight
  // line, which short motions follow, what meets without a break is one collision: as many as the text has lines.
  void collisionsAlongALine() {
    const PlannedCell cell;
    cell.put("line.json", lineThrough({0.4, -0.4, 0.4}, 0.3));
    const QByteArray text = cell.run({"verify", "cell.handwheel", "line.json"}).out;
    const nlohmann::json report = jsonOf(cell.run({"verify", "cell.handwheel", "line.json", "--json"}).out);
    QVERIFY(!report["collisions"].empty());
    QCOMPARE(text.count("motion to place"), static_cast<qsizetype>(report["collisions"].size()));
    for (const nlohmann::json& each : report["collisions"]) {
      const double from = each["from"].get<double>(), to = each["to"].get<double>();
      QVERIFY(from >= 0.0 && from <= to && to <= 1.0);
      const QByteArray waypoint = QByteArray::number(each["place"].get<int>() + 1);
      QVERIFY(text.contains("motion to place " + waypoint + ", "));
    }
  }

  // Nearer than the clearance is no collision: `plan` says how near it is.
  void tooNearToPlan() {
    const PlannedCell cell;
    const Ran ran = cell.run({"plan", "cell.handwheel", "--from", "left", "--to", "right", "--clearance", "390"});
    QCOMPARE(ran.code, 2);
    QVERIFY2(ran.err.contains("too near") && ran.err.contains("box") && !ran.err.contains("collides"), ran.err);
  }

  // At its limit joint 1 cannot continue, as the straight line requires, and with the arm stretched in a plane no other
  // joint moves the tool out of that: the line is not begun. Collisions there are listed with the first waypoint.
  void aLineThatCannotBeBegun() {
    const PlannedCell cell;
    cell.run({"body", "cell.handwheel", "--add", "box:400,600,1200", "--at", "-450,0,400", "-o", "cell.handwheel"});
    constexpr double kLimit = 165.0 * M_PI / 180.0;
    cell.put("line.json", lineThrough({kLimit, -kLimit}, 0.0));
    const Ran ran = cell.run({"verify", "cell.handwheel", "line.json", "--json"});
    QCOMPARE(ran.code, 2);
    const nlohmann::json report = jsonOf(ran.out);
    QCOMPARE(report["stops_at"]["place"].get<int>(), 1);
    QCOMPARE(report["stops_at"]["share"].get<double>(), 0.0);
    QVERIFY(!report["collisions"].empty());
    for (const nlohmann::json& each : report["collisions"]) QCOMPARE(each["place"].get<int>(), 0);
  }
};

HANDWHEEL_TEST(VerificationTest)
#include "VerificationTest.moc"
