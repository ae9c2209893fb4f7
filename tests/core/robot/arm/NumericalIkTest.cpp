// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/NumericalIk.h"

#include "Arms.h"
#include "TestClass.h"
#include "robot/arm/IkFidelity.h"

#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns settings with enough time for all starts, even on a busy machine.
NumericalIkSettings patient() {
  NumericalIkSettings settings;
  settings.seconds = 60.0;
  settings.mostStarts = 500;
  return settings;
}

}  // namespace

class NumericalIkTest : public QObject {
  Q_OBJECT

 private slots:
  void reachesWhatCanBeReached_data() {
    QTest::addColumn<QString>("id");
    for (const LibraryRobot& each : robotLibrary()) QTest::newRow(each.id) << QString::fromLatin1(each.id);
  }

  void reachesWhatCanBeReached() {
    QFETCH(QString, id);
    const SerialArm arm = libraryArm(id.toStdString());
    QVERIFY(rc::check([&] {
      const Pose tip = arm.tipPose(anyValuesOf(arm));
      const NumericalIkResult found = solvedNumerically(arm, tip, arm.middle(), patient());
      RC_ASSERT(found.isSolved && arm.isWithinLimits(found.values));
      RC_ASSERT(difference(arm.tipPose(found.values), tip, 1000.0) < 2e-5);
      RC_ASSERT(found.distance < 2e-2 && found.angle < 2e-5);
    }));
  }

  // Each of the six numbers of the error is within the tolerance, at every preset and both ends of the setting.
  void asNearAsTheTolerance() {
    const FidelitySetting setting = ikToleranceSetting();
    QCOMPARE(setting.standard, NumericalIkSettings().tolerance);
    std::vector<double> tolerances{setting.least, setting.largest};
    tolerances.insert(tolerances.end(), setting.presets.begin(), setting.presets.end());
    const SerialArm arm = libraryArm("irb120");
    QVERIFY(rc::check([&] {
      const Pose tip = arm.tipPose(anyValuesOf(arm));
      NumericalIkSettings settings = patient();
      settings.tolerance = *rc::gen::elementOf(tolerances);
      const NumericalIkResult found = solvedNumerically(arm, tip, arm.middle(), settings);
      RC_ASSERT(found.isSolved);
      const double most = std::sqrt(3.0) * settings.tolerance + 1e-12;
      RC_ASSERT(found.angle <= most && found.distance <= 1000.0 * most);
    }));
  }

  // Redundant arms, too, with slides among their joints.
  void longerArms() {
    QVERIFY(rc::check([] {
      const SerialArm arm = anyArm(*rc::gen::inRange(7, 21));
      const Pose tip = arm.tipPose(anyValuesOf(arm));
      const NumericalIkResult found = solvedNumerically(arm, tip, arm.middle(), patient());
      RC_ASSERT(found.isSolved && arm.isWithinLimits(found.values));
      RC_ASSERT(difference(arm.tipPose(found.values), tip, 1000.0) < 2e-5);
    }));
  }

  // An arm of three joints reaches positions, not poses.
  void positionsOnly() {
    const SerialArm arm = armOf(std::vector<DhRow>{{.alpha = M_PI / 2, .d = 200.0, .lower = -3.0, .upper = 3.0},
                                                   {.a = 300.0, .lower = -2.0, .upper = 2.0},
                                                   {.a = 250.0, .lower = -2.5, .upper = 2.5}});
    NumericalIkSettings settings = patient();
    settings.turnWeight = 0.0;
    QVERIFY(rc::check([&] {
      Pose tip = arm.tipPose(anyValuesOf(arm));
      tip.linear() = Eigen::AngleAxisd(1.0, Vec3(1, 2, 3).normalized()).toRotationMatrix();
      const NumericalIkResult found = solvedNumerically(arm, tip, arm.middle(), settings);
      RC_ASSERT(found.isSolved && found.distance < 2e-2);
    }));
  }

