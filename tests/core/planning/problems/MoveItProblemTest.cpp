// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/problems/MoveItProblem.h"

#include "TestClass.h"

#include <QFile>
#include <QtTest>

using namespace handwheel;

namespace {

const std::string kScene = R"(robot_state: {joint_state: {name: [a, b], position: [0, 0]}}
allowed_collision_matrix:
  entry_names: [l1, l2, ball]
  entry_values: [[false, true, false], [true, false, false], [true, false, false]]
world:
  collision_objects:
    - id: ball
      pose: {position: [1, 0, 0], orientation: [0, 0, 0, 1]}
      primitives:
        - {type: sphere, dimensions: [0.1]}
        - {type: cylinder, dimensions: [0.4, 0.05]}
      primitive_poses:
        - {position: [0, 0, 2], orientation: [0, 0, 0, 1]}
        - {position: [0, 0, 0], orientation: [0, 0, 0, 1]}
)";

const std::string kRequest = R"(start_state:
  joint_state: {name: [grip, b, a], position: [9, 2, 1]}
goal_constraints:
  - joint_constraints:
      - {joint_name: a, position: 0.5}
      - {joint_name: b, position: -0.5}
)";

std::string textOfFile(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

bool isNear(const std::vector<double>& one, const std::vector<double>& other, double tolerance) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [&](double a, double b) { return std::abs(a - b) <= tolerance; });
}

}  // namespace

class MoveItProblemTest : public QObject {
  Q_OBJECT

 private slots:
  void aPair() {
    const auto set = readMoveItProblem(kScene, kRequest, "shelf_1");
    QVERIFY(set.hasValue());
    QVERIFY(set->joints == (std::vector<std::string>{"a", "b"}));
    QCOMPARE(set->problems.size(), std::size_t{1});
    const PlanningProblem& problem = set->problems[0];
    QCOMPARE(problem.name, std::string("shelf_1"));
    QVERIFY(problem.start == (std::vector<double>{1.0, 2.0}));  // by their names
    QVERIFY(problem.goal == (std::vector<double>{0.5, -0.5}));
    QCOMPARE(problem.obstacles.size(), std::size_t{2});
    QVERIFY((problem.obstacles[0].centre - Vec3(1000, 0, 2000)).norm() < 1e-9);
    QVERIFY(problem.obstacles[1].half == Vec3(50, 0, 200));
    QVERIFY(problem.names == (std::vector<std::string>{"ball", "ball"}));
    // The pairs that the matrix allows below its diagonal; it is symmetric.
    QVERIFY(problem.allowed == (std::vector<NamePair>{{"l1", "l2"}, {"l1", "ball"}}));
  }

  void damage_data() {
    QTest::addColumn<bool>("isScene");
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("instead");
    const auto row = [](const char* name, bool isScene, const char* what, const char* instead) {
      QTest::newRow(name) << isScene << QString(what) << QString(instead);
    };
    row("a mesh", true, "id: ball", "meshes: [{vertices: []}]");
    row("a plane", true, "id: ball", "planes: [{coef: [0, 0, 1, 0]}]");
    row("another frame", true, "id: ball", "header: {frame_id: table}");
    row("an octomap", true, "world:", "world:\n  octomap: {octomap: {data: [1]}}");
    row("something that is carried", true, "robot_state: {", "robot_state: {attached_collision_objects: [{}], ");
    row("a pose too few", true, "        - {position: [0, 0, 0], orientation: [0, 0, 0, 1]}\n", "");
    row("a cone", true, "sphere", "cone");
    row("less than nothing", true, "[0.1]", "[-0.1]");
    row("no number", true, "[0.1]", "[.nan]");
    row("a matrix that is no square", true, "[true, false, false]]", "[true, false]]");
    row("a matrix of words", true, "[true, false, false]]", "[maybe, false, false]]");
    row("objects that are none", true, "collision_objects:", "collision_objects: 3\n  other:");
    row("no goal", false, "goal_constraints", "other");
    row("a goal for the tool", false, "  - joint_constraints", "  - position_constraints: [{}]\n    joint_constraints");
    row("a goal without a name", false, "joint_name: a", "joint_name: 3");
    row("a joint without a start", false, "[grip, b, a]", "[grip, b, c]");
    row("a position too few", false, "[9, 2, 1]", "[9, 2]");
    row("carried from the start", false, "  joint_state:", "  attached_collision_objects: [{}]\n  joint_state:");
    row("far away", false, "[9, 2, 1]", "[9, 2, 1e99]");
    row("infinitely far", false, "position: 0.5", "position: .inf");
  }

  void damage() {
    QFETCH(bool, isScene);
    QFETCH(QString, what);
    QFETCH(QString, instead);
    std::string scene = kScene, request = kRequest;
    std::string& text = isScene ? scene : request;
    const std::size_t at = text.find(what.toStdString());
    QVERIFY(at != text.npos);
    text.replace(at, what.toStdString().size(), instead.toStdString());
    const auto set = readMoveItProblem(scene, request, "p");
    QVERIFY(!set);
    QVERIFY(set.error().code == ErrorCode::ElementMalformed);
    QVERIFY2(set.error().arguments.at(0).starts_with(isScene ? "scene" : "request"),
             set.error().arguments.at(0).c_str());
  }

  // A pair of each set of MotionBenchMaker is stored unchanged; the sets in JSON were made of them, with nine digits
  // behind the point.
  void thePairsAreTheSets() {
    const QString data = qEnvironmentVariable("HANDWHEEL_DATA");
    const QString folder = data + "/planning/motionbenchmaker-ur5/";
    if (data.isEmpty() || !QFile::exists(folder)) QSKIP("HANDWHEEL_DATA is not set or has no motionbenchmaker-ur5.");
    constexpr double kDigits = 5.1e-10;
    for (const char* name :
         {"bookshelf_small", "bookshelf_tall", "bookshelf_thin", "box", "cage", "table_pick", "table_under_pick"}) {
      const QString stem = QString::fromLatin1(name) + "_ur5";
      const auto set = readPlanningSet(textOfFile(folder + stem + ".json"));
      const auto pair =
          readMoveItProblem(textOfFile(folder + "raw/" + stem + "_scene0001.yaml"),
                            textOfFile(folder + "raw/" + stem + "_request0001.yaml"), stem.toStdString() + "_1");
      QVERIFY2(set && pair, name);
      QVERIFY(pair->joints == set->joints);
      const PlanningProblem &one = pair->problems.front(), &other = set->problems.front();
      QCOMPARE(one.name, other.name);
      QVERIFY(isNear(one.start, other.start, kDigits) && isNear(one.goal, other.goal, kDigits));
      QVERIFY(one.names == other.names);
      QCOMPARE(one.obstacles.size(), other.obstacles.size());
      for (std::size_t i = 0; i < one.obstacles.size(); ++i) {
        const CollisionPiece &a = one.obstacles[i], &b = other.obstacles[i];
        QCOMPARE(int(a.kind), int(b.kind));
        QVERIFY((a.half - b.half).norm() < 1e-6);
        QVERIFY((a.pose.matrix() - b.pose.matrix()).cwiseAbs().maxCoeff() <
                1e-5);  // mm: effect of nine digits over 2 m
      }
      QVERIFY(!one.allowed.empty());
    }
  }
};

HANDWHEEL_TEST(MoveItProblemTest)
#include "MoveItProblemTest.moc"
