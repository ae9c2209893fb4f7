// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace handwheel;

// Changes on the command line of the data that a cell keeps for planning: configurations, their numbers, pairs that may
// touch.
class ConfigurationsTest : public QObject {
  Q_OBJECT

 private slots:
  // A link and a body that may touch, and no longer.
  void pairsAreAllowed() {
    const PlannedCell cell;
    cell.put("straight.json", R"({"waypoints": [[1.2, 0.5, 0, 0, 0, 0], [-1.2, 0.5, 0, 0, 0, 0]]})");
    const auto met = [&] {
      std::set<std::string> links;
      const Ran ran = cell.run({"verify", "cell.handwheel", "straight.json", "--json"});
      const nlohmann::json report = jsonOf(ran.out);
      for (const nlohmann::json& each : report["collisions"]) links.insert(each["link"].get<std::string>());
      return links;
    };
    const std::set<std::string> before = met();
    QVERIFY(!before.empty());
    const auto change = [&](const char* option, const QString& pair) {
      return cell.run({"configuration", "cell.handwheel", option, pair, "-o", "cell.handwheel"}).code;
    };
    for (const std::string& link : before) {
      QCOMPARE(change("--allow", QString::fromStdString(link) + ",box"), 0);
      QVERIFY(!met().contains(link));
    }
    const Ran verified = cell.run({"verify", "cell.handwheel", "straight.json"});
    QCOMPARE(verified.code, 0);
    // The proof holds except for these pairs: reports and programs say so.
    const nlohmann::json left = jsonOf(cell.run({"verify", "cell.handwheel", "straight.json", "--json"}).out);
    const Ran written =
        cell.run({"post", "cell.handwheel", "straight.json", "--controller", "rapid", "-o", "straight.mod"});
    QVERIFY2(written.code == 0, written.err);
    const QByteArray program = cell.read("straight.mod");
    for (const std::string& link : before) {
      const auto& pairs = left["not_checked"];
      QVERIFY(std::find(pairs.begin(), pairs.end(), nlohmann::json::array({link, "box"})) != pairs.end());
      const QByteArray text = QByteArray::fromStdString(link) + " with box";
      QVERIFY2(verified.out.contains(text) && written.err.contains(text), verified.out + written.err);
      QVERIFY2(program.contains("! Not checked: " + text), program);
    }
    const Ran inspected = cell.run({"inspect", "cell.handwheel"});
    QVERIFY2(inspected.out.contains("may touch: ") && inspected.out.contains("box"), inspected.out);
    QVERIFY2(program.contains("! Clearance kept: 0 mm.") && program.contains("the first place is not checked"),
             program);
    QCOMPARE(change("--forbid", "box," + QString::fromStdString(*before.begin())), 0);
    QVERIFY((met() == std::set<std::string>{*before.begin()}));
    QVERIFY(change("--allow", "box") != 0 && change("--allow", "box,nothing") != 0);
  }

  // A robot that comes with the program is inspected by its name, unless a file is called like this.
  void aRobotByItsName() {
    const PlannedCell cell;
    const Ran inspected = cell.run({"inspect", "irb120"});
    QVERIFY2(inspected.code == 0 && inspected.out.contains("joint.joint_1: "), inspected.out + inspected.err);
    const nlohmann::json described = jsonOf(cell.run({"inspect", "irb120", "--json"}).out);
    QCOMPARE(described["kind"].get<std::string>(), std::string("cell"));
    QCOMPARE(described["document"]["joints"].size(), std::size_t{6});
    QVERIFY(cell.run({"inspect", "irb121"}).code != 0);
    cell.put("irb120", "no robot");
    QVERIFY(cell.run({"inspect", "irb120"}).code != 0);
  }

