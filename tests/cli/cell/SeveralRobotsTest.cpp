// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

// A bar of 400 mm that turns about z.
const QByteArray kBar = R"(<robot name='bar'><link name='foot'/>
  <link name='bar'><visual><origin xyz='0.2 0 0'/><geometry><box size='0.4 0.02 0.02'/></geometry></visual></link>
  <link name='tip'/>
  <joint name='turn' type='revolute'><parent link='foot'/><child link='bar'/><axis xyz='0 0 1'/>
    <limit lower='-3' upper='3' velocity='1' effort='1'/></joint>
  <joint name='end' type='fixed'><parent link='bar'/><child link='tip'/><origin xyz='0.4 0 0'/></joint>
</robot>)";

// Two of them in a cell, their feet 700 mm apart; each has configurations on both sides of the other one's.
class TwoBars {
 public:
  TwoBars() {
    m_fixture.put("bar.urdf", kBar);
    done({"robot", "bar.urdf", "--add", "bar.urdf", "--name", "right", "--at", "700,0,0", "--turn", "0,0,180"});
    for (const QString& arm : {QString("bar"), QString("right")}) {
      const QString joint = arm == "bar" ? "turn" : "right_turn";
      done({"configuration", "cell.handwheel", "--arm", arm, "--joints", joint + "=1", "--add", arm + " up"});
      done({"configuration", "cell.handwheel", "--arm", arm, "--joints", joint + "=-1", "--add", arm + " down"});
    }
  }
  Ran run(const QStringList& words) const { return m_fixture.run(words); }
  // Writes the cell.
  Ran done(const QStringList& words) const {
    Ran ran = run(words + QStringList{"-o", "cell.handwheel"});
    if (ran.code != 0) qFatal("%s", ran.err.constData());
    return ran;
  }
  nlohmann::json described() const { return jsonOf(run({"inspect", "cell.handwheel", "--json"}).out)["document"]; }
  void put(const QString& name, const QByteArray& content) const { m_fixture.put(name, content); }
  QByteArray read(const QString& name) const { return m_fixture.content(name); }

 private:
  Fixture m_fixture;
};

}  // namespace

// Several robots in one cell, without a window.
class SeveralRobotsTest : public QObject {
  Q_OBJECT

 private slots:
  void added() {
    const TwoBars cell;
    const nlohmann::json robots = cell.described()["robots"];
    QCOMPARE(robots.size(), std::size_t{2});
    QCOMPARE(robots[1]["name"].get<std::string>(), std::string("right"));
    QCOMPARE(robots[1]["position"][0].get<double>(), 700.0);
    QVERIFY(robots[0]["planned"].get<bool>() && !robots[1]["planned"].get<bool>());  // --arm is for one command
    const Ran once = cell.run({"robot", "cell.handwheel", "--add", "irb120", "--name", "right", "-o", "t.handwheel"});
    QVERIFY(once.out.contains("right_2: "));
    const Ran file = cell.run({"robot", "cell.handwheel", "--add", "no.urdf", "-o", "t.handwheel"});
    QVERIFY(file.code != 0 && !file.err.isEmpty());
    // A document would lose its tool and its configurations.
    cell.done({"robot", "cell.handwheel", "--remove", "right"});
    const Ran saved = cell.run({"robot", "irb120", "--add", "cell.handwheel", "-o", "t.handwheel"});
    QVERIFY(saved.code != 0 && saved.err.contains("a saved document as a robot"));
    QVERIFY(cell.run({"robot", "cell.handwheel", "--remove", "left", "-o", "t.handwheel"}).code != 0);
  }

  // Each robot turns freely while the other one is away.
  void planned() {
    const TwoBars cell;
    const QStringList ends{"--from", "right up", "--to", "right down", "--time", "0.2"};
    // The first one points to the second: in either direction it collides.
    const Ran blocked = cell.run(QStringList{"plan", "cell.handwheel", "--arm", "right", "--json"} + ends);
    QCOMPARE(blocked.code, 2);
    cell.done({"set", "cell.handwheel", "joint.right_turn=20"});
    cell.done({"configuration", "cell.handwheel", "--go", "bar up"});
    QCOMPARE(cell.described()["joints"][0]["value"].get<double>(), 1.0);
    QVERIFY(cell.described()["joints"][1]["value"].get<double>() > 0.3);  // Value of the other robot, unchanged
    cell.done({"configuration", "cell.handwheel", "--joints", "turn=2.5", "--add", "away"});
    cell.done({"configuration", "cell.handwheel", "--go", "away"});
    const QStringList named = ends + QStringList{"--name", "swing"};
    const Ran free = cell.done(QStringList{"plan", "cell.handwheel", "--arm", "right", "--json"} + named);
    QVERIFY(jsonOf(free.out)["certified"].get<bool>());
    // The path is of the second robot, which needs no option; a path through configurations of the first one is not.
    const Ran verified = cell.run({"verify", "cell.handwheel", "swing", "--json"});
    QVERIFY2(verified.code == 0, verified.err);
    QVERIFY(jsonOf(verified.out)["robots_moved"].empty());
    QVERIFY(cell.run(QStringList{"plan", "cell.handwheel"} + ends).err.contains("another robot"));
    QVERIFY(cell.run({"verify", "cell.handwheel", "swing", "--arm", "bar"}).err.contains("another robot"));
    // A file of waypoints without the names of joints is of the joints of the robot that is planned for.
    cell.put("way.json", R"({"waypoints": [[1], [-1]]})");
    QCOMPARE(cell.run({"verify", "cell.handwheel", "way.json", "--arm", "right"}).code, 0);
    // The first one comes back: the path says so, and that they meet.
    cell.done({"set", "cell.handwheel", "joint.turn=0"});
    const Ran moved = cell.run({"verify", "cell.handwheel", "swing", "--json"});
    QCOMPARE(moved.code, 2);
    QCOMPARE(jsonOf(moved.out)["robots_moved"][0].get<std::string>(), std::string("bar"));
    QCOMPARE(jsonOf(moved.out)["collisions"][0]["with"].get<std::string>(), std::string("bar"));
  }

