// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ReachSection.h"

#include "Arms.h"
#include "TestClass.h"

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kHeight = 200.0, kUpper = 300.0, kFore = 200.0;  // mm

// A turn about the upright axis, then a shoulder and an elbow about level axes: the tip is in a plane through the axis.
SerialArm threeJoints(double lower, double upper) {
  std::vector<DhRow> rows(3);
  rows[0] = {.alpha = M_PI / 2, .d = kHeight};
  rows[1] = {.a = kUpper};
  rows[2] = {.a = kFore, .lower = lower, .upper = upper};
  return armOf(rows);
}

ArmValues bent() {
  ArmValues values(3);
  values << 0.3, 0.2, 0.7;
  return values;
}

double fromShoulder(const Vec3& position) {
  return (position - Vec3(0.0, 0.0, kHeight)).norm();
}

// Returns twice the signed area inside a closed line, in the plane of x and z.
double twiceArea(const std::vector<Vec3>& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += line[i - 1].x() * line[i].z() - line[i].x() * line[i - 1].z();
  return sum;
}

}  // namespace

// Tests outlines of the reach that are known.
class ReachSectionTest : public QObject {
  Q_OBJECT

 private slots:
  // Without limits it is a ring about the shoulder.
  void aRing() {
    const auto lines = reachSection(threeJoints(-INFINITY, INFINITY), Pose::Identity(), bent(), Vec3::UnitX());
    QCOMPARE(lines.size(), std::size_t{2});
    for (const std::vector<Vec3>& line : lines) {
      QVERIFY(line.size() > 20 && line.front() == line.back());
      const double radius = fromShoulder(line.front()) > 200.0 ? kUpper + kFore : kUpper - kFore;
      for (const Vec3& position : line) {
        QVERIFY(std::abs(position.y()) < 1e-9);
        QVERIFY2(std::abs(fromShoulder(position) - radius) < 2.0, qPrintable(QString::number(fromShoulder(position))));
      }
    }
    // Both go round the shoulder, with the reached region on the same side: in opposite directions.
    QVERIFY(twiceArea(lines[0]) * twiceArea(lines[1]) < 0.0);
    const double area = 0.5 * std::abs(twiceArea(lines[0]) + twiceArea(lines[1]));
    const double exact = M_PI * (500.0 * 500.0 - 100.0 * 100.0);
    QVERIFY(std::abs(area - exact) < 0.02 * exact);
  }

  // An elbow that cannot fold: the hole is larger (the law of cosines).
  void limitsOfTheElbow() {
    const auto lines = reachSection(threeJoints(-1.5, 1.5), Pose::Identity(), bent(), Vec3::UnitX());
    QCOMPARE(lines.size(), std::size_t{2});
    const double inner = std::sqrt(kUpper * kUpper + kFore * kFore + 2.0 * kUpper * kFore * std::cos(1.5));
    double least = 1e9, most = 0.0;
    for (const std::vector<Vec3>& line : lines) {
      for (const Vec3& position : line) {
        least = std::min(least, fromShoulder(position));
        most = std::max(most, fromShoulder(position));
      }
    }
    QVERIFY(std::abs(least - inner) < 2.0);
    QVERIFY(std::abs(most - (kUpper + kFore)) < 2.0);
  }

  // In another plane through the axis, with a tool that makes the forearm longer.
  void planeAndTool() {
    const Pose tool(Eigen::Translation3d(50.0, 0.0, 0.0));
    const Vec3 direction(1.0, 2.0, 5.0);
    const auto lines = reachSection(threeJoints(-INFINITY, INFINITY), tool, bent(), direction);
    QVERIFY(!lines.empty());
    double most = 0.0;
    for (const std::vector<Vec3>& line : lines) {
      for (const Vec3& position : line) {
        QVERIFY(std::abs(position.dot(Vec3(-2.0, 1.0, 0.0))) < 1e-6);
        most = std::max(most, fromShoulder(position));
      }
    }
    QVERIFY(std::abs(most - 550.0) < 2.0);
  }

  // Every point of the outline of a real arm is reached, and no pose of it is farther out than the outline.
  void aRealArm() {
    const SerialArm arm = libraryArm("irb120");
    const auto lines = reachSection(arm, Pose::Identity(), ArmValues::Zero(6), Vec3::UnitX());
    QVERIFY(!lines.empty());
    double highest = 0.0, widest = 0.0;
    for (const std::vector<Vec3>& line : lines) {
      for (const Vec3& position : line) {
        highest = std::max(highest, position.z());
        widest = std::max(widest, std::abs(position.x()));
      }
    }
    QVERIFY(rc::check([&] {
      const Vec3 tip = arm.tipPose(anyValuesOf(arm)).translation();
      RC_ASSERT(tip.z() < highest + 2.0);
      RC_ASSERT(std::hypot(tip.x(), tip.y()) < widest + 2.0);
    }));
  }

  void nothing() {
    QVERIFY(reachSection(SerialArm({}, Pose::Identity()), Pose::Identity(), ArmValues(0), Vec3::UnitX()).empty());
    JobState cancelled;
    cancelled.cancelled = true;
    QVERIFY(reachSection(threeJoints(-2, 2), Pose::Identity(), bent(), Vec3::UnitX(), {}, Progress(cancelled)).empty());
  }
};

HANDWHEEL_TEST(ReachSectionTest)
#include "ReachSectionTest.moc"
