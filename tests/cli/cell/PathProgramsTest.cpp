// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

// Programs of controllers without a window: written from paths, verified against them, and read as paths again.
class PathProgramsTest : public QObject {
  Q_OBJECT

 private slots:
  // Each controller's program is proven against the path, and is a path again.
  void programsOfControllers() {
    const PlannedCell cell;
    const Ran planned =
        cell.run({"plan", "cell.handwheel", "--from", "left", "--to", "right", "-o", "planned.handwheel"});
    QVERIFY2(planned.code == 0, planned.err);
    for (const auto& [controller, file] :
         {std::pair("rapid", "p.mod"), std::pair("krl", "p.src"), std::pair("fanuc", "p.ls"),
          std::pair("urscript", "p.script"), std::pair("csv", "p.csv")}) {
      const Ran ran = cell.run({"post", "planned.handwheel", "path", "--controller", controller, "-o", file, "--json"});
      QVERIFY2(ran.code == 0, ran.err);
      QVERIFY2(!ran.err.contains("QApplication"), ran.err);
      const nlohmann::json report = jsonOf(ran.out);
      QVERIFY(report["error_mm"].get<double>() <= 1e-3 && report["error_deg"].get<double>() <= 1e-3);
      const Ran verified = cell.run({"verify", "cell.handwheel", file});
      QVERIFY2(verified.code == 0, verified.out + verified.err);
    }
    cell.put("straight.json", R"({"waypoints": [[1.2, 0.5, 0, 0, 0, 0], [-1.2, 0.5, 0, 0, 0, 0]]})");
    const Ran refused = cell.run({"post", "cell.handwheel", "straight.json", "--controller", "krl", "-o", "no.src"});
    QCOMPARE(refused.code, 1);
    QVERIFY(refused.err.contains("box"));
    QVERIFY(cell.read("no.src").isEmpty());
  }

