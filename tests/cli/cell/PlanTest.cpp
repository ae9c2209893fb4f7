// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>
#include <array>
#include <cmath>

using namespace handwheel;

namespace {

// Returns the file of a robot with a configuration "home" and a block before it.
QByteArray cellWithABlock() {
  static const QByteArray file = [] {
    const PlannedCell cell;
    cell.run({"configuration", "irb120", "--add", "home", "--joints", "joint_2=0.2,joint_5=0.6", "-o", "c.handwheel"});
    cell.run({"body", "c.handwheel", "--add", "box:120,200,100", "--at", "420,0,50", "--name", "block", "-o",
              "c.handwheel"});
    return cell.read("c.handwheel");
  }();
  return file;
}

// Returns the file of such a cell with the path "deburr" along an edge of the block.
QByteArray cellWithAnEdgePath() {
  static const QByteArray file = [] {
    const PlannedCell cell;
    cell.put("c.handwheel", cellWithABlock());
    cell.run({"process", "c.handwheel", "--part", "block", "--near", "360,0,100", "--free", "--standoff", "2", "--name",
              "deburr", "-o", "deburr.handwheel"});
    return cell.read("deburr.handwheel");
  }();
  return file;
}

}  // namespace

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
    nlohmann::json now = described();
    QCOMPARE(now["frames"][0]["name"].get<std::string>(), std::string("fixture"));
    QVERIFY(now["frames"][0]["link"].is_null() && !now["frames"][0]["chosen"].get<bool>());
    QCOMPARE(now["targets"][0]["frame"].get<std::string>(), std::string("fixture"));
    // Between them lie -650, 150, 490 mm: the frame measures 150 mm along its x and 650 mm along its y.
    QVERIFY(std::abs(now["targets"][0]["position"][0].get<double>() - 150.0) < 1e-6);
    QVERIFY(std::abs(now["targets"][0]["position"][1].get<double>() - 650.0) < 1e-6);

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
    now = described();
    QVERIFY(now["frames"][0]["chosen"].get<bool>());
    QCOMPARE(posted({}), framed);
    QCOMPARE(posted({"--frame", "base"}), plain);
    QVERIFY(posted({"--frame", "other"}).contains("other"));
    const std::string link = now["tool"]["link"];
    change({"--add-frame", "gripped", "--link", QString::fromStdString(link)});
    const QByteArray moving = posted({"--frame", "gripped"});
    QVERIFY2(moving.contains("moves the frame 'gripped'"), moving);
    change({"--remove-frame", "fixture"});
    QCOMPARE(posted({}), plain);
    now = described();
    QVERIFY(now["targets"][0]["frame"].is_null());
    QVERIFY(std::abs(now["targets"][0]["position"][0].get<double>() + 250.0) < 1e-6);
  }

  // Along an edge of a block, coming from a configuration and going back there; the tool's centre point is where the
  // edge is, 2 mm away from it.
  void alongAnEdge() {
    const PlannedCell cell;
    cell.put("c.handwheel", cellWithABlock());
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
    cell.put("c.handwheel", cellWithAnEdgePath());
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
    cell.put("c.handwheel", cellWithABlock());
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
    nlohmann::json path = inspected();
    QVERIFY(path["outdated"].get<bool>());
    QCOMPARE(path["targets_moved"][0].get<std::string>(), std::string("drop"));
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
    cell.put("b.handwheel", cellWithAnEdgePath());
    cell.run({"set", "b.handwheel", "tcp.z=-1", "-o", "b.handwheel"});
    const Ran other = cell.run({"post", "b.handwheel", "deburr", "--controller", "rapid", "-o", "deburr.mod"});
    QCOMPARE(other.code, 1);
    QVERIFY2(other.err.contains("tool centre point") && other.err.contains("--outdated"), other.err);
  }

  // On the top of a block, with a bend, 5 mm above it.
  void alongADrawnCurve() {
    const PlannedCell cell;
    cell.put("c.handwheel", cellWithABlock());
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
};

HANDWHEEL_TEST(PlanTest)
#include "PlanTest.moc"
