// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/device/PoseTrajectory.h"

#include <QtTest>
#include <limits>

using namespace handwheel;

class PoseTrajectoryTest : public QObject {
  Q_OBJECT

 private slots:
  void goesStraightAndTurnsByTheSmallerAngle() {
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(1.0, Vec3::UnitZ()));
    const PoseTrajectory path({{1.0, {0, 0, 0}, Eigen::Quaterniond::Identity(), 1},
                               {3.0, {10, 20, 0}, Eigen::Quaterniond(-turned.coeffs()), 2}});
    const HandPose middle = path.at(1.5);
    QVERIFY((middle.position - Vec3(2.5, 5, 0)).norm() < 1e-12);
    QVERIFY(middle.orientation.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(0.25, Vec3::UnitZ()))) < 1e-7);
    QCOMPARE(middle.buttons, 1u);
    QCOMPARE(path.at(3.0).buttons, 2u);
    QCOMPARE(path.duration(), 3.0);
  }

  void restsBeforeAndAfter() {
    const PoseTrajectory path({{1.0, {1, 0, 0}, Eigen::Quaterniond::Identity(), 1}, {2.0, {2, 0, 0}}});
    const double inf = std::numeric_limits<double>::infinity();
    for (const double t : {-inf, -5.0, 0.999}) QCOMPARE(path.at(t).position, Vec3(1, 0, 0));
    for (const double t : {2.0, 5.0, inf}) QCOMPARE(path.at(t).position, Vec3(2, 0, 0));
  }

  // Two poses at one time: the hand is at the second.
  void leapsWhereTimesAreEqual() {
    const PoseTrajectory path({{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}, {1.0, {5, 0, 0}}, {2.0, {6, 0, 0}}});
    QVERIFY((path.at(0.5).position - Vec3(0.5, 0, 0)).norm() < 1e-12);
    QCOMPARE(path.at(1.0).position, Vec3(5, 0, 0));
    QVERIFY((path.at(1.5).position - Vec3(5.5, 0, 0)).norm() < 1e-12);
  }

  void empty() {
    QVERIFY(PoseTrajectory().isEmpty());
    QCOMPARE(PoseTrajectory().duration(), 0.0);
  }
};

HANDWHEEL_TEST(PoseTrajectoryTest)
#include "PoseTrajectoryTest.moc"
