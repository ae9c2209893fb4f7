// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>
#include <array>
#include <cmath>
#include <set>

using namespace handwheel;

// A planner's work without a window: configurations, a path that is proven free, its verification.
class PlanTest : public QObject {
  Q_OBJECT

 private slots:
  void aroundABox() {
    const PlannedCell cell;
    const Ran ran = cell.run({"plan", "cell.handwheel", "--from", "left", "--to", "right", "--clearance", "10", "-o",
                              "path.json", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json report = jsonOf(ran.out);
    QVERIFY(report["solved"].get<bool>() && report["certified"].get<bool>());
    QVERIFY(report["min_clearance_mm"].get<double>() >= 10.0);
    QVERIFY(report["length_rad"].get<double>() > 2.4);  // straight it would be 2.4
    for (const char* key : {"seconds", "waypoints", "manipulability", "security_mm"}) QVERIFY(report.contains(key));
    const nlohmann::json path = jsonOf(cell.read("path.json"));
    QVERIFY(path["certified"].get<bool>());
    QVERIFY(path["waypoints"].size() > 2);
    QCOMPARE(path["waypoints"].front()[0].get<double>(), 1.2);
    QCOMPARE(path["waypoints"].back()[0].get<double>(), -1.2);
    const Ran verified = cell.run({"verify", "cell.handwheel", "path.json", "--clearance", "10", "--json"});
    QVERIFY2(verified.code == 0, verified.out);
    QVERIFY(jsonOf(verified.out)["certified"].get<bool>());
  }

  // The clearance that a path was planned with stays with it: in its file, in the cell, for verification and programs.
  void clearanceStaysWithThePath() {
    const PlannedCell cell;
    const Ran planned = cell.run({"plan", "cell.handwheel", "--from", "left", "--to", "right", "--clearance", "10",
                                  "--name", "way", "-o", "cell.handwheel"});
    QVERIFY2(planned.code == 0, planned.err);
    QCOMPARE(cell.run({"verify", "cell.handwheel", "way"}).code, 0);
    const Ran set = cell.run({"set", "cell.handwheel", "path.way.clearance=2000", "-o", "cell.handwheel"});
    QVERIFY2(set.code == 0, set.err);
    QCOMPARE(cell.run({"verify", "cell.handwheel", "way"}).code, 2);  // the box is nearer than 2 m
    QCOMPARE(cell.run({"verify", "cell.handwheel", "way", "--clearance", "10"}).code, 0);
    QVERIFY(cell.run({"post", "cell.handwheel", "way", "--controller", "rapid", "-o", "way.mod"}).code != 0);
  }

  // The straight line is not free; all of it is tested.
  void straightThroughABox() {
    const PlannedCell cell;
    cell.put("straight.json",
             R"({"waypoints": [[1.2, 0.5, 0, 0, 0, 0], [-1.2, 0.5, 0, 0, 0, 0], [1.2, 0.5, 0, 0, 0, 0]]})");
    const Ran ran = cell.run({"verify", "cell.handwheel", "straight.json", "--json"});
    QCOMPARE(ran.code, 2);
    const nlohmann::json report = jsonOf(ran.out);
    QVERIFY(!report["certified"].get<bool>());
    QCOMPARE(report["collisions"].front()["with"].get<std::string>(), std::string("box"));
    QCOMPARE(report["collisions"].front()["place"].get<int>(), 1);
    QCOMPARE(report["collisions"].back()["place"].get<int>(), 2);
    for (const nlohmann::json& collision : report["collisions"]) {
      const nlohmann::json& contacts = collision["contacts"];
      QVERIFY(!contacts.empty() && contacts.size() <= collision["contacts_found"].get<std::size_t>());
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        const double distance = contacts[i]["distance_mm"].get<double>();
        QVERIFY(distance < 1e-6 && (i == 0 || distance >= contacts[i - 1]["distance_mm"].get<double>()));
        QCOMPARE(contacts[i]["at_mm"].size(), std::size_t{3});
        QCOMPARE(contacts[i]["normal"].size(), std::size_t{3});
      }
    }
    QCOMPARE(report["min_clearance_mm"].get<double>(), 0.0);
  }

  // A fixture whose origin is 400, 50, 10 mm from the base, turned by 90° about z: by numbers, with a target, chosen
  // for programs.
  void frames() {
    const PlannedCell cell;
    const auto change = [&](const QStringList& words) {
      const Ran ran =
          cell.run(QStringList{"configuration", "cell.handwheel"} + words + QStringList{"-o", "cell.handwheel"});
      return ran.code == 0 ? ran.out : ran.err;
    };
    const QByteArray added = change({"--add-frame", "fixture", "--at", "400,50,10", "--turn", "0,0,90"});
    QVERIFY2(added.contains("frame fixture"), added);
    change({"--add-target", "drop", "--in", "fixture", "--at", "-250,200,500", "--turn", "160,20,0"});
    const auto described = [&] { return jsonOf(cell.run({"inspect", "cell.handwheel", "--json"}).out)["document"]; };
    QCOMPARE(described()["frames"][0]["name"].get<std::string>(), std::string("fixture"));
    QVERIFY(described()["frames"][0]["link"].is_null() && !described()["frames"][0]["chosen"].get<bool>());
    QCOMPARE(described()["targets"][0]["frame"].get<std::string>(), std::string("fixture"));
    // Between them lie -650, 150, 490 mm: the frame measures 150 mm along its x and 650 mm along its y.
    QVERIFY(std::abs(described()["targets"][0]["position"][0].get<double>() - 150.0) < 1e-6);
    QVERIFY(std::abs(described()["targets"][0]["position"][1].get<double>() - 650.0) < 1e-6);

    cell.put("short.json", R"({"waypoints": [[1.2, 0.5, 0, 0, 0, 0], [1.4, 0.5, 0, 0, 0, 0]]})");
    const auto posted = [&](const QStringList& words) {
      const Ran ran =
          cell.run(QStringList{"post", "cell.handwheel", "short.json", "--controller", "csv", "-o", "p.csv"} + words);
      return ran.code == 0 ? cell.read("p.csv") : ran.err;
    };
    const auto position = [](const QByteArray& csv) {  // Position of the last motion
      const QList<QByteArray> fields = csv.trimmed().split('\n').back().split(',');
      const qsizetype at = fields.size() - 7;
      return std::array{fields[at].toDouble(), fields[at + 1].toDouble(), fields[at + 2].toDouble()};
    };
    const QByteArray plain = posted({}), framed = posted({"--frame", "fixture"});
    QVERIFY2(!plain.contains("frame") && framed.contains("# frame,fixture,400.0"), framed);
    const auto inBase = position(plain), inFrame = position(framed);
    QVERIFY(std::abs(inBase[0] - (400.0 - inFrame[1])) < 1e-5 && std::abs(inBase[1] - (50.0 + inFrame[0])) < 1e-5 &&
            std::abs(inBase[2] - (10.0 + inFrame[2])) < 1e-5);
    QCOMPARE(cell.run({"set", "cell.handwheel", "frame=fixture", "-o", "cell.handwheel"}).code, 0);
    QVERIFY(described()["frames"][0]["chosen"].get<bool>());
    QCOMPARE(posted({}), framed);
    QCOMPARE(posted({"--frame", "base"}), plain);
    QVERIFY(posted({"--frame", "other"}).contains("other"));
    const std::string link = described()["tool"]["link"];
    change({"--add-frame", "gripped", "--link", QString::fromStdString(link)});
    const QByteArray moving = posted({"--frame", "gripped"});
    QVERIFY2(moving.contains("moves the frame 'gripped'"), moving);
    change({"--remove-frame", "fixture"});
    QCOMPARE(posted({}), plain);
    QVERIFY(described()["targets"][0]["frame"].is_null());
    QVERIFY(std::abs(described()["targets"][0]["position"][0].get<double>() + 250.0) < 1e-6);
  }

  // Along an edge of a block, coming from a configuration and going back there; the tool's centre point is where the
  // edge is, 2 mm away from it.
  void alongAnEdge() {
    const PlannedCell cell;
    cell.run({"configuration", "irb120", "--add", "home", "--joints", "joint_2=0.2,joint_5=0.6", "-o", "c.handwheel"});
    cell.run({"body", "c.handwheel", "--add", "box:120,200,100", "--at", "420,0,50", "--name", "block", "-o",
              "c.handwheel"});
    const QStringList edge{"process", "c.handwheel", "--part", "block", "--near", "360,0,100", "--free"};
    const Ran ran = cell.run(edge + QStringList{"--standoff", "2", "--from", "home", "--to", "home", "--name", "deburr",
                                                "-o", "c.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json report = jsonOf(ran.out);
    QVERIFY(report["certified"].get<bool>());
    QVERIFY(report["min_clearance_mm"].get<double>() > 0.0);
    QCOMPARE(cell.run({"verify", "c.handwheel", "deburr"}).code, 0);
    QCOMPARE(cell.run({"post", "c.handwheel", "deburr", "--controller", "csv", "-o", "deburr.csv"}).code, 0);
    // Two of the waypoints are beside the ends of the edge: 2 mm from x 360, z 100 at y ±100.
    int ends = 0;
    for (const QByteArray& line : cell.rowsOf("deburr.csv")) {
      const QList<QByteArray> words = line.split(',');
      for (qsizetype i = 0; i + 2 < words.size(); ++i) {
        const double away = std::hypot(words[i].toDouble() - 360.0, words[i + 2].toDouble() - 100.0);
        ends += std::abs(away - 2.0) < 0.01 && std::abs(std::abs(words[i + 1].toDouble()) - 100.0) < 0.01 ? 1 : 0;
      }
    }
    QCOMPARE(ends, 2);
    const Ran touching = cell.run(edge + QStringList{"--standoff", "-5", "--json"});
    QCOMPARE(touching.code, 2);
    QVERIFY(!jsonOf(touching.out)["solved"].get<bool>());
    QVERIFY2(touching.err.contains("collides") && touching.err.contains("block"), touching.err);
    QCOMPARE(cell.run({"process", "c.handwheel", "--part", "block", "--near", "3000,0,0", "--along", "x"}).code, 1);
    QCOMPARE(cell.run({"process", "c.handwheel", "--part", "nothing", "--near", "1,0,0"}).code, 1);
    QCOMPARE(cell.run({"process", "c.handwheel", "--part", "block"}).code, 1);
  }

  // The part of a path was moved: the tool would not meet its edge any more. Who wants the program all the same says
  // so, and it says it, too.
  void anOutdatedPath() {
    const PlannedCell cell;
    cell.run({"configuration", "irb120", "--add", "home", "--joints", "joint_2=0.2,joint_5=0.6", "-o", "c.handwheel"});
    cell.run({"body", "c.handwheel", "--add", "box:120,200,100", "--at", "420,0,50", "--name", "block", "-o",
              "c.handwheel"});
    const Ran planned = cell.run({"process", "c.handwheel", "--part", "block", "--near", "360,0,100", "--free",
                                  "--standoff", "2", "--name", "deburr", "-o", "c.handwheel"});
    QVERIFY2(planned.code == 0, planned.err);
    const QStringList post{"post", "c.handwheel", "deburr", "--controller", "rapid", "-o", "deburr.mod"};
    QCOMPARE(cell.run(post).code, 0);
    QVERIFY(!cell.read("deburr.mod").contains("Outdated"));
    cell.put("deburr.mod", "before");
    cell.run({"set", "c.handwheel", "body.block.x=430", "-o", "c.handwheel"});
    const Ran refused = cell.run(post);
    QCOMPARE(refused.code, 1);
    QVERIFY2(refused.err.contains("block") && refused.err.contains("--outdated"), refused.err);
    QCOMPARE(cell.read("deburr.mod"), QByteArray("before"));
    const Ran written = cell.run(post + QStringList{"--outdated", "--json"});
    QVERIFY2(written.code == 0, written.err);
    QVERIFY2(written.err.contains("block"), written.err);
    QVERIFY(jsonOf(written.out)["outdated"].get<bool>());
    QVERIFY2(cell.read("deburr.mod").contains("! Outdated: the part block has moved"), cell.read("deburr.mod"));
  }

  // The same of a path to a target that was moved, and of one along a curve whose tool is another one now; `verify` and
  // `inspect` say it, too.
  void anOutdatedTargetAndTool() {
    const PlannedCell cell;
    cell.run({"configuration", "irb120", "--add", "home", "--joints", "joint_2=0.2,joint_5=0.6", "-o", "c.handwheel"});
    cell.run({"configuration", "c.handwheel", "--at", "400,100,300", "--turn", "180,0,0", "--add-target", "drop", "-o",
              "c.handwheel"});
    const Ran planned =
        cell.run({"plan", "c.handwheel", "--from", "home", "--to", "drop", "--name", "reach", "-o", "c.handwheel"});
    QVERIFY2(planned.code == 0, planned.err);
    const auto inspected = [&] {
      return jsonOf(cell.run({"inspect", "c.handwheel", "--json"}).out)["document"]["paths"][0];
    };
    const QStringList post{"post", "c.handwheel", "reach", "--controller", "rapid", "-o", "reach.mod"};
    QCOMPARE(cell.run(post).code, 0);
    const char* const kOther = "not the language of the controller";
    QVERIFY(!cell.read("reach.mod").contains(kOther));
    QCOMPARE(cell.run({"post", "c.handwheel", "reach", "--controller", "krl", "-o", "reach.src"}).code, 0);
    QVERIFY2(cell.read("reach.src").contains(kOther), cell.read("reach.src"));
    QVERIFY(!inspected()["outdated"].get<bool>());
    QVERIFY(!cell.read("reach.mod").contains("Outdated"));
    cell.run({"set", "c.handwheel", "target.drop.x=390", "-o", "c.handwheel"});
    QVERIFY(inspected()["outdated"].get<bool>());
    QCOMPARE(inspected()["targets_moved"][0].get<std::string>(), std::string("drop"));
    const Ran verified = cell.run({"verify", "c.handwheel", "reach"});
    QVERIFY2(verified.out.contains("drop") && verified.out.contains("plan it again"), verified.out);
    QVERIFY(jsonOf(cell.run({"verify", "c.handwheel", "reach", "--json"}).out)["outdated"].get<bool>());
    const Ran refused = cell.run(post);
    QCOMPARE(refused.code, 1);
    QVERIFY2(refused.err.contains("drop") && refused.err.contains("--outdated"), refused.err);
    const Ran written = cell.run(post + QStringList{"--outdated", "--json"});
    QVERIFY2(written.code == 0 && written.err.contains("drop"), written.err);
    QVERIFY2(cell.read("reach.mod").contains("! Outdated: the tool does not come to the target drop"),
             cell.read("reach.mod"));
    cell.run({"body", "c.handwheel", "--add", "box:120,200,100", "--at", "420,0,50", "--name", "block", "-o",
              "b.handwheel"});
    const Ran process = cell.run({"process", "b.handwheel", "--part", "block", "--near", "360,0,100", "--free",
                                  "--standoff", "2", "--name", "deburr", "-o", "b.handwheel"});
    QVERIFY2(process.code == 0, process.err);
    cell.run({"set", "b.handwheel", "tcp.z=-1", "-o", "b.handwheel"});
    const Ran other = cell.run({"post", "b.handwheel", "deburr", "--controller", "rapid", "-o", "deburr.mod"});
    QCOMPARE(other.code, 1);
    QVERIFY2(other.err.contains("tool centre point") && other.err.contains("--outdated"), other.err);
  }

  // On the top of a block, with a bend, 5 mm above it.
  void alongADrawnCurve() {
    const PlannedCell cell;
    cell.run({"configuration", "irb120", "--add", "home", "--joints", "joint_5=0.6", "-o", "c.handwheel"});
    cell.run({"body", "c.handwheel", "--add", "box:120,200,100", "--at", "420,0,50", "--name", "block", "-o",
              "c.handwheel"});
    const QStringList words{"process", "c.handwheel", "--part", "block", "--near", "380,-60,100", "--along", "drawn"};
    const Ran ran = cell.run(words + QStringList{"--through", "400,0,100;380,60,100", "--free", "--standoff", "5",
                                                 "--name", "drawn", "-o", "c.handwheel"});
    QVERIFY2(ran.code == 0, ran.err);
    QCOMPARE(cell.run({"verify", "c.handwheel", "drawn"}).code, 0);
    QCOMPARE(cell.run({"post", "c.handwheel", "drawn", "--controller", "csv", "-o", "drawn.csv"}).code, 0);
    const QByteArray table = cell.read("drawn.csv");
    for (const char* position : {"380.000000000,-60.000000000,105.000000000", "400.000000000,0.000000000,105.000000000",
                                 "380.000000000,60.000000000,105.000000000"})
      QVERIFY2(table.contains(position), table);
    const Ran broken = cell.run(words + QStringList{"--through", "400,0,100;400,0,0"});
    QCOMPARE(broken.code, 1);
    QVERIFY2(broken.err.contains("Places 2 and 3 of the curve"), broken.err);
    QVERIFY(cell.run(words + QStringList{"--through", "400,0"}).code != 0);
    QVERIFY(cell.run(words).code != 0);
  }

  // Passes a critical configuration, is stored in the cell, and is repeatable.
  void throughACriticalConfiguration() {
    const PlannedCell cell;
    const QStringList words{"plan", "cell.handwheel", "--from", "left", "--via", "up",
                            "--to", "right",          "--name", "over", "--json"};
    const Ran ran = cell.run(words + QStringList{"-o", "planned.handwheel"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json cellNow = jsonOf(cell.run({"inspect", "planned.handwheel", "--json"}).out);
    QCOMPARE(cellNow["document"]["paths"][0]["name"].get<std::string>(), std::string("over"));
    QCOMPARE(cell.run({"verify", "planned.handwheel", "over"}).code, 0);
    nlohmann::json first = jsonOf(ran.out), again = jsonOf(cell.run(words).out);
    first.erase("seconds");
    again.erase("seconds");
    QVERIFY(first == again);
  }

  // He 2008: the planner alone, with one and with two critical configurations, without and with shortcuts.
  void comparison() {
    const PlannedCell cell;
    const QStringList words{"plan", "cell.handwheel", "--from", "left", "--to", "right", "--via", "up", "--compare"};
    const Ran ran = cell.run(words + QStringList{"--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json rows = jsonOf(ran.out)["comparison"];
    QCOMPARE(rows.size(), std::size_t{4});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      QCOMPARE(rows[i]["critical"].size(), i / 2);
      QCOMPARE(rows[i]["optimised"].get<bool>(), i % 2 == 1);
      QVERIFY(rows[i]["solved"].get<bool>() && rows[i]["certified"].get<bool>());
      for (const char* key : {"length_rad", "cycle_s", "seconds", "manipulability", "security_mm"})
        QVERIFY(rows[i][key].get<double>() > 0.0);
      if (i % 2 == 1) QVERIFY(rows[i]["length_rad"].get<double>() <= rows[i - 1]["length_rad"].get<double>() + 1e-9);
    }
    const Ran table = cell.run(words);
    QCOMPARE(table.code, 0);
    QCOMPARE(table.out.count('\n'), 5);
    const Ran none = cell.run({"plan", "cell.handwheel", "--from", "left", "--to", "0 0.6 0 0 0 0", "--compare"});
    QCOMPARE(none.code, 2);
    QVERIFY2(none.out.contains("box"), none.out);
    QCOMPARE(cell.run(words + QStringList{"-o", "no.json"}).code, 1);
  }

  // The waypoints of a path in another order, stored in the cell under its name; the roadmap planner works as well.
  void optimised() {
    const PlannedCell cell;
    cell.put("path.json", R"({"waypoints": [[1.2, 0.5, 0, 0, 0, 0], [-1, 0.5, 0, 0, 0, 0], [0.9, 0.5, 0, 0, 0, 0],
                              [-1.2, 0.5, 0, 0, 0, 0]]})");
    const Ran ran = cell.run({"optimise-path", "cell.handwheel", "path.json", "--name", "quick", "--planner", "prm",
                              "-o", "quick.handwheel", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json report = jsonOf(ran.out);
    QVERIFY(report["changed"].get<bool>() && report["certified"].get<bool>());
    QVERIFY(report["order"] == nlohmann::json({1, 3, 2, 4}));
    QCOMPARE(report["cycle_s"].get<double>(), report["after_s"].get<double>());
    QCOMPARE(cell.run({"verify", "quick.handwheel", "quick"}).code, 0);
    const Ran again = cell.run({"optimise-path", "quick.handwheel", "quick", "--keep-order"});
    QVERIFY2(again.code == 0 && again.out.contains("quick"), again.err);
    QCOMPARE(cell.run({"optimise-path", "cell.handwheel", "none"}).code, 1);
  }

  void whatCannotBePlanned_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("code");
    QTest::addColumn<QByteArray>("message");
    QTest::newRow("no such place") << QStringList{"--from", "left", "--to", "nowhere"} << 1 << QByteArray("'nowhere'");
    QTest::newRow("inside the box") << QStringList{"--from", "left", "--to", "0 0.6 0 0 0 0"} << 2 << QByteArray("box");
    QTest::newRow("beyond a limit") << QStringList{"--from", "left", "--to", "9 0 0 0 0 0"} << 1
                                    << QByteArray("oint_1");
    QTest::newRow("no end") << QStringList{"--from", "left"} << 1 << QByteArray("--to");
    QTest::newRow("too few numbers") << QStringList{"--from", "left", "--to", "0 0"} << 1 << QByteArray("'0 0'");
  }
  void whatCannotBePlanned() {
    QFETCH(const QStringList, words);
    QFETCH(const int, code);
    QFETCH(const QByteArray, message);
    const PlannedCell cell;
    const Ran ran = cell.run(QStringList{"plan", "cell.handwheel"} + words);
    QCOMPARE(ran.code, code);
    QVERIFY2(ran.err.contains(message), ran.err);
  }

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

  // A line of 50 mm/s and a motion with 30 % come back as such from each language, as a path that is written once more.
  void speedsComeBack() {
    const PlannedCell cell;
    cell.put("path.json", R"({"places": [
      {"joints": {"joint_1": 1.2, "joint_2": 0.5}, "name": "begin"},
      {"joints": {"joint_1": 1.2, "joint_2": 0.6}, "name": "end", "motion": "linear", "speed": 50},
      {"joints": {"joint_1": 1.0, "joint_2": 0.6}, "speed": 0.3}]})");
    for (const auto& [controller, file] :
         {std::pair("rapid", "p.mod"), std::pair("krl", "p.src"), std::pair("fanuc", "p.ls"),
          std::pair("urscript", "p.script"), std::pair("csv", "p.csv"), std::pair("json", "p.program.json")}) {
      const Ran ran = cell.run({"post", "cell.handwheel", "path.json", "--controller", controller, "-o", file});
      QVERIFY2(ran.code == 0, ran.err);
      const Ran again = cell.run({"post", "cell.handwheel", file, "--controller", "csv", "-o", "again.csv"});
      QVERIFY2(again.code == 0, again.err);
      const QList<QByteArray> rows = cell.rowsOf("again.csv");
      QVERIFY2(rows.value(2).contains(",linear,50.000000,"), rows.value(2));
      QVERIFY2(rows.value(3).contains(",joint,0.300000,"), rows.value(3));
    }
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
      const Ran ran = cell.run(words);
      QCOMPARE(ran.code, 0);
      QCOMPARE(ran.err.contains("warning") && ran.err.contains("ABB IRB 120"), isOther);
      QCOMPARE(jsonOf(cell.run(words + QStringList{"--json"}).out)["other_robot"].get<bool>(), isOther);
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

HANDWHEEL_TEST(PlanTest)
#include "PlanTest.moc"