  // A line of 50 mm/s and a motion with 30 % come back as such from each language: each program is written from the one
  // before.
  void speedsComeBack() {
    const PlannedCell cell;
    cell.put("path.json", R"({"places": [
      {"joints": {"joint_1": 1.2, "joint_2": 0.5}, "name": "begin"},
      {"joints": {"joint_1": 1.2, "joint_2": 0.6}, "name": "end", "motion": "linear", "speed": 50},
      {"joints": {"joint_1": 1.0, "joint_2": 0.6}, "speed": 0.3}]})");
    QString from = "path.json";
    for (const auto& [controller, file] :
         {std::pair("rapid", "p.mod"), std::pair("krl", "p.src"), std::pair("fanuc", "p.ls"),
          std::pair("urscript", "p.script"), std::pair("csv", "p.csv"), std::pair("json", "p.program.json"),
          std::pair("csv", "again.csv")}) {
      const Ran ran = cell.run({"post", "cell.handwheel", from, "--controller", controller, "-o", file});
      QVERIFY2(ran.code == 0, ran.err);
      from = file;
    }
    const QList<QByteArray> rows = cell.rowsOf(from);
    QVERIFY2(rows.value(2).contains(",linear,50.000000,"), rows.value(2));
    QVERIFY2(rows.value(3).contains(",joint,0.300000,"), rows.value(3));
  }

  // A program is stored as a path of the cell, with its frame; opened again it finds that.
  void programsBecomePaths() {
    const PlannedCell cell;
    const QByteArray joints = ",[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0\\WObj:=jig;\n";
    cell.put(
        "seam.mod",
        "MODULE m\nPERS wobjdata jig:=[FALSE,TRUE,\"\",[[100,20,30],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\nPROC main()\n"
        "MoveAbsJ [[60,0,0,0,0,0]" +
            joints + "MoveAbsJ [[80,0,0,0,0,0]" + joints + "ENDPROC\nENDMODULE\n");
    const QStringList open{"configuration", "cell.handwheel", "--open", "seam.mod", "-o", "cell.handwheel"};
    const Ran first = cell.run(open);
    QVERIFY2(first.code == 0, first.err);
    QVERIFY2(first.out.contains("path seam, 2 places\n") && first.out.contains("frame jig\n"), first.out);
    const Ran verified = cell.run({"verify", "cell.handwheel", "seam", "--json"});
    QVERIFY2(verified.code == 0, verified.err);
    QCOMPARE(jsonOf(verified.out)["waypoints"].get<int>(), 2);
    QVERIFY(cell.run({"post", "cell.handwheel", "seam", "--controller", "rapid", "-o", "kept.mod"}).code == 0 &&
            cell.read("kept.mod").contains("! Clearance kept: 5 mm."));  // the robot has simplified shapes
    // The same program with less at its head is one that keeps less, and says so again when it is written.
    QByteArray less = cell.read("kept.mod");
    cell.put("less.mod", less.replace("Clearance kept: 5 mm", "Clearance kept: 0.5 mm"));
    const QStringList openLess{"configuration", "cell.handwheel", "--open", "less.mod", "-o", "less.handwheel"};
    QVERIFY(cell.run(openLess).code == 0);
    QCOMPARE(cell.run({"post", "less.handwheel", "less", "--controller", "krl", "-o", "less.src"}).code, 0);
    QVERIFY(cell.read("less.src").contains("; Clearance kept: 0.5 mm."));
    // Joint 1 turns by 20 degrees.
    QVERIFY(std::abs(jsonOf(verified.out)["length_rad"].get<double>() - M_PI / 9.0) < 1e-6);
    const nlohmann::json again = jsonOf(cell.run(open + QStringList{"--json"}).out);
    QCOMPARE(again["paths"].size(), std::size_t{2});
    QCOMPARE(again["paths"][1]["name"].get<std::string>(), std::string("seam 2"));
    QCOMPARE(again["frames"].size(), std::size_t{1});
    QVERIFY(again["frames_made"].empty());
    QCOMPARE(again["frames_used"][0].get<std::string>(), std::string("jig"));
    // A name that is given is that of the path, whatever was called so.
    const nlohmann::json named = jsonOf(cell.run(open + QStringList{"--name", "seam", "--json"}).out);
    QCOMPARE(named["paths"].size(), std::size_t{2});
    QCOMPARE(named["paths"][1]["name"].get<std::string>(), std::string("seam"));
    // A second module in this frame leaves its data to the first one.
    const QStringList post{"post", "cell.handwheel", "seam", "--frame", "jig", "-o", "second.mod", "--controller"};
    const Ran second = cell.run(post + QStringList{"rapid", "--without-wobjdata"});
    QVERIFY2(second.code == 0, second.err);
    QVERIFY(!cell.read("second.mod").contains("\n  PERS wobjdata"));
    QVERIFY(cell.read("second.mod").contains("\\WObj:=jig;"));
    QCOMPARE(cell.run(post + QStringList{"krl", "--without-wobjdata"}).code, 1);
    const Ran back =
        cell.run({"configuration", "cell.handwheel", "--open", "second.mod", "-o", "other.handwheel", "--json"});
    QVERIFY2(back.code == 0, back.err);
    QCOMPARE(jsonOf(back.out)["frames_used"][0].get<std::string>(), std::string("jig"));
    // A file that cannot be read leaves the cell unchanged.
    const QByteArray before = cell.read("cell.handwheel");
    cell.put("loop.mod", "MODULE m\nPROC main()\nMoveC p1,p2,v100,fine,tool0;\nENDPROC\nENDMODULE\n");
    for (const char* file : {"loop.mod", "none.mod"}) {
      const Ran refused = cell.run({"configuration", "cell.handwheel", "--open", file, "-o", "cell.handwheel"});
      QCOMPARE(refused.code, 1);
      QVERIFY2(refused.err.contains(file), refused.err);
    }
    QCOMPARE(cell.run(open + QStringList{"--name", "a\nb"}).code, 1);
    QCOMPARE(cell.run({"configuration", "cell.handwheel", "--name", "x", "--add", "x", "-o", "cell.handwheel"}).code,
             1);
    QVERIFY(cell.read("cell.handwheel") == before);
  }

  // MoveAbsJ with v100: the tool's centre point goes with 100 mm/s. With joint 1 it is 374 mm from the axis, which
  // turns by at most 250 degrees a second (data sheet of the IRB 120).
  void speedsOfTheTool() {
    const PlannedCell cell;
    cell.put("p.mod",
             "MODULE m\n PROC main()\n"
             "  MoveAbsJ [[60,0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n"
             "  MoveAbsJ [[80,0,0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n"
             " ENDPROC\nENDMODULE\n");
    const Ran ran = cell.run({"post", "cell.handwheel", "p.mod", "--controller", "csv", "-o", "p.csv"});
    QVERIFY2(ran.code == 0, ran.err);
    const double share = 100.0 / 374.0 / (250.0 * M_PI / 180.0);
    const double got = cell.rowsOf("p.csv").value(2).split(',').value(3).toDouble();
    QVERIFY2(std::abs(got - share) < 1e-3 * share, cell.read("p.csv"));
  }

  // An ABB robot does not understand KRL: written all the same, and said.
  void anotherMakersController() {
    const PlannedCell cell;
    cell.put("path.json", R"({"waypoints": [[1.2, 0.5, 0, 0, 0, 0], [1.0, 0.5, 0, 0, 0, 0]]})");
    for (const auto& [controller, isOther] :
         {std::pair("krl", true), std::pair("rapid", false), std::pair("csv", false)}) {
      const QStringList words{"post", "cell.handwheel", "path.json", "--controller", controller, "-o", "p.txt"};
      const auto warns = [](const Ran& of) { return of.err.contains("warning") && of.err.contains("ABB IRB 120"); };
      const Ran ran = cell.run(words + QStringList{"--json"});
      QCOMPARE(ran.code, 0);
      QCOMPARE(warns(ran), isOther);
      QCOMPARE(jsonOf(ran.out)["other_robot"].get<bool>(), isOther);
      if (isOther) QVERIFY(warns(cell.run(words)));
      if (!cell.read("p.txt").startsWith("motion,")) QVERIFY(cell.read("p.txt").contains("simplified shapes"));
    }
  }

  // Programs of controllers with six joints, for an arm with seven.
  void anotherNumberOfJoints() {
    const PlannedCell cell;
    nlohmann::json joints = nlohmann::json::array();
    for (int i = 0; i < 7; ++i)
      joints.push_back({{"name", "j" + std::to_string(i)}, {"a", 100}, {"alpha", 90}, {"lower", -90}, {"upper", 90}});
    cell.put("seven.dh.json", QByteArray::fromStdString(nlohmann::json{{"name", "seven"}, {"joints", joints}}.dump()));
    QCOMPARE(cell.run({"configuration", "seven.dh.json", "--add", "a", "-o", "seven.handwheel"}).code, 0);
    cell.put("p.script", "def p():\n  movej([0,0,0,0,0,0])\nend\n");
    cell.put("p.src", "DEF p()\nPTP {A1 0,A2 0,A3 0,A4 0,A5 0,A6 0}\nEND\n");
    for (const char* file : {"p.script", "p.src"}) {
      const Ran ran = cell.run({"verify", "seven.handwheel", file});
      QCOMPARE(ran.code, 1);
      QVERIFY2(ran.err.contains("6") && ran.err.contains("7"), ran.err);
    }
  }
};

HANDWHEEL_TEST(PathProgramsTest)
#include "PathProgramsTest.moc"