  // Programs count from the base of their robot, wherever it stands.
  void programs() {
    const PlannedCell cell;
    const auto run = [&](const QStringList& words) {
      const Ran ran = cell.run(words);
      if (ran.code != 0) qFatal("%s", ran.err.constData());
    };
    run({"configuration", "irb120", "--add", "a", "--joints", "joint_1=0.4,joint_5=0.5", "-o", "one.handwheel"});
    run({"configuration", "one.handwheel", "--add", "b", "--joints", "joint_1=-0.4,joint_5=0.5", "-o",
         "one.handwheel"});
    run({"plan", "one.handwheel", "--from", "a", "--to", "b", "--name", "p", "-o", "one.handwheel"});
    run({"robot", "ur5", "--add", "irb120", "--name", "r", "--at", "3000,500,0", "--turn", "0,0,70", "-o",
         "two.handwheel"});
    for (const char* const name : {"a", "b"}) {
      run({"configuration", "two.handwheel", "--arm", "r", "--joints",
           QString("r_joint_1=%1,r_joint_5=0.5").arg(name[0] == 'a' ? "0.4" : "-0.4"), "--add", name, "-o",
           "two.handwheel"});
    }
    run({"plan", "two.handwheel", "--arm", "r", "--from", "a", "--to", "b", "--name", "p", "-o", "two.handwheel"});
    for (const char* const name : {"one.handwheel", "two.handwheel"})
      run({"set", name, "path.p.2.motion=straight line", "-o", name});
    run({"post", "one.handwheel", "p", "--controller", "krl", "-o", "one.src"});
    run({"post", "two.handwheel", "p", "--controller", "krl", "-o", "two.src"});
    QVERIFY(cell.read("one.src").contains("LIN {"));
    // The heads name the links that may touch, which have other names beside another robot.
    const auto motions = [&](const char* name) {
      QList<QByteArray> lines = cell.read(name).split('\n');
      lines.removeIf([](const QByteArray& line) { return line.startsWith("; Not checked: "); });
      return lines;
    };
    QCOMPARE(motions("two.src"), motions("one.src"));
  }

  void chosenMovedAndRemoved() {
    const TwoBars cell;
    cell.done({"robot", "cell.handwheel", "--choose", "right"});
    QCOMPARE(cell.described()["tool"]["link"].get<std::string>(), std::string("right_tip"));
    cell.done({"set", "cell.handwheel", "robot.right.y=300"});
    QVERIFY(std::abs(cell.described()["tool"]["position"][1].get<double>() - 300.0) < 1e-6);
    // 400 mm from its foot towards +y, in the frame of the cell.
    const Ran found =
        cell.run({"ik", "cell.handwheel", "--pose=700,700,0,0.7071067811865476,0,0,0.7071067811865476", "--json"});
    QVERIFY2(found.code == 0, found.err);
    QVERIFY(std::abs(jsonOf(found.out)["solutions"][0]["q"][0].get<double>() + M_PI / 2.0) < 1e-6);
    cell.done({"robot", "cell.handwheel", "--remove", "bar"});
    const nlohmann::json left = cell.described();
    QCOMPARE(left["robots"].size(), std::size_t{1});
    QCOMPARE(left["configurations"].size(), std::size_t{2});
    QVERIFY(std::abs(left["tool"]["position"][0].get<double>() - 300.0) < 1e-6);
    QVERIFY(cell.run({"robot", "cell.handwheel", "--remove", "right", "-o", "t.handwheel"}).code != 0);
    QVERIFY(cell.run({"robot", "cell.handwheel", "-o", "t.handwheel"}).code != 0);
  }
};

HANDWHEEL_TEST(SeveralRobotsTest)
#include "SeveralRobotsTest.moc"
