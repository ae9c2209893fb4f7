// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/HeldApproach.h"

#include "../ToolEvents.h"
#include "ArmCell.h"
#include "TestClass.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/RobotChanges.h"
#include "robot/Kinematics.h"
#include "robot/dh/DhTable.h"
#include "tools/cell/CellTool.h"
#include "tools/cell/PlaceBodyTool.h"

#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kStiffness = 0.2;  // N/mm, at the hand
const Vec3 kBox(0.0, 900.0, 0.0);   // mm: out of reach of the robot

PointerEvent ofHand(Kind kind, const Pose& pose) {
  PointerEvent event = above(kind, pose.translation().x(), pose.translation().y(), kControl);
  event.pixel = 1.0;
  event.device = pose;
  return event;
}

PointerEvent ofHand(Kind kind, const Vec3& position) {
  return ofHand(kind, Pose(Eigen::Translation3d(position)));
}

Pose at(const Vec3& position) {
  return Pose(Eigen::Translation3d(position));
}

// The force at the hand while its tip is there.
Vec3 forceAt(const Tool& tool, const Vec3& hand) {
  const std::vector<DeviceSpring> springs = tool.forces();
  return springs.empty() ? Vec3(Vec3::Zero()) : Vec3(springs.front().stiffness * (springs.front().target - hand));
}

// A cell with a box of 20 mm, and a wall 20 mm from it, towards x.
class WallCell : public ArmCell {
 public:
  WallCell() : box(addBox(Vec3::Constant(20.0), kBox)) { addBox({100.0, 1000.0, 1000.0}, kBox + Vec3(80.0, 0, 0)); }

  HeldApproachServices services() {
    HeldApproachServices services;
    services.scene = [this](std::optional<std::size_t> number) -> std::shared_ptr<const CellScene> {
      if (isUnderWay) return nullptr;
      if (!number) return scene();
      return std::make_shared<const CellScene>(std::move(sceneOf(content(), m_shapes, *number)).value());
    };
    services.settings = settings;
    return services;
  }
  PlaceBodyTool placing() {
    PlaceBodyServices holding;
    holding.pick = picking();
    holding.robot = [this] { return robot; };
    holding.approach = services();
    return {document(), selection, std::move(holding)};
  }
  CellTool moving() { return CellTool(document(), selection, picking(), {}, {}, services()); }
  JointDragTool::Pick picking() {
    return [this](const Ray& ray) -> std::optional<RobotCellPick> {
      if (picked.empty()) return std::nullopt;
      return RobotCellPick{picked, Vec3(ray.origin.x(), ray.origin.y(), 0.0)};
    };
  }
  BodyPointer body(BodyId id) { return document().bodies().withId(id); }

  BodyId box;
  BodySelection selection;
  std::string picked = "body.1";
  std::optional<std::size_t> robot;  // The selected robot
  bool isUnderWay = false;           // True if the cell is being prepared
  std::shared_ptr<ApproachSettings> settings = std::make_shared<ApproachSettings>();

 private:
  CollisionMeshes m_shapes;
};

}  // namespace

// The force at a hand that holds a body or a robot of a cell.
class HeldApproachTest : public QObject {
  Q_OBJECT

 private slots:
  // Nothing from afar; then the stiffness times the distance below the reach, away from the wall.
  void aBoxBeforeAWall() {
    WallCell cell;
    PlaceBodyTool tool = cell.placing();
    tool.pointer(ofHand(Kind::Press, kBox));
    QVERIFY(tool.forces().empty());
    for (const double by : {5.0, 10.0, 12.0, 16.0, 20.0, 23.0, 3.0}) {
      const Vec3 hand = kBox + Vec3(by, 0.0, 0.0);
      tool.pointer(ofHand(Kind::Drag, hand));
      const double gap = 20.0 - by;
      const Vec3 expected(-kStiffness * std::max(0.0, 10.0 - gap), 0.0, 0.0);
      QVERIFY2((forceAt(tool, hand) - expected).norm() < 1e-6, qPrintable(QString::number(by)));
      QCOMPARE(tool.forces().empty(), by <= 10.0);
      const auto settings = tool.settings();
      const Property* const clearance = propertyNamed(settings, "clearance");
      QCOMPARE(clearance != nullptr, by > 10.0);
      if (clearance) QVERIFY(std::abs(std::get<double>(clearance->value) - std::max(0.0, gap)) < 0.01);
    }
    tool.pointer(ofHand(Kind::Drag, Vec3(kBox + Vec3(16.0, 0.0, 0.0))));
    QVERIFY(!tool.forces().empty());
    tool.pointer(ofHand(Kind::Release, Vec3(kBox + Vec3(16.0, 0.0, 0.0))));
    QVERIFY(tool.forces().empty());
  }