  // A path through a configuration that was removed, which is said, and stored anew with other joints, is outdated:
  // reports and programs say so.
  void anOutdatedConfiguration() {
    const PlannedCell cell;
    cell.run({"configuration", "irb120", "--add", "home", "--joints", "joint_2=0.2,joint_5=0.6", "-o", "c.handwheel"});
    cell.run(
        {"configuration", "c.handwheel", "--add", "side", "--joints", "joint_1=0.8,joint_5=0.6", "-o", "c.handwheel"});
    const Ran planned =
        cell.run({"plan", "c.handwheel", "--from", "home", "--to", "side", "--name", "swing", "-o", "c.handwheel"});
    QVERIFY2(planned.code == 0, planned.err);
    const QStringList post{"post", "c.handwheel", "swing", "--controller", "rapid", "-o", "swing.mod"};
    const Ran removed = cell.run({"configuration", "c.handwheel", "--remove", "home", "-o", "c.handwheel"});
    QVERIFY2(removed.code == 0 && removed.err.contains("swing"), removed.err);
    QCOMPARE(cell.run(post).code, 0);
    cell.run(
        {"configuration", "c.handwheel", "--add", "home", "--joints", "joint_2=0.3,joint_5=0.6", "-o", "c.handwheel"});
    const auto path = jsonOf(cell.run({"inspect", "c.handwheel", "--json"}).out)["document"]["paths"][0];
    QVERIFY(path["outdated"].get<bool>());
    QCOMPARE(path["configurations_changed"][0].get<std::string>(), std::string("home"));
    const Ran inspected = cell.run({"inspect", "c.handwheel"});
    for (const char* const line : {"  configuration home\n", "  configuration side\n", "  path swing, "})
      QVERIFY2(inspected.out.contains(line), inspected.out);
    QVERIFY2(inspected.out.contains("outdated: home was changed\n"), inspected.out);
    const Ran verified = cell.run({"verify", "c.handwheel", "swing"});
    QVERIFY2(verified.out.contains("home was changed") && verified.out.contains("plan it again"), verified.out);
    const Ran refused = cell.run(post);
    QCOMPARE(refused.code, 1);
    QVERIFY2(refused.err.contains("home") && refused.err.contains("--outdated"), refused.err);
    QCOMPARE(cell.run(post + QStringList{"--outdated"}).code, 0);
    QVERIFY2(cell.read("swing.mod").contains("! Outdated: home was changed"), cell.read("swing.mod"));
  }

  // Numbers are given to the solutions that can be chosen, in their order; no other number is accepted.
  void numbersOfSolutions() {
    const PlannedCell cell;
    const auto at = [&](const QStringList& words) {
      return cell.run(QStringList{"configuration", "cell.handwheel", "--at", "350,200,500", "--turn", "0,90,0"} +
                      words);
    };
    const nlohmann::json listed = jsonOf(at({"--solutions", "--json"}).out)["solutions"];
    const QList<QByteArray> lines = at({"--solutions"}).out.split('\n');
    int numbers = 0, beyond = 0;
    for (const nlohmann::json& solution : listed) {
      const QByteArray head = lines[2 * (numbers + beyond)];
      const bool isWithin = solution["within_limits"].get<bool>();
      isWithin ? ++numbers : ++beyond;
      QCOMPARE(solution["number"].is_null(), !isWithin);
      QVERIFY(head.startsWith(isWithin ? QByteArray::number(numbers) + ": " : QByteArray("-: ")));
      if (!isWithin) continue;
      QCOMPARE(solution["number"].get<int>(), numbers);
      const Ran chosen = at({"--solution", QString::number(numbers), "--add", "way", "-o", "chosen.handwheel"});
      QVERIFY2(chosen.code == 0, chosen.err);
    }
    QVERIFY(numbers > 1 && beyond > 0);  // else it tells nothing
    QVERIFY(at({"--solution", QString::number(numbers + 1), "--add", "way", "-o", "chosen.handwheel"}).code != 0);
    const Ran far = cell.run({"configuration", "cell.handwheel", "--at", "5000,0,0", "--solution", "1", "--add", "way",
                              "-o", "chosen.handwheel"});
    QVERIFY(far.code != 0 && far.err.contains("bring its tool"));
  }

