// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ClosedFormIk.h"

#include "Arms.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

double apart(double a, double b) {
  return std::abs(std::remainder(a - b, 2.0 * M_PI));
}

double apart(const ArmValues& a, const ArmValues& b) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i) largest = std::max(largest, apart(a[i], b[i]));
  return largest;
}

IkSolutions solutionsOf(const SerialArm& arm, const Pose& tip, const ArmValues& reference) {
  IkSolutions found;
  ClosedFormIk::of(arm).value().solve(tip, reference, found);
  return found;
}

}  // namespace

class ClosedFormIkTest : public QObject {
  Q_OBJECT

 private slots:
  void allOfTheLibrary_data() {
    QTest::addColumn<QString>("id");
    for (const LibraryRobot& each : robotLibrary()) QTest::newRow(each.id) << QString::fromLatin1(each.id);
  }

  // Every solution reaches the pose, the values that it was made from are among them, and no two are the same.
  void allOfTheLibrary() {
    QFETCH(QString, id);
    const SerialArm arm = libraryArm(id.toStdString());
    QVERIFY(ClosedFormIk::of(arm).has_value());
    QVERIFY(rc::check([&] {
      const ArmValues values = anyValuesOf(arm);
      const Pose tip = arm.tipPose(values);
      const IkSolutions found = solutionsOf(arm, tip, values);
      RC_ASSERT(found.count >= 1 && found.count <= 8);
      bool isAmong = false;
      for (const auto& solution : found) {
        RC_ASSERT(difference(arm.tipPose(solution.values), tip, arm.reach()) < 1e-7);
        isAmong = isAmong || apart(solution.values, values) < 1e-5;
        for (const auto& other : found) RC_ASSERT(&other == &solution || !(other.branch == solution.branch));
      }
      RC_ASSERT(isAmong);
    }));
  }

  // If the axes of the wrist are in line the joints keep the reference's share, and the pose is reached nevertheless.
  void singularWrist() {
    for (const char* id : {"irb120", "kr6r900", "ur5", "puma560"}) {
      const SerialArm arm = libraryArm(id);
      QVERIFY(rc::check([&] {
        ArmValues values = anyValuesOf(arm);
        values[4] = 0.0;
        const Pose tip = arm.tipPose(values);
        const IkSolutions found = solutionsOf(arm, tip, values);
        double nearest = 10.0;
        for (const auto& solution : found) {
          RC_ASSERT(difference(arm.tipPose(solution.values), tip, arm.reach()) < 1e-6);
          nearest = std::min(nearest, apart(solution.values, values));
        }
        RC_ASSERT(nearest < 1e-4);
      }));
    }
  }

  // The centre of the wrist on the first axis: the first joint stays where it is.
  void singularShoulder() {
    const SerialArm arm = libraryArm("irb140");
    ArmValues values = ArmValues::Zero(6);
    // a1 + a2 sin q2 + d4 cos(q2 + q3) = 0
    values << 0.7, -0.6, 0.0, 0.3, 0.8, -0.2;
    values[2] = std::acos((-70.0 + 360.0 * std::sin(0.6)) / 380.0) + 0.6;
    const Pose tip = arm.tipPose(values);
    const IkSolutions found = solutionsOf(arm, tip, values);
    QVERIFY(found.count > 0);
    double nearest = 10.0;
    for (const auto& solution : found) {
      QVERIFY(difference(arm.tipPose(solution.values), tip, arm.reach()) < 1e-6);
      nearest = std::min(nearest, apart(solution.values, values));
    }
    QVERIFY(nearest < 1e-3);
  }

  void stretchedAndOutOfReach() {
    const SerialArm arm = libraryArm("irb140");
    ArmValues stretched = ArmValues::Zero(6);
    stretched[2] = -M_PI / 2;
    const Pose tip = arm.tipPose(stretched);
    const IkSolutions found = solutionsOf(arm, tip, stretched);
    QVERIFY(found.count > 0);
    for (const auto& solution : found) QVERIFY(difference(arm.tipPose(solution.values), tip, arm.reach()) < 1e-6);
    Pose far = tip;
    far.translation() *= 10.0;
    QCOMPARE(solutionsOf(arm, far, stretched).count, std::size_t{0});
    far.translation().x() = std::nan("");
    QCOMPARE(solutionsOf(arm, far, stretched).count, std::size_t{0});
  }

  void otherArmsHaveNone() {
    std::vector<DhRow> rows(7, DhRow{.a = 100.0, .alpha = 1.0});
    QVERIFY(!ClosedFormIk::of(armOf(rows)));
    rows.pop_back();
    QVERIFY(!ClosedFormIk::of(armOf(rows)));
    rows[3].isPrismatic = true;
    QVERIFY(!ClosedFormIk::of(armOf(rows)));
    QVERIFY(!ClosedFormIk::of(armOf(std::vector<DhRow>(6))));  // a robot of size zero
  }

  // Whole turns lead into the limits, and as near to the reference as possible.
  void turnsIntoTheLimits() {
    const SerialArm arm = libraryArm("ur5");  // ±360°
    const ArmValues values = ArmValues::Constant(6, 0.5);
    const auto near = [&](double reference) {
      return withinLimits(arm, values, ArmValues::Constant(6, reference)).value()[0];
    };
    QVERIFY(std::abs(near(0.0) - 0.5) < 1e-12);
    QVERIFY(std::abs(near(-4.0) - (0.5 - 2 * M_PI)) < 1e-12);
    QVERIFY(std::abs(near(100.0) - 0.5) < 1e-12);  // a turn more would be beyond
    const SerialArm abb = libraryArm("irb120");    // joint 3: -110…70°
    ArmValues bent = ArmValues::Zero(6);
    bent[2] = 1.5;
    QVERIFY(!withinLimits(abb, bent, ArmValues::Zero(6)));
  }
};

HANDWHEEL_TEST(ClosedFormIkTest)
#include "ClosedFormIkTest.moc"