  // Felt or not, from where on, and how much: also while it is held, and for the next tool.
  void settings() {
    WallCell cell;
    PlaceBodyTool tool = cell.placing();
    const Vec3 hand = kBox + Vec3(16.0, 0.0, 0.0);
    tool.pointer(ofHand(Kind::Press, kBox));
    tool.setSetting("reach", 14.0);
    tool.pointer(ofHand(Kind::Drag, hand));
    QVERIFY(std::abs(forceAt(tool, hand).x() + kStiffness * 10.0) < 1e-6);
    tool.setSetting("force", 1.5);
    tool.pointer(ofHand(Kind::Drag, hand));
    QVERIFY(std::abs(forceAt(tool, hand).x() + 1.5) < 1e-6);
    tool.setSetting("felt", false);
    QVERIFY(tool.forces().empty());
    tool.pointer(ofHand(Kind::Drag, hand));
    tool.pointer(ofHand(Kind::Release, kBox));
    PlaceBodyTool next = cell.placing();
    const auto kept = next.settings();
    QCOMPARE(std::get<bool>(propertyNamed(kept, "felt")->value), false);
    QCOMPARE(std::get<double>(propertyNamed(kept, "reach")->value), 14.0);
    QCOMPARE(std::get<double>(propertyNamed(kept, "force")->value), 1.5);
  }

  // A box that is turned comes with one edge nearer: the spring turns that edge away.
  void aTurnedBox() {
    WallCell cell;
    PlaceBodyTool tool = cell.placing();
    tool.pointer(ofHand(Kind::Press, kBox));
    for (const double turn : {0.3, -0.3}) {
      const double edge = 10.0 * (std::cos(turn) + std::sin(std::abs(turn)));  // its distance from the middle along x
      Pose hand = at(kBox + Vec3(30.0 - edge - 5.0, 0.0, 0.0));
      hand.linear() = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
      tool.pointer(ofHand(Kind::Drag, hand));
      const std::vector<DeviceSpring> springs = tool.forces();
      QCOMPARE(springs.size(), std::size_t(1));
      QVERIFY(std::abs(forceAt(tool, hand.translation()).x() + kStiffness * 5.0) < 1e-6);
      // The torque about z by the lever of that edge; a positive turn has it at negative y.
      const double lever = -std::copysign(10.0 * (std::cos(turn) - std::sin(std::abs(turn))), turn);
      const Eigen::AngleAxisd aside(springs.front().turn * Eigen::Quaterniond(hand.linear()).inverse());
      const double torque = springs.front().turning * aside.angle() * aside.axis().z();
      QVERIFY2(std::abs(torque - lever * kStiffness * 5.0) < 1e-3, qPrintable(QString::number(torque)));
    }
  }