  void configurations() {
    const PlannedCell cell;
    QCOMPARE(cell.run({"configuration", "cell.handwheel", "--remove", "up", "-o", "cell.handwheel"}).code, 0);
    const Ran gone = cell.run({"configuration", "cell.handwheel", "--go", "up", "-o", "cell.handwheel"});
    QCOMPARE(gone.code, 1);
    QVERIFY(gone.err.contains("'up'"));
    const Ran moved = cell.run({"configuration", "cell.handwheel", "--go", "left", "-o", "cell.handwheel", "--json"});
    QCOMPARE(jsonOf(moved.out)["configurations"].size(), std::size_t{2});
    const nlohmann::json now = jsonOf(cell.run({"inspect", "cell.handwheel", "--json"}).out);
    QVERIFY(std::abs(now["document"]["joints"][0]["value"].get<double>() - 1.2) < 1e-12);
    const Ran beyond =
        cell.run({"configuration", "cell.handwheel", "--add", "x", "--joints", "joint_1=9", "-o", "cell.handwheel"});
    QCOMPARE(beyond.code, 1);
    QVERIFY(beyond.err.contains("oint_1"));
    // The pairs and states of a semantic description.
    cell.put("r.srdf",
             "<robot name='r'><group_state name='folded' group='arm'><joint name='joint_2' value='-1'/></group_state>"
             "<disable_collisions link1='link_1' link2='link_4' reason='Never'/></robot>");
    const Ran read = cell.run({"configuration", "cell.handwheel", "--srdf", "r.srdf", "-o", "cell.handwheel"});
    QVERIFY2(read.code == 0, read.err);
    QVERIFY(read.out.contains("configuration folded"));
  }

  // Lists all solutions for a pose, takes one of them, and plans a path to a target.
  void waysAndTargets() {
    const PlannedCell cell;
    const QStringList pose{"--at", "-250,200,500", "--turn", "160,20,0"};
    const Ran listed = cell.run(QStringList{"configuration", "cell.handwheel", "--solutions", "--json"} + pose);
    QVERIFY2(listed.code == 0, listed.err);
    const nlohmann::json solutions = jsonOf(listed.out)["solutions"];
    QVERIFY(solutions.size() >= 2 && solutions[1]["within_limits"].get<bool>());
    const Ran moved = cell.run(QStringList{"configuration", "cell.handwheel", "--add", "second", "--solution", "2",
                                           "-o", "moved.handwheel", "--json"} +
                               pose);
    QVERIFY2(moved.code == 0, moved.err);
    const nlohmann::json stored = jsonOf(moved.out)["configurations"].back();
    QCOMPARE(stored["name"].get<std::string>(), std::string("second"));
    for (const auto& [joint, value] : solutions[1]["joints"].items())
      QVERIFY(std::abs(stored["joints"][joint].get<double>() - value.get<double>()) < 1e-9);
    const Ran target =
        cell.run(QStringList{"configuration", "cell.handwheel", "--add-target", "drop", "-o", "cell.handwheel"} + pose);
    QVERIFY2(target.code == 0 && target.out.contains("target drop"), target.out + target.err);
    const Ran planned = cell.run({"plan", "cell.handwheel", "--from", "left", "--to", "drop", "--json"});
    QVERIFY2(planned.code == 0, planned.err);
    QVERIFY(jsonOf(planned.out)["certified"].get<bool>());
    const Ran far = cell.run({"configuration", "cell.handwheel", "--solutions", "--at", "5000,0,0"});
    QCOMPARE(far.code, 2);
    QVERIFY(far.out.contains("cannot"));
    const Ran set = cell.run({"set", "cell.handwheel", "tool.x=5000", "-o", "far.handwheel"});
    QVERIFY2(set.code != 0 && set.err.contains("5000"), set.err);
  }
};

HANDWHEEL_TEST(ConfigurationsTest)
#include "ConfigurationsTest.moc"
