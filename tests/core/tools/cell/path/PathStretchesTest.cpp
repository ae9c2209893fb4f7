// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../ArmCell.h"
#include "TestClass.h"
#include "tools/cell/path/PathCheck.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr RobotScene::Nearest metBy(double distance) {
  return {.distance = distance, .link = 1, .otherLink = 3};
}

// Joint 1 goes to 0.4 rad along a line that three motions of 0.1, 0.1 and 0.2 rad follow, then on to 0.8 rad.
CheckedPath checkedLine() {
  CheckedPath checked;
  for (const double first : {0.0, 0.1, 0.2, 0.4, 0.8}) {
    ArmValues values = ArmValues::Zero(6);
    values[0] = first;
    checked.resolved.joints.push_back(values);
  }
  checked.resolved.waypointOf = {1, 1, 1, 2};
  checked.verification.certified.assign(4, false);
  return checked;
}

bool isStretchAt(const PathStretch& stretch, std::size_t waypoint, double from, double to, double distance) {
  return stretch.waypoint == waypoint && std::abs(stretch.from - from) < 1e-9 && std::abs(stretch.to - to) < 1e-9 &&
         stretch.deepest.distance == distance;
}

}  // namespace

// Collisions of short motions that follow a line are one where the same two things meet all the time.
class PathStretchesTest : public QObject {
  Q_OBJECT

 private slots:
  void takenTogether() {
    ArmCell cell;
    CheckedPath checked = checkedLine();
    const RobotScene::Nearest near{.distance = 2.0, .link = 2, .otherLink = 5};
    checked.verification.collisions = {{0, 0.5, 1.0, metBy(-1.0), 1.0},
                                       {1, 0.0, 1.0, metBy(-3.0), 0.5},
                                       {1, 0.5, 1.0, near, 1.0},
                                       {2, 0.0, 0.5, metBy(-2.0), 0.0},
                                       {3, 0.0, 1.0, metBy(-1.0), 0.5}};
    const std::vector<PathStretch> all = stretchesOf(checked, *cell.scene());
    QCOMPARE(all.size(), std::size_t{3});
    QVERIFY(isStretchAt(all[0], 1, 0.125, 0.75, -3.0));
    QVERIFY(isStretchAt(all[1], 1, 0.375, 0.5, 2.0));
    QVERIFY(isStretchAt(all[2], 2, 0.0, 1.0, -1.0));  // On the motion to another waypoint
    // The nearest position: for the first one, in the middle of its second motion.
    QCOMPARE(all[0].motion, std::size_t{1});
    QCOMPARE(all[0].deepestAt, 0.5);
    QCOMPARE(all[1].motion, std::size_t{1});
    QCOMPARE(all[1].deepestAt, 1.0);
    QCOMPARE(all[2].motion, std::size_t{3});
    QVERIFY(all[0].meets() && !all[1].meets() && all[2].meets());
    const PathFindings found = findingsOf(checked, *cell.scene(), 5.0);
    QCOMPARE(found.collisions, std::size_t{3});
    QCOMPARE(found.tooNear, std::size_t{1});
    QCOMPARE(found.listed.size(), std::size_t{3});
    QCOMPARE(found.listed[0].distance, 0.0);
    QCOMPARE(found.listed[1].distance, 2.0);
  }

  // A collision that ends before a motion does, or begins later in the next one, is separate; so is one that pauses for
  // a motion.
  void apart() {
    ArmCell cell;
    CheckedPath checked = checkedLine();
    checked.verification.collisions = {{0, 0.0, 0.5, metBy(-1.0), 0.0}, {1, 0.0, 1.0, metBy(-1.0), 0.0}};
    QCOMPARE(stretchesOf(checked, *cell.scene()).size(), std::size_t{2});
    checked.verification.collisions = {{0, 0.0, 1.0, metBy(-1.0), 0.0}, {1, 0.5, 1.0, metBy(-1.0), 1.0}};
    QCOMPARE(stretchesOf(checked, *cell.scene()).size(), std::size_t{2});
    checked.verification.collisions = {{0, 0.0, 1.0, metBy(-1.0), 0.0}, {2, 0.0, 1.0, metBy(-1.0), 0.0}};
    QCOMPARE(stretchesOf(checked, *cell.scene()).size(), std::size_t{2});
  }

  // Motions of a line that are proven are between others that are not, while the two things stay nearer than the least
  // exact motion needs: that is one stay. Farther apart it is two.
  void combs() {
    ArmCell cell;
    cell.addBox({20, 20, 20}, {460.0, 0.0, 630.0});
    const auto scene = cell.scene();
    CheckedPath checked = checkedLine();
    for (ArmValues& each : checked.resolved.joints) each = scene->planned(cell.document().joints());
    const auto met = scene->scene.allTooNear(checked.resolved.joints[0], 500.0, 500.0);
    const auto box = std::ranges::find_if(met, [](const auto& each) { return each.otherLink == kNone; });
    QVERIFY(box != met.end() && box->distance > 0.0);
    checked.resolution = 0.05;
    checked.resolved.waypointOf.assign(checked.resolved.joints.size() - 1, 1);
    checked.resolved.offs.assign(checked.resolved.joints.size() - 1, 0.0);
    checked.resolved.offs[0] = 0.041;
    checked.verification.collisions = {{0, 0.0, 0.5, *box, 0.0}, {2, 0.5, 1.0, *box, 1.0}};
    checked.clearance = box->distance - 0.08;
    const std::vector<PathStretch> one = stretchesOf(checked, *scene);
    QCOMPARE(one.size(), std::size_t{1});
    // 0.041 mm rounded up to 0.05 mm, and 0.05 mm of the resolution.
    QVERIFY(std::abs(one[0].needed - checked.clearance - 0.1) < 1e-9 && one[0].deepest.distance < one[0].needed);
    checked.clearance = box->distance - 0.2;
    QCOMPARE(stretchesOf(checked, *scene).size(), std::size_t{2});
  }

  // A line that cannot be begun, and one on which nothing moves.
  void nothingMoves() {
    ArmCell cell;
    CheckedPath checked = checkedLine();
    checked.resolved.joints.resize(1);
    checked.resolved.waypointOf.clear();
    checked.verification.collisions = {{0, 0.0, 1.0, metBy(-1.0), 0.0}};
    QCOMPARE(stretchesOf(checked, *cell.scene()).size(), std::size_t{1});
    checked.resolved.joints.assign(3, ArmValues::Zero(6));
    checked.resolved.waypointOf = {1, 1};
    checked.verification.collisions = {{0, 0.0, 1.0, metBy(-1.0), 0.0}, {1, 0.0, 1.0, metBy(-2.0), 0.0}};
    const std::vector<PathStretch> all = stretchesOf(checked, *cell.scene());
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY(isStretchAt(all[0], 1, 0.0, 1.0, -2.0));
    QVERIFY(stretchesOf(CheckedPath(), *cell.scene()).empty());
  }
};

HANDWHEEL_TEST(PathStretchesTest)
#include "PathStretchesTest.moc"