  // A handle gives way along or about its axis only.
  void byHandles() {
    WallCell cell;
    cell.selection.select(cell.box);
    PlaceBodyTool tool = cell.placing();
    tool.setSetting("centre", 1.0);
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
      const Vec3 grip = kBox + 60.0 * axis;
      tool.pointer(ofHand(Kind::Hover, grip));
      tool.pointer(ofHand(Kind::Press, grip));
      const Vec3 hand = grip + Vec3(15.0, 3.0, 4.0);
      tool.pointer(ofHand(Kind::Drag, hand));
      const Vec3 expected(axis.x() > 0.0 ? -kStiffness * 5.0 : 0.0, 0.0, 0.0);
      QVERIFY((forceAt(tool, hand) - expected).norm() < 1e-6);
      QCOMPARE(tool.forces().empty(), axis.x() == 0.0);
      tool.perform("revert");
      QVERIFY(tool.forces().empty());
    }
    // The ring about z: a long box turns with its end towards the wall; by the lever of the hand.
    const BodyId beam = cell.addBox({8.0, 100.0, 8.0}, kBox + Vec3(-15.0, 0.0, 300.0));
    cell.selection.select(beam);
    const Vec3 centre = cell.body(beam)->pose.translation();
    tool.pointer(ofHand(Kind::Hover, centre));
    const double radius = tool.handles()->ringRadius(), from = M_PI + 0.7, turn = -0.75;
    const auto onRing = [&](double angle) {
      return Vec3(centre + radius * Vec3(std::cos(angle), std::sin(angle), 0.0));
    };
    tool.pointer(ofHand(Kind::Press, onRing(from)));
    const Vec3 hand = onRing(from + turn);
    tool.pointer(ofHand(Kind::Drag, hand));
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
    const Vec3 corner = turned * Vec3(4.0, 50.0, 0.0);
    const double gap = 45.0 - corner.x();
    QVERIFY(gap > 0.0 && gap < 10.0);
    // The corner is pushed by -F along x at the lever y: a torque of y F about z.
    const double force = corner.y() * kStiffness * (10.0 - gap) / radius;
    const Vec3 tangent = Vec3::UnitZ().cross(Vec3((hand - centre) / radius));
    QVERIFY2((forceAt(tool, hand) - force * tangent).norm() < 1e-3 * force, qPrintable(QString::number(force)));
  }

  // A carried body feels neither its link nor what else that carries, but all other objects.
  void onTheRobot() {
    WallCell cell;
    cell.stand({0.3, 0.4, 0.2, 0.5, 0.8, -0.3});
    const RobotModel& robot = cell.document().robot().model;
    const Pose flange = linkPoses(robot, cell.document().joints())[toolLink(robot)];
    const auto addAt = [&](const Vec3& inFlange) {
      return cell.addBox(Vec3::Constant(20.0), flange * inFlange, rollPitchYaw(flange));
    };
    const BodyId held = addAt({0.0, 0.0, 100.0}), beside = addAt({24.0, 0.0, 100.0});
    auto carry = carryEdit(cell.document().bodies(), {held, beside}, toolLink(robot), robot, cell.document().joints());
    cell.document().commit("Carry", std::move(carry).value());
    const BodyId free = addAt({0.0, 26.0, 100.0});
    HeldApproach approach(cell.document(), cell.services());
    approach.hold(held);
    const Vec3 force = flange.linear().transpose() * approach.follow(Pose::Identity(), Vec3::Zero()).wrench.force;
    QVERIFY((force - Vec3(0.0, -kStiffness * 4.0, 0.0)).norm() < 1e-5);
    QVERIFY(std::abs(approach.felt().distance - 6.0) < 1e-5);
    // The free one feels both of the carried ones: one straight below it, one 4 mm and 6 mm aside.
    approach.hold(free);
    const Vec3 back = flange.linear().transpose() * approach.follow(Pose::Identity(), Vec3::Zero()).wrench.force;
    const Vec3 aside(-4.0, 6.0, 0.0);
    const Vec3 ofBoth = kStiffness * (Vec3(0.0, 4.0, 0.0) + (10.0 - aside.norm()) * aside.normalized());
    QVERIFY((back - ofBoth).norm() < 1e-5);
  }

  // The force comes as soon as the cell is prepared, and never from where the bodies were.
  void whileTheCellIsPrepared() {
    WallCell cell;
    cell.isUnderWay = true;
    PlaceBodyTool tool = cell.placing();
    const Vec3 hand = kBox + Vec3(16.0, 0.0, 0.0);
    tool.pointer(ofHand(Kind::Press, kBox));
    tool.pointer(ofHand(Kind::Drag, hand));
    QVERIFY(tool.forces().empty());
    cell.isUnderWay = false;
    tool.pointer(ofHand(Kind::Drag, hand));
    QVERIFY(!tool.forces().empty());
    const auto before = cell.scene();
    tool.perform("revert");
    HeldApproachServices services = cell.services();
    services.scene = [before](std::optional<std::size_t>) { return before; };
    cell.addBox(Vec3::Constant(20.0), kBox + Vec3(0.0, 22.0, 0.0));
    HeldApproach approach(cell.document(), services);
    approach.hold(cell.box);
    QVERIFY(approach.follow(Pose::Identity(), kBox).wrench.force.isZero(0.0));
  }

  // With the tool for joints and bodies, over the floor; the mouse feels nothing.
  void overTheFloor() {
    WallCell cell;
    CellTool tool = cell.moving();
    const Vec3 hand = kBox + Vec3(16.0, 0.0, 0.0);
    tool.pointer(ofHand(Kind::Press, kBox));
    QVERIFY(tool.forces().empty());
    tool.pointer(ofHand(Kind::Drag, hand));
    QVERIFY((forceAt(tool, hand) - Vec3(-kStiffness * 6.0, 0.0, 0.0)).norm() < 1e-6);
    QCOMPARE(tool.forces().front().turning, 0.0);
    QVERIFY(propertyNamed(tool.settings(), "clearance"));
    tool.perform("revert");
    QVERIFY(tool.forces().empty());
    tool.pointer(above(Kind::Press, kBox.x(), kBox.y(), kControl));
    tool.pointer(above(Kind::Drag, hand.x(), hand.y(), kControl));
    QVERIFY(tool.preview().replaced && tool.forces().empty());
    tool.perform("revert");
    cell.selection.clear();  // there are no handles
    PlaceBodyTool placing = cell.placing();
    placing.pointer(above(Kind::Press, kBox.x(), kBox.y(), kControl));
    placing.pointer(above(Kind::Drag, hand.x(), hand.y(), kControl));
    QVERIFY(placing.preview().replaced && placing.forces().empty());
  }

  // A robot that is held by its base feels a wall, but not the floor that it stands on.
  void aRobot() {
    WallCell cell;
    auto changed = withRobotAdded(cell.content(), {cellOf(*libraryTable("ur5")), "", at({0.0, -3000.0, 0.0})});
    cell.document().commit("Add", cell.document().robotsEdit(std::move(changed).value()));
    const Vec3 size(2000.0, 100.0, 4000.0), middle(0.0, -1500.0, 0.0);
    cell.addBox(size, middle);
    cell.addBox({500.0, 500.0, 100.0}, {0.0, -3000.0, -50.0});
    const auto scene = cell.services().scene(1);
    const CollisionBody wall({CollisionPiece::box(Pose::Identity(), size)});
    const ArmValues values = scene->planned(cell.document().joints());
    const double distance = scene->scene.nearestTo(wall, at(middle), values, 1e4).distance;
    HeldApproach approach(cell.document(), cell.services());
    approach.holdRobot(1);
    QVERIFY(approach.follow(Pose::Identity(), Vec3::Zero()).wrench.force.isZero(0.0));
    const Vec3 force = approach.follow(at({0.0, distance - 4.0, 0.0}), Vec3::Zero()).wrench.force;
    QVERIFY(force.y() < -kStiffness * 6.0 + 1e-3 && std::abs(force.x()) < 1e-3 && std::abs(force.z()) < 1e-3);
    QVERIFY(std::abs(approach.felt().distance - 4.0) < 1e-3);
    // The same by the arrow along y.
    cell.selection.clear();
    cell.robot = 1;
    PlaceBodyTool tool = cell.placing();
    const Vec3 grip(0.0, -2940.0, 0.0), hand = grip + Vec3(30.0, distance - 4.0, 0.0);
    tool.pointer(ofHand(Kind::Hover, grip));
    tool.pointer(ofHand(Kind::Press, grip));
    tool.pointer(ofHand(Kind::Drag, hand));
    QVERIFY((forceAt(tool, hand) - Vec3(0.0, force.y(), 0.0)).norm() < 1e-3);
  }

  // NaN and leaps from a device.
  void anyHand() {
    WallCell cell;
    PlaceBodyTool tool = cell.placing();
    tool.pointer(ofHand(Kind::Press, kBox));
    for (const double value : {std::nan(""), 1e300, -1e9, std::numeric_limits<double>::infinity(), 16.0, 60.0}) {
      tool.pointer(ofHand(Kind::Drag, Vec3(kBox + Vec3(value, 0.0, 0.0))));
      for (const DeviceSpring& spring : tool.forces())
        QVERIFY(spring.target.allFinite() && spring.turn.coeffs().allFinite());
    }
    QVERIFY(!tool.forces().empty());  // inside of the wall
  }
};

HANDWHEEL_TEST(HeldApproachTest)
#include "HeldApproachTest.moc"
