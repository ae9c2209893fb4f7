// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellScene.h"

#include "Cells.h"
#include "TestClass.h"
#include "document/cell/CellImport.h"
#include "robot/dh/DhTable.h"
#include "scene/PrimitiveGeometry.h"

#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

std::shared_ptr<RobotCellSnapshot> withBody(const RobotCellSnapshot& cell, Primitive primitive,
                                            std::vector<double> dimensions, const Vec3& at) {
  auto changed = std::make_shared<RobotCellSnapshot>(cell);
  Body body;
  body.id = 7;
  body.name = "thing";
  body.pose = Pose(Eigen::Translation3d(at));
  body.geometry = *PrimitiveGeometry::make(primitive, std::move(dimensions));
  changed->bodies = changed->bodies.with(std::make_shared<const Body>(std::move(body)));
  return changed;
}

}  // namespace

// A cell prepared for planning: its distances are those of its shapes.
class CellSceneTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    std::string urdf = kArmUrdf;
    const std::string mimic = "<mimic joint='turn' multiplier='0.5'/>";
    urdf.replace(urdf.find(mimic), mimic.size(), "");  // a claw of its own, which is not planned
    write(m_package.urdf(), urdf);
  }

  // The arm is a box from x 0 to 500 mm, 100 mm wide; beside it a ball, exact though it is drawn with flat faces.
  void distanceOfABall() {
    const auto cell = withBody(cellIn(importOrThrow(m_package.urdf())), Primitive::Sphere, {50.0}, {250.0, 200.0, 0.0});
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(*cell, meshes);
    QVERIFY(scene.hasValue());
    QCOMPARE(scene->dofs.size(), std::size_t{2});
    const RobotScene::Nearest nearest = scene->scene.nearest(scene->planned(values({0.0, 0.0, 0.0})), 1e3);
    QVERIFY(std::abs(nearest.distance - 100.0) < 1e-3);
    QCOMPARE(scene->namesOf(nearest).first, std::string("upper"));
    QCOMPARE(scene->namesOf(nearest).second, std::string("thing"));
    QVERIFY(scene->missing.empty());
  }

  void allowedPairs() {
    auto cell = withBody(cellIn(importOrThrow(m_package.urdf())), Primitive::Cuboid, {10.0, 10.0, 10.0}, {100.0, 0, 0});
    CollisionMeshes meshes;
    const Result<CellScene> meeting = sceneOf(*cell, meshes);
    QVERIFY(meeting.hasValue());
    QVERIFY(meeting->scene.nearest(meeting->planned(values({0.0, 0.0, 0.0})), 1.0).distance <= 0.0);
    CellPlans plans;
    plans.allowed.insert({"upper", "body.7"});
    cell->plans = std::make_shared<const CellPlans>(plans);
    const Result<CellScene> allowed = sceneOf(*cell, meshes);
    QVERIFY(allowed.hasValue());
    QVERIFY(allowed->scene.nearest(allowed->planned(values({0.0, 0.0, 0.0})), 1.0).distance > 0.0);
  }

  // A body that the robot carries and that is turned into its arm collides with it, also at rest; but not with its
  // carrier.
  void aToolInTheArm() {
    const auto cell = cellOf(*libraryTable("irb120"));
    auto changed = std::make_shared<RobotCellSnapshot>(*cell);
    Body bar{.id = 3, .name = "bar", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {300.0, 20.0, 20.0})};
    bar.carrier = "flange";
    bar.pose.translation() = Vec3(0.0, 0.0, -150.0);  // back into the forearm
    bar.pose.rotate(Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitY()));
    changed->bodies = changed->bodies.with(std::make_shared<const Body>(std::move(bar)));
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(*changed, meshes);
    QVERIFY(scene.hasValue());
    JointValues bent = changed->joints;
    bent[4] = 1.0;
    for (const JointValues& joints : {changed->joints, bent}) {
      bool isFound = false;
      for (const auto& pair : scene->scene.allTooNear(scene->planned(joints), 0.0, 0.0))
        isFound = isFound || scene->namesOf(pair).first == "bar" || scene->namesOf(pair).second == "bar";
      QVERIFY(isFound);
    }
  }

  // A ball of 20 mm on the tool, 500 mm out on the arm: it goes where the joints bring it, and is measured against what
  // stands there, but not against the link that carries it.
  void carriedBodies() {
    auto cell = withBody(cellIn(importOrThrow(m_package.urdf())), Primitive::Sphere, {20.0}, {0.0, 0.0, 0.0});
    Body ball = *cell->bodies.withId(7);
    ball.carrier = "tool0";
    Body wall{.id = 8, .name = "wall", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {2000.0, 10.0, 500.0})};
    wall.pose.translation() = Vec3(0, 705, 0);
    cell->bodies = cell->bodies.with(std::make_shared<const Body>(ball)).with(std::make_shared<const Body>(wall));
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(*cell, meshes);
    QVERIFY(scene.hasValue());
    for (const double turn : {0.7, 1.2, 1.5}) {
      const RobotScene::Nearest nearest = scene->scene.nearest(scene->planned(values({100.0, turn, 0.0})), 1e3);
      QVERIFY(std::abs(nearest.distance - (700.0 - 500.0 * std::sin(turn) - 20.0)) < 1e-3);
      QCOMPARE(scene->namesOf(nearest).first, std::string("thing"));
      QCOMPARE(scene->namesOf(nearest).second, std::string("wall"));
      QVERIFY(scene->bodyOfLink(nearest.link) == std::optional<BodyId>(7));
    }
    auto allowed = std::make_shared<RobotCellSnapshot>(*cell);
    CellPlans plans;
    plans.allowed.insert({"body.7", "body.8"});
    allowed->plans = std::make_shared<const CellPlans>(plans);
    const Result<CellScene> without = sceneOf(*allowed, meshes);
    QVERIFY(without.hasValue());
    // A corner of the arm is what is nearest then: it reaches 250 mm out for collisions, and 50 mm to the side.
    const RobotScene::Nearest arm = without->scene.nearest(without->planned(values({100.0, 0.7, 0.0})), 1e3);
    QVERIFY(std::abs(arm.distance - (700.0 - 250.0 * std::sin(0.7) - 50.0 * std::cos(0.7))) < 1e-3);
    QCOMPARE(without->namesOf(arm).first, std::string("upper"));
  }

  void valuesOfTheWholeRobot() {
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(cellIn(importOrThrow(m_package.urdf())), meshes);
    QVERIFY(scene.hasValue());
    const JointValues joints = values({250.0, -1.5, 0.0});
    QVERIFY(scene->whole(scene->planned(joints)) == joints);
    QVERIFY(scene->areUnplannedJointsAt(joints));
    QVERIFY(!scene->areUnplannedJointsAt(values({250.0, -1.5, 0.5})));
  }

  // A hierarchy lives as long as its mesh, and is built once.
  void hierarchiesAreShared() {
    CollisionMeshes meshes;
    auto soup = std::make_shared<const TriangleSoup>(surfaceOf(BoxShape{{10, 10, 10}}));
    const auto first = meshes.of(soup);
    QVERIFY(meshes.of(soup) == first);
    soup = std::make_shared<const TriangleSoup>(surfaceOf(BoxShape{{20, 10, 10}}));
    QVERIFY(meshes.of(soup) != first);
  }

 private:
  ArmPackage m_package;
};

HANDWHEEL_TEST(CellSceneTest)
#include "CellSceneTest.moc"
