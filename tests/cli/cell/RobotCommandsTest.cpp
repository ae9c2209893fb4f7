// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "BuildPaths.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

nlohmann::json reportOf(const Ran& run) {
  return nlohmann::json::parse(run.out.toStdString());
}

// An arm in a plane with links of 500 mm, as balls.
QByteArray planarUrdf(int links = 2) {
  QByteArray text = "<robot name='r'><link name='base'/>";
  for (int i = 1; i <= links; ++i) {
    text += QStringLiteral("<link name='l%1'>").arg(i).toUtf8();
    for (double x = 0.1; x < 0.55; x += 0.05)
      text +=
          QStringLiteral("<collision><origin xyz='%1 0 0'/><geometry><sphere radius='0.03'/></geometry></collision>")
              .arg(x)
              .toUtf8();
    text += "</link>";
    text += QStringLiteral(
                "<joint name='j%1' type='revolute'><parent link='%2'/><child link='l%1'/><origin xyz='%3 0 0'/>"
                "<axis xyz='0 0 1'/><limit lower='-3' upper='3' velocity='1' effort='1'/></joint>")
                .arg(i)
                .arg(i == 1 ? QStringLiteral("base") : QStringLiteral("l%1").arg(i - 1))
                .arg(i == 1 ? 0.0 : 0.5)
                .toUtf8();
  }
  return text + "</robot>";
}

// Past a ball in the middle; the second problem begins in it.
QByteArray planarSet() {
  const auto problem = [](int index, const char* start) {
    return QStringLiteral(R"({"index": %1, "start": %2, "goal": [0.9, 0.2], "objects": [{"type": "sphere",
      "dimensions": [0.1], "position": [0.8, 0, 0], "orientation": [0, 0, 0, 1]}]})")
        .arg(index)
        .arg(QLatin1String(start));
  };
  return (QStringLiteral(R"({"scene": "ball", "joints": ["j1", "j2"], "problems": [)") + problem(1, "[-0.9, -0.2]") +
          QLatin1Char(',') + problem(2, "[0, 0]") + QStringLiteral("]}"))
      .toUtf8();
}

// The first of these problems as MotionBenchMaker writes it.
constexpr const char* kPlanarScene = R"(world:
  collision_objects:
    - id: ball
      primitives: [{type: sphere, dimensions: [0.1]}]
      primitive_poses: [{position: [0.8, 0, 0], orientation: [0, 0, 0, 1]}]
)";
constexpr const char* kPlanarRequest = R"(start_state: {joint_state: {name: [j2, j1], position: [-0.2, -0.9]}}
goal_constraints:
  - joint_constraints: [{joint_name: j1, position: 0.9}, {joint_name: j2, position: 0.2}]
)";

}  // namespace

// Robots on the command line: inverse kinematics, and planning for comparison.
class RobotCommandsTest : public QObject {
  Q_OBJECT

 private slots:
  // The position of the flange with all joints at 0 is in the data sheet of the IRB 120: 374 mm ahead, 630 mm up.
  void theHomeOfABuiltInRobot() {
    const Fixture fixture;
    const QString half = QString::number(std::sqrt(0.5), 'g', 17);
    const QString home = QStringLiteral("--pose=374,0,630,%1,0,%1,0").arg(half);
    const Ran one = fixture.run({"ik", "irb120", home, "--json"});
    QVERIFY2(one.code == 0, one.err);
    const nlohmann::json first = reportOf(one);
    QVERIFY(first["solved"].get<bool>());
    QCOMPARE(first["solutions"].size(), std::size_t{1});
    const auto home6 = first["solutions"][0]["q"].get<std::vector<double>>();
    QCOMPARE(home6.size(), std::size_t{6});
    for (const double q : home6) QVERIFY(std::abs(q) < 1e-6);
    // Forward, beside the plane of the arm: the wrist may be turned over.
    const Ran many = fixture.run({"ik", "irb120", "--pose=400,100,400,2,0,2,0", "--all", "--json"});
    const nlohmann::json all = reportOf(many)["solutions"];
    QVERIFY2(all.size() >= 2, many.out);
    for (const nlohmann::json& solution : all)
      QVERIFY(solution["error_mm"].get<double>() < 1e-6 && solution["error_rad"].get<double>() < 1e-9);
    const Ran far = fixture.run({"ik", "irb120", "--pose=3740,0,630,1,0,0,0", "--json"});
    QCOMPARE(far.code, 2);
    QVERIFY(!reportOf(far)["solved"].get<bool>());
  }

