// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellScene.h"
#include "document/cell/RobotChanges.h"
#include "robot/dh/DhTable.h"

#include <rapidcheck.h>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Met = std::set<std::pair<std::uint32_t, std::uint32_t>>;  // a link of the robot, an owner

}  // namespace

// A robot that is dragged by its base meets what it would meet if it stood there.
class MovedRobotTest : public QObject {
  Q_OBJECT

 private slots:
  void asIfItStoodThere() {
    ArmCell cell;
    RobotCellDocument& document = cell.document();
    auto robots =
        withRobotAdded(cell.content(), {cellOf(*libraryTable("ur5")), "", poseOf({0, 1500, 0}, Vec3::Zero())});
    document.commit("Add", document.robotsEdit(std::move(robots).value()));
    cell.addBox({900, 900, 900}, {400, 600, 400});
    const RobotCellSnapshot now = cell.content();
    CollisionMeshes meshes;
    const CellScene scene = std::move(sceneOf(now, meshes, 1)).value();
    int hits = 0;
    const bool isSame = rc::check("a dragged base shows what it will meet", [&] {
      const auto between = [](int least, int most) { return 1.0 * *rc::gen::inRange(least, most); };
      const Pose base =
          poseOf({between(-700, 700), between(0, 1500), between(-200, 200)}, {0.0, 0.0, 0.01 * between(-300, 300)});
      const Pose displacement = base * basePose(now.robot->model, now.robot->arms[1]).inverse(Eigen::Isometry);
      Met shown, real;
      for (const auto& each : scene.scene.metWhenMoved(scene.planned(now.joints), displacement)) {
        if (isMoved(scene, each.link)) shown.insert({each.link, each.owner});
      }
      const RobotCellSnapshot there = withRobotMoved(now, 1, base).value();
      const CellScene moved = std::move(sceneOf(there, meshes, 1)).value();
      for (const auto& each : moved.scene.allTooNear(moved.planned(there.joints), 0.0, 0.0)) {
        if (each.owner != kNone) real.insert({each.link, each.owner});
      }
      hits += real.empty() ? 0 : 1;
      RC_ASSERT(shown == real);
    });
    QVERIFY(isSame);
    QVERIFY(hits > 10);  // the draws are not idle
  }

  // If its time is over it returns the collisions found so far.
  void ends() {
    ArmCell cell;
    cell.addBox({3000, 3000, 3000}, {0, 0, 0});
    const auto scene = cell.scene();
    const ArmValues at = scene->planned(cell.document().joints());
    QVERIFY(scene->scene.metWhenMoved(at, poseOf({1, 0, 0}, Vec3::Zero()), [] { return true; }).empty());
    QVERIFY(!scene->scene.metWhenMoved(at, poseOf({1, 0, 0}, Vec3::Zero())).empty());
  }

 private:
  // Parts that stand are left out where nothing is moved.
  static bool isMoved(const CellScene& scene, std::uint32_t link) {
    const RobotModel& robot = scene.robot->model;
    for (std::uint32_t l = link; robot.links[l].parentJoint != kNone;
         l = robot.joints[robot.links[l].parentJoint].parent) {
      const std::uint32_t dof = robot.joints[robot.links[l].parentJoint].dof;
      if (std::find(scene.dofs.begin(), scene.dofs.end(), dof) != scene.dofs.end()) return true;
    }
    return false;
  }
};

HANDWHEEL_TEST(MovedRobotTest)
#include "MovedRobotTest.moc"