  // At the position, with the nearest possible orientation: a SCARA led by a tilted hand turns about its axis as the
  // hand does, a pointer of two revolute joints ends at the position for any orientation.
  void positionFirst() {
    const SerialArm scara = armOf(std::vector<DhRow>{{.a = 300.0, .d = 400.0, .lower = -2.5, .upper = 2.5},
                                                     {.a = 200.0, .lower = -2.5, .upper = 2.5},
                                                     {.isPrismatic = true, .lower = -150.0, .upper = 0.0},
                                                     {.lower = -3.0, .upper = 3.0}});
    QVERIFY(rc::check([&] {
      ArmValues values(4), start(4);
      values << evenlyBetween(-1, 1), evenlyBetween(0.5, 2), evenlyBetween(-140, -10), evenlyBetween(-1, 1);
      start << values[0] + 0.05, values[1] - 0.05, values[2] + 5.0, values[3] + 0.1;
      Pose tip = scara.tipPose(values);
      const double tilt = evenlyBetween(-0.5, 0.5);
      const Vec3 aside(std::cos(evenlyBetween(-3, 3)), 0.3, 0.0);
      tip.linear() = Eigen::AngleAxisd(tilt, aside.normalized()) * tip.linear();
      RC_ASSERT(std::abs(tilt) < 1e-3 || !solvedNumerically(scara, tip, start, {.mostStarts = 1}).isSolved);
      const NumericalIkResult found = solvedForPosition(scara, tip, start, {.seconds = 60.0, .mostStarts = 1});
      // A tilt about a perpendicular axis is all that is left if the turn about z is right: no turn about z is nearer.
      RC_ASSERT(found.isSolved && found.distance < 2e-2);
      RC_ASSERT(std::abs(found.angle - std::abs(tilt)) < 1e-2 && (found.values - values).norm() < 0.05);
    }));
    const SerialArm pointer = armOf(std::vector<DhRow>{{.alpha = M_PI / 2, .d = 200.0, .lower = -3.0, .upper = 3.0},
                                                       {.a = 300.0, .lower = -2.0, .upper = 2.0}});
    Pose tip = pointer.tipPose(ArmValues::Constant(2, 0.4));
    tip.rotate(Eigen::AngleAxisd(2.0, Vec3(1, 2, 3).normalized()));
    const NumericalIkResult found = solvedForPosition(pointer, tip, ArmValues::Constant(2, 0.3), patient());
    QVERIFY(found.isSolved && found.distance < 2e-2);
    tip.translation() *= 3.0;
    QVERIFY(!solvedForPosition(pointer, tip, ArmValues::Constant(2, 0.3), {.mostStarts = 3}).isSolved);
  }

  // No input makes it leave its limits, or return values that are not finite.
  void extremes() {
    NumericalIkSettings settings;
    settings.mostStarts = 3;
    const SerialArm arm = libraryArm("irb2400");
    Pose far = Pose::Identity();
    far.translation() = Vec3(1e9, 0, 0);
    const NumericalIkResult beyond = solvedNumerically(arm, far, arm.middle(), settings);
    QVERIFY(!beyond.isSolved && beyond.values.allFinite() && arm.isWithinLimits(beyond.values));
    far.translation().x() = std::nan("");
    QVERIFY(!solvedNumerically(arm, far, arm.middle(), settings).isSolved);
    // Links of length zero: any position but its own is out of reach.
    const SerialArm point = armOf(std::vector<DhRow>(6));
    const NumericalIkResult still = solvedNumerically(point, Pose::Identity(), ArmValues::Zero(6), settings);
    QVERIFY(still.isSolved);
    // Limits that are equal: the joint stays there.
    std::vector<DhRow> rows(6, DhRow{.a = 100.0, .alpha = 1.0, .lower = -2.0, .upper = 2.0});
    rows[2].lower = rows[2].upper = 0.5;
    const SerialArm stiff = armOf(rows);
    const NumericalIkResult held =
        solvedNumerically(stiff, stiff.tipPose(ArmValues::Constant(6, 0.5)), stiff.middle(), patient());
    QVERIFY(held.isSolved && held.values[2] == 0.5);
    // No joints at all.
    const SerialArm none = armOf({});
    QVERIFY(solvedNumerically(none, Pose::Identity(), ArmValues(), settings).isSolved);
  }

  void theSameSeedGivesTheSame() {
    const SerialArm arm = libraryArm("ur10");
    ArmValues values = ArmValues::Constant(6, 1.0);
    const Pose tip = arm.tipPose(values);
    const auto a = solvedNumerically(arm, tip, arm.middle(), patient());
    const auto b = solvedNumerically(arm, tip, arm.middle(), patient());
    QVERIFY(a.values == b.values && a.iterations == b.iterations);
  }
};

HANDWHEEL_TEST(NumericalIkTest)
#include "NumericalIkTest.moc"