  void tablesAndDescriptions() {
    const Fixture fixture;
    fixture.put("scara.json", R"({"joints": [{"a": 300, "d": 400}, {"a": 200},
      {"type": "prismatic", "lower": -150, "upper": 0}, {"theta": 0}]})");
    // 300 mm along x, 200 along y at the elbow's 90°, 50 down, turned by 90° and 30° more.
    const double half = (90.0 + 30.0) * M_PI / 360.0;
    const Ran run =
        fixture.run({"ik", "scara.json", "--json",
                     QStringLiteral("--pose=300,200,350,%1,0,0,%2").arg(std::cos(half)).arg(std::sin(half))});
    QVERIFY2(run.code == 0, run.err + run.out);
    const auto q = reportOf(run)["solutions"][0]["q"].get<std::vector<double>>();
    QVERIFY(std::abs(q[2] + 50.0) < 0.02);
    fixture.put("arm.urdf", planarUrdf());
    // A plane arm cannot turn its flange as it likes.
    QCOMPARE(fixture.run({"ik", "arm.urdf", "--pose=500,500,0,1,0,0,0"}).code, 2);
    // But it can be there: its second link stands at 300, 400, unturned, and is not tilted by 0.4 rad as was asked.
    const QString tilted =
        QStringLiteral("--pose=300,400,0,%1,%2,0,0").arg(std::cos(0.2), 0, 'g', 17).arg(std::sin(0.2), 0, 'g', 17);
    QCOMPARE(fixture.run({"ik", "arm.urdf", tilted, "--tip", "l2"}).code, 2);
    const Ran there = fixture.run({"ik", "arm.urdf", tilted, "--tip", "l2", "--place", "--json"});
    QVERIFY2(there.code == 0, there.err + there.out);
    const nlohmann::json solution = reportOf(there)["solutions"][0];
    const auto standing = solution["q"].get<std::vector<double>>();
    QVERIFY(solution["error_mm"].get<double>() < 0.05 && std::abs(solution["error_rad"].get<double>() - 0.4) < 0.01);
    QVERIFY(std::abs(standing[0] - std::atan2(4.0, 3.0)) < 1e-3 && std::abs(standing[0] + standing[1]) < 0.05);
    QCOMPARE(fixture.run({"ik", "arm.urdf", "--pose=500,500,0,1,0,0,0", "--place"}).code, 2);
    QCOMPARE(fixture.run({"ik", "arm.urdf", "--pose=500,0,0,1,0,0,0", "--tip", "l2"}).code, 0);
    const Ran noLink = fixture.run({"ik", "arm.urdf", "--pose=500,0,0,1,0,0,0", "--tip", "l9"});
    QVERIFY2(noLink.code == 1 && noLink.err.contains("l9"), noLink.err);
    QCOMPARE(fixture.run({"ik", "irb120"}).code, 1);
    QCOMPARE(fixture.run({"ik", "irb120", "--pose=0,0,0,0,0,0,0"}).code, 1);
    // A robot that is no cell has no other robots.
    for (const char* robot : {"irb120", "arm.urdf", "scara.json"}) {
      const Ran chosen = fixture.run({"ik", robot, "--pose=300,0,300,1,0,0,0", "--arm", "nonsense"});
      QVERIFY2(chosen.code == 1 && chosen.err.contains("--arm") && chosen.err.contains(robot), chosen.err);
    }
    QCOMPARE(fixture.run({"ik", "no-robot", "--pose=0,0,0,1,0,0,0"}).code, 1);
    fixture.put("bad.json", R"({"joints": [{"a": "x"}]})");
    QCOMPARE(fixture.run({"ik", "bad.json", "--pose=0,0,0,1,0,0,0"}).code, 1);
  }

  // The joint values are those of the program whose tool pose is given.
  void ofACell() {
    const Fixture fixture;
    const QString cell = test::sourcePath("resources/samples/robot-cell.handwheel");
    const Ran posted = fixture.run({"post", cell, "edge", "--controller", "csv", "-o", "edge.csv"});
    QVERIFY2(posted.code == 0, posted.err);
    QList<QByteArray> lines = fixture.content("edge.csv").split('\n');
    lines.removeIf([](const QByteArray& line) { return line.startsWith('#'); });
    const QList<QByteArray> row = lines.at(1).split(',');
    QCOMPARE(row.size(), 5 + 6 + 7);
    const QString pose = QStringLiteral("--pose=") + QString::fromLatin1(row.mid(11).join(','));
    const Ran run = fixture.run({"ik", cell, pose, "--all", "--json"});
    QVERIFY2(run.code == 0, run.err);
    const nlohmann::json solutions = reportOf(run)["solutions"];
    bool isFound = false;
    for (const nlohmann::json& solution : solutions) {
      double off = 0.0;
      for (int i = 0; i < 6; ++i)
        off = std::max(off, std::abs(solution["q"][i].get<double>() - row[5 + i].toDouble() * M_PI / 180.0));
      isFound = isFound || off < 1e-5;
    }
    QVERIFY2(isFound, run.out);
  }

  // The four that there are, by their names.
  void noRobot() {
    const Fixture fixture;
    fixture.put("letter.txt", "Dear robot,");
    for (const char* robot : {"letter.txt", "irb121"}) {
      const Ran run = fixture.run({"ik", robot, "--pose=0,0,0,1,0,0,0"});
      QCOMPARE(run.code, 1);
      for (const char* word : {robot, "URDF", "table", "cell", "built-in robot"})
        QVERIFY2(run.err.contains(word), run.err);
    }
  }

  void aBenchmarkOfTwo() {
    const Fixture fixture;
    fixture.put("arm.urdf", planarUrdf());
    fixture.put("set.json", planarSet());
    const Ran run = fixture.run(
        {"benchmark-planning", "set.json", "--robot", "arm.urdf", "--paths", "paths", "--json", "--time", "60"});
    QVERIFY2(run.code == 0, run.err);
    const nlohmann::json json = reportOf(run);
    QVERIFY(json["problems"] == 2 && json["solved"] == 1 && json["certified"] == 1);
    QCOMPARE(json["results"][1]["outcome"].get<std::string>(), std::string("start_in_collision"));
    const auto path = nlohmann::json::parse(fixture.content("paths/ball_1.json").toStdString());
    QVERIFY(path["certified"].get<bool>());
    QVERIFY(path["waypoints"].front() == nlohmann::json({-0.9, -0.2}));
    QVERIFY(path["waypoints"].back() == nlohmann::json({0.9, 0.2}));
    const nlohmann::json other = reportOf(fixture.run({"benchmark-planning", "set.json", "--robot", "arm.urdf",
                                                       "--planner", "rrtconnect", "--json", "--time", "60"}));
    QVERIFY(other["planner"] == "rrtconnect" && other["certified"] == 1);
    QVERIFY(other["checks_mean"].get<double>() > 0.0);
    QCOMPARE(fixture.run({"benchmark-planning", "set.json"}).code, 1);
    const QByteArray text = fixture.run({"benchmark-planning", "set.json", "--robot", "arm.urdf", "--time", "60"}).out;
    const QByteArray length = QByteArray::number(json["length_rad_mean"].get<double>(), 'g', 3);
    QVERIFY2(text.contains("mean length " + length + " rad"), text);
    QVERIFY2(text.contains("ball_2: start_in_collision\n"), text);
  }

  // The same problem as a pair of YAML files, by either of them, and in a folder of pairs.
  void aBenchmarkOfPairs() {
    const Fixture fixture;
    fixture.put("arm.urdf", planarUrdf());
    fixture.put("set.json", planarSet());
    QVERIFY(QDir(fixture.path()).mkpath("folder"));
    for (const QString folder : {"", "folder/"}) {
      fixture.put(folder + "ball_scene0001.yaml", kPlanarScene);
      fixture.put(folder + "ball_request0001.yaml", kPlanarRequest);
    }
    const auto planned = [&](const QString& set) {
      return reportOf(fixture.run({"benchmark-planning", set, "--robot", "arm.urdf", "--json", "--time", "60"}));
    };
    const nlohmann::json expected = planned("set.json")["results"][0];
    for (const QString set : {"ball_scene0001.yaml", "ball_request0001.yaml", "folder"}) {
      const nlohmann::json json = planned(set);
      QCOMPARE(json["problems"].get<int>(), 1);
      for (const char* key : {"name", "outcome", "certified", "length_rad", "checks"})
        QVERIFY2(json["results"][0][key] == expected[key], json.dump().c_str());
    }
    fixture.put("lonely_request7.yaml", kPlanarRequest);
    const Ran lonely = fixture.run({"benchmark-planning", "lonely_request7.yaml", "--robot", "arm.urdf"});
    QVERIFY2(lonely.code == 1 && lonely.err.contains("lonely_scene7.yaml"), lonely.err);
    fixture.put("bad_scene.yaml", "a: &a [*a]");
    fixture.put("bad_request.yaml", kPlanarRequest);
    const Ran bad = fixture.run({"benchmark-planning", "bad_request.yaml", "--robot", "arm.urdf"});
    QVERIFY2(bad.code == 1 && bad.err.contains("bad_scene.yaml") && bad.err.contains("alias"), bad.err);
  }

  // At the goal the third link lies across the first: that is named with its depth, and allowed only if that is asked
  // for. The balls of both links are 50 mm apart and 60 mm wide.
  void ownLinksThatOverlap() {
    const Fixture fixture;
    fixture.put("arm.urdf", planarUrdf(3));
    fixture.put("set.json", R"({"scene": "folded", "joints": ["j1", "j2", "j3"], "problems": [
      {"index": 4, "start": [0, 0.5, 0.2], "goal": [0, 2.0, 2.71], "objects": []}]})");
    double depth = 0.0;
    for (int i = 2; i <= 10; ++i) {
      for (int k = 2; k <= 10; ++k) {
        const double x = 500.0 + 500.0 * std::cos(2.0) + 50.0 * k * std::cos(4.71) - 50.0 * i;
        depth = std::max(depth, 60.0 - std::hypot(x, 500.0 * std::sin(2.0) + 50.0 * k * std::sin(4.71)));
      }
    }
    QVERIFY(depth > 1.0);
    const QStringList words{"benchmark-planning", "set.json", "--robot", "arm.urdf", "--time", "60"};
    const nlohmann::json strict = reportOf(fixture.run(words + QStringList{"--json"}));
    QVERIFY(strict["solved"] == 0 && strict["with_own_overlaps"] == 1);
    const nlohmann::json result = strict["results"][0];
    QCOMPARE(result["outcome"].get<std::string>(), std::string("goal_in_collision"));
    QCOMPARE(result["own_overlaps"].size(), std::size_t{1});
    const nlohmann::json overlap = result["own_overlaps"][0];
    QVERIFY(overlap["links"] == nlohmann::json({"l1", "l3"}) && overlap["at"] == "goal" && overlap["allowed"] == false);
    QVERIFY(std::abs(overlap["depth_mm"].get<double>() - depth) < 1e-6);
    const QByteArray text = fixture.run(words).out;
    QVERIFY2(text.contains("folded_4: goal_in_collision; l1 overlaps l3 by"), text);
    const QStringList allowing = words + QStringList{"--own-overlaps", "--paths", "paths"};
    const nlohmann::json allowed = reportOf(fixture.run(allowing + QStringList{"--json"}));
    QVERIFY2(allowed["solved"] == 1 && allowed["certified"] == 0 && allowed["solved_with_overlaps_allowed"] == 1,
             allowed.dump().c_str());
    QVERIFY(allowed["results"][0]["certified_but_for_overlaps"].get<bool>());
    const nlohmann::json path = fixture.json("paths/folded_4.json");
    QVERIFY(!path["certified"].get<bool>() && path["certified_but_for_overlaps"].get<bool>());
    QVERIFY(path["waypoints"].back() == nlohmann::json({0, 2.0, 2.71}) && path["own_overlaps"][0]["allowed"] == true);
    const QByteArray said = fixture.run(allowing).out;
    QVERIFY2(said.contains("1 with overlapping links allowed") && said.contains("certified but for these pairs"), said);
  }

  // Ten goals in the sets for the UR5 have links that overlap in their model of spheres: by 0.71 to 8.91 mm, the
  // forearm with the second or third wrist. They were counted by another program, sphere by sphere.
  void theOverlapsOfTheUr5() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA") + "/planning/motionbenchmaker-ur5/";
    if (!QFile::exists(data)) QSKIP("HANDWHEEL_DATA is not set or has no motionbenchmaker-ur5.");
    const Fixture fixture;
    std::map<std::string, int> partners;
    double least = 1e9, most = 0.0;
    for (const char* set :
         {"bookshelf_small", "bookshelf_tall", "bookshelf_thin", "box", "cage", "table_pick", "table_under_pick"}) {
      const nlohmann::json json = reportOf(
          fixture.run({"benchmark-planning", data + set + "_ur5.json", "--robot", data + "robot/ur5_spherized.urdf",
                       "--srdf", data + "robot/ur5.srdf", "--time", "0.001", "--json"}));
      for (const nlohmann::json& result : json["results"]) {
        if (!result.contains("own_overlaps")) continue;
        for (const nlohmann::json& each : result["own_overlaps"]) {
          QVERIFY(each["at"] == "goal" && each["links"][0] == "forearm_link");
          ++partners[each["links"][1]];
          least = std::min(least, each["depth_mm"].get<double>());
          most = std::max(most, each["depth_mm"].get<double>());
        }
      }
    }
    QVERIFY2((partners == std::map<std::string, int>{{"wrist_2_link", 8}, {"wrist_3_link", 2}}),
             nlohmann::json(partners).dump().c_str());
    QVERIFY(std::abs(least - 0.710) < 6e-4 && std::abs(most - 8.914) < 6e-4);
  }
};

HANDWHEEL_TEST(RobotCommandsTest)
#include "RobotCommandsTest.moc"
