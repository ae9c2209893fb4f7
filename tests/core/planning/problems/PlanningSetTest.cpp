// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/problems/PlanningSet.h"

#include "TestClass.h"

#include <QtTest>

using namespace handwheel;

namespace {

constexpr const char* kSet = R"({"robot": "r", "scene": "shelf", "joints": ["a", "b"], "problems": [
  {"index": 3, "start": [0, 1], "goal": [1, 0.5], "objects": [
    {"name": "s", "type": "box", "dimensions": [1, 2, 3], "position": [0.5, 0, 0], "orientation": [0, 0, 0, 2]},
    {"name": "c", "type": "cylinder", "dimensions": [0.2, 0.05], "position": [0, 0, 1], "orientation": [0, 0, 0, 1]},
    {"name": "b", "type": "sphere", "dimensions": [0.1], "position": [0, 0, 2], "orientation": [0, 0, 0, 1],
     "object_pose": {"position": [1, 0, 0], "orientation": [0, 1, 0, 0]}}]}]})";

std::string with(const char* what, const char* instead) {
  return QString::fromLatin1(kSet).replace(QLatin1String(what), QLatin1String(instead)).toStdString();
}

}  // namespace

class PlanningSetTest : public QObject {
  Q_OBJECT

 private slots:
  void metresBecomeMillimetres() {
    const auto set = readPlanningSet(kSet);
    QVERIFY(set.hasValue());
    QCOMPARE(set->name, std::string("shelf"));
    QCOMPARE(set->problems.size(), std::size_t{1});
    const PlanningProblem& problem = set->problems[0];
    QCOMPARE(problem.name, std::string("shelf_3"));
    QCOMPARE(problem.goal[1], 0.5);
    QCOMPARE(problem.obstacles.size(), std::size_t{3});
    QVERIFY(problem.obstacles[0].half == Vec3(500, 1000, 1500));
    QVERIFY(problem.obstacles[0].pose.isApprox(Pose(Eigen::Translation3d(500, 0, 0))));  // quaternions need no length
    QVERIFY(problem.obstacles[1].half == Vec3(50, 0, 100));  // the height first, as MoveIt has it
    QCOMPARE(problem.obstacles[2].half.x(), 100.0);
    QVERIFY((problem.obstacles[2].centre - Vec3(1000, 0, -2000)).norm() < 1e-9);  // half a turn about y first
  }

  void damage_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("instead");
    QTest::newRow("no list") << "\"problems\": ["
                             << "\"other\": [";
    QTest::newRow("too few") << "\"start\": [0, 1]"
                             << "\"start\": [0]";
    QTest::newRow("words") << "\"start\": [0, 1]"
                           << "\"start\": [0, \"1\"]";
    QTest::newRow("far away") << "[0.5, 0, 0]"
                              << "[5e99, 0, 0]";
    QTest::newRow("no turn") << "[0, 0, 0, 2]"
                             << "[0, 0, 0, 0]";
    QTest::newRow("less than nothing") << "[1, 2, 3]"
                                       << "[1, -2, 3]";
    QTest::newRow("unknown") << "\"sphere\""
                             << "\"cone\"";
    QTest::newRow("cut off") << "}]})"
                             << "";
  }

  void damage() {
    QFETCH(QString, what);
    QFETCH(QString, instead);
    const std::string text = with(what.toLatin1().constData(), instead.toLatin1().constData());
    if (what == QStringLiteral("}]})"))
      QVERIFY(!readPlanningSet(std::string(kSet).substr(0, 100)));
    else
      QVERIFY(!readPlanningSet(text));
  }
};

HANDWHEEL_TEST(PlanningSetTest)
#include "PlanningSetTest.moc"
