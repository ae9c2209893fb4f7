// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ArmSolutions.h"

#include "Arms.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Shoulder = ArmConfiguration::Shoulder;

ArmConfiguration configurationOf(const SerialArm& arm, std::initializer_list<double> list) {
  ArmValues values(6);
  std::copy(list.begin(), list.end(), values.begin());
  return ClosedFormIk::of(arm)->configurationOf(arm, values);
}

}  // namespace

// Tests all IK solutions for a pose, and their descriptions.
class ArmSolutionsTest : public QObject {
  Q_OBJECT

 private slots:
  void reachAndOrder_data() {
    QTest::addColumn<QString>("id");
    for (const char* id : {"irb120", "kr6r900", "ur5", "tx40", "puma560"}) QTest::newRow(id) << QString(id);
  }
  // The present configuration is the first solution; each reaches the pose; the limits are those of the joints; no two
  // solutions have the same description.
  void reachAndOrder() {
    QFETCH(QString, id);
    const SerialArm arm = libraryArm(id.toStdString());
    QVERIFY(rc::check([&] {
      const ArmValues values = anyValuesOf(arm);
      RC_PRE(std::abs(values[2]) > 0.2 && std::abs(values[4]) > 0.2 && std::abs(std::abs(values[4]) - M_PI) > 0.2);
      const Pose tip = arm.tipPose(values);
      const std::vector<ArmSolution> solutions = solutionsFor(arm, tip, values);
      RC_ASSERT(!solutions.empty() && solutions.size() <= 8);
      RC_ASSERT((solutions.front().values - values).cwiseAbs().maxCoeff() < 1e-5);
      RC_ASSERT(solutions.front().distance < 1e-2);
      for (std::size_t i = 0; i < solutions.size(); ++i) {
        RC_ASSERT(difference(arm.tipPose(solutions[i].values), tip, arm.reach()) < 1e-6);
        RC_ASSERT(solutions[i].beyond.has_value() != arm.isWithinLimits(solutions[i].values));
        if (i > 0) RC_ASSERT(solutions[i].beyond.has_value() || !solutions[i - 1].beyond.has_value());
        for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!(*solutions[i].configuration == *solutions[j].configuration));
      }
    }));
  }

  // The configuration of an arm does not change while it turns on its base or about its flange.
  void stanceTurnsWithTheArm() {
    for (const char* id : {"irb140", "rx160", "ur10", "lrmate200id"}) {
      const SerialArm arm = libraryArm(id);
      const ClosedFormIk closed = *ClosedFormIk::of(arm);
      QVERIFY(rc::check([&] {
        ArmValues values = anyValuesOf(arm);
        const ArmConfiguration before = closed.configurationOf(arm, values);
        values[0] = evenlyBetween(-3.0, 3.0);
        values[5] = evenlyBetween(-3.0, 3.0);
        RC_ASSERT(closed.configurationOf(arm, values) == before);
      }));
    }
  }

  // By what one sees of an arm whose lower arm stands upright at 0 and leans ahead with the second joint, and whose
  // forearm points ahead at 0 and down with the third.
  void stancesOfAnUprightArm() {
    const SerialArm arm = libraryArm("irb120");
    const ArmConfiguration ahead = configurationOf(arm, {0.3, 0.2, 0.1, 0.0, 0.5, 0.0});
    QVERIFY(ahead.shoulder == Shoulder::Front && ahead.isElbowUp && !ahead.isWristFlipped);
    const ArmConfiguration flipped = configurationOf(arm, {0.3, 0.2, 0.1, M_PI, -0.5, 0.0});
    QVERIFY(flipped.shoulder == Shoulder::Front && flipped.isElbowUp && flipped.isWristFlipped);
    // Leaning back, its forearm over its back.
    QVERIFY(configurationOf(arm, {0.0, -1.5, -0.5, 0.0, 0.5, 0.0}).shoulder == Shoulder::Rear);
    // The lower arm lies ahead, the forearm points up from its end.
    const ArmConfiguration low = configurationOf(arm, {0.0, 1.7, -1.7, 0.0, 0.5, 0.0});
    QVERIFY(low.shoulder == Shoulder::Front && !low.isElbowUp);
  }

  // An arm of the other form: at 0 it lies along -x of its base, and its links are beside the axis; turned by half a
  // turn and folded over it reaches the same pose with the other shoulder.
  void shouldersOfAParallelArm() {
    const SerialArm arm = libraryArm("ur5");
    ArmValues values(6);
    values << 0.4, -1.0, 1.2, -0.5, 1.1, 0.2;
    int left = 0, right = 0;
    for (const ArmSolution& solution : solutionsFor(arm, arm.tipPose(values), values)) {
      left += solution.configuration->shoulder == Shoulder::Left ? 1 : 0;
      right += solution.configuration->shoulder == Shoulder::Right ? 1 : 0;
    }
    QVERIFY(left > 0);
    QCOMPARE(left, right);
  }

  void outOfReach() {
    const SerialArm arm = libraryArm("irb120");
    Pose far = Pose::Identity();
    far.translation() = Vec3(5000.0, 0.0, 0.0);
    QVERIFY(solutionsFor(arm, far, ArmValues::Zero(6)).empty());
  }

  // An arm of three joints: the pose if it can reach it, otherwise the position in all its solutions, which are its
  // elbow up and down, ahead and over its back; and the orientation error of each.
  void positionsOfAShortArm() {
    const SerialArm arm = armOf(std::vector<DhRow>{{.alpha = M_PI / 2, .d = 200.0, .lower = -3.0, .upper = 3.0},
                                                   {.a = 300.0, .lower = -3.0, .upper = 3.0},
                                                   {.a = 250.0, .lower = -2.5, .upper = 2.5}});
    ArmValues values(3);
    values << 0.3, 0.4, 1.1;
    const Pose tip = arm.tipPose(values);
    const std::vector<ArmSolution> same = solutionsFor(arm, tip, values);
    QCOMPARE(same.size(), std::size_t{1});
    QVERIFY((same.front().values - values).norm() < 1e-6 && same.front().turnedOff < 1e-6);
    Pose turned = tip;
    turned.rotate(Eigen::AngleAxisd(0.4, Vec3::UnitX()));  // about the forearm, which it cannot
    const std::vector<ArmSolution> solutions = solutionsFor(arm, turned, values);
    QCOMPARE(solutions.size(), std::size_t{4});
    for (const ArmSolution& solution : solutions) {
      const Pose there = arm.tipPose(solution.values);
      QVERIFY((there.translation() - tip.translation()).norm() < 1e-3 && arm.isWithinLimits(solution.values));
      const double angle = Eigen::AngleAxisd(there.linear().transpose() * turned.linear()).angle();
      QVERIFY(std::abs(solution.turnedOff - angle) < 1e-6);
    }
    QVERIFY((solutions.front().values - values).norm() < 1e-4 && std::abs(solutions.front().turnedOff - 0.4) < 1e-4);
    turned.translation() *= 5.0;
    QVERIFY(solutionsFor(arm, turned, values).empty());
  }

  // The joint that is blamed is the one that no turn brings within its limits: joint 1 may go on by whole turns, and is
  // within its own.
  void theJointThatFails() {
    const DhTable& table = *libraryTable("irb120");
    std::vector<DhRow> rows(table.joints.begin(), table.joints.end());
    rows[0].lower = -400.0 * M_PI / 180.0;
    rows[0].upper = 400.0 * M_PI / 180.0;
    rows[5].lower = 0.01;
    rows[5].upper = 0.02;
    const SerialArm arm = armOf(rows);
    ArmValues values(6), reference(6);
    values << 1.75, 0.2, 0.1, 0.3, 0.5, 1.0;
    reference << 6.8, 0.2, 0.1, 0.3, 0.5, 1.0;  // 390 degrees: one turn on, joint 1 would be at 460
    const auto found = solutionsFor(arm, arm.tipPose(values), reference);
    QVERIFY(!found.empty());
    for (const ArmSolution& each : found) {
      QVERIFY(each.beyond && *each.beyond > 0);
      QVERIFY(arm.joints()[0].isWithin(each.values[0]));
      QVERIFY(!arm.joints()[static_cast<std::size_t>(*each.beyond)].isWithin(each.values[*each.beyond]));
    }
  }

  // Without a closed form: the known solution is found, and others that are different.
  void byIteration() {
    std::vector<DhRow> rows(7, DhRow{.a = 100.0, .alpha = 1.2, .d = 60.0, .lower = -2.5, .upper = 2.5});
    const SerialArm arm = armOf(rows);
    QVERIFY(!ClosedFormIk::of(arm));
    QVERIFY(rc::check([&] {
      const ArmValues values = anyValuesOf(arm);
      const Pose tip = arm.tipPose(values);
      const std::vector<ArmSolution> solutions = solutionsFor(arm, tip, values);
      RC_ASSERT(!solutions.empty() && solutions.size() <= kMostNumericalSolutions);
      RC_ASSERT((solutions.front().values - values).cwiseAbs().maxCoeff() < 1e-5);
      for (std::size_t i = 0; i < solutions.size(); ++i) {
        RC_ASSERT(arm.isWithinLimits(solutions[i].values) && !solutions[i].configuration && !solutions[i].beyond);
        RC_ASSERT(difference(arm.tipPose(solutions[i].values), tip, arm.reach()) < 1e-6);
        for (std::size_t j = 0; j < i; ++j)
          RC_ASSERT((solutions[i].values - solutions[j].values).cwiseAbs().maxCoeff() > 0.01);
      }
    }));
  }
};

HANDWHEEL_TEST(ArmSolutionsTest)
#include "ArmSolutionsTest.moc"
