// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellFrames.h"

#include "Cells.h"
#include "TestClass.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellProperties.h"
#include "document/cell/RobotChanges.h"
#include "document/scene/BodyChanges.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr BodyId kTable = 4, kHeld = 7;

double anyOf(double least, double largest) {
  return least + (largest - least) * *rc::gen::inRange(0, 10'001) / 10'000.0;
}

Pose anyPose() {
  return poseOf({anyOf(-900, 900), anyOf(-900, 900), anyOf(-900, 900)},
                {anyOf(-3.1, 3.1), anyOf(-1.5, 1.5), anyOf(-3.1, 3.1)});
}

// The link "upper" of the test arm, by its definition: it slides along x and turns about z.
Pose upperAt(double slide, double turn) {
  return Pose(Eigen::Translation3d(slide, 0.0, 0.0) * Eigen::AngleAxisd(turn, Vec3::UnitZ()));
}

// The arm with a table beside it, and something that its upper link holds.
RobotCellSnapshot cellWithBodies(const QString& urdf) {
  RobotCellSnapshot cell = cellIn(importOrThrow(urdf));
  Body table{.id = kTable, .name = "table", .geometry = *PrimitiveGeometry::make(Primitive::Sphere, {5.0})};
  table.pose = poseOf({300.0, -200.0, 100.0}, {0.2, -0.3, 0.4});
  Body held{.id = kHeld, .name = "held", .geometry = *PrimitiveGeometry::make(Primitive::Sphere, {5.0})};
  held.pose = poseOf({500.0, 0.0, 20.0}, {-0.1, 0.6, 0.0});
  held.carrier = "upper";
  cell.bodies = cell.bodies.with(std::make_shared<const Body>(table)).with(std::make_shared<const Body>(held));
  cell.joints = values({250.0, 0.8});
  return cell;
}

NamedFrame anyFrame(const std::string& name) {
  NamedFrame frame{name, anyPose()};
  frame.body = *rc::gen::element<BodyId>(0, kTable, kHeld);
  if (frame.body == 0) frame.link = *rc::gen::element<std::string>("", "upper", "foot");
  return frame;
}

CellPlacement placementOf(const RobotCellSnapshot& cell, const CellPlans& plans) {
  return {plans, cell.bodies, cell.robot->model, cell.joints};
}

bool areNear(const Pose& one, const Pose& other) {
  return (one.matrix() - other.matrix()).cwiseAbs().maxCoeff() < 1e-9;
}

}  // namespace

// Named frames of a cell: what carries them, and the targets that they carry.
class CellFramesTest : public QObject {
  Q_OBJECT

 private slots:
  // By the definition of each carrier.
  void onEachCarrier() {
    const RobotCellSnapshot cell = cellWithBodies(m_package.urdf());
    const Pose pose = poseOf({10.0, 20.0, 30.0}, {0.3, 0.2, 0.1}), own = poseOf({1.0, 2.0, 3.0}, {0.0, 0.1, 0.0});
    const Pose upper = upperAt(250.0, 0.8);
    const auto placed = [&](const NamedFrame& frame) {
      CellPlans plans;
      plans.frames = {frame};
      plans.targets = {{"spot", own, 0, frame.name}};
      const CellPlacement at = placementOf(cell, plans);
      const Pose found = *poseOfFrame(frame.name, at);
      return areNear(*poseOfTarget(plans.targets[0], at), found * own) ? found : Pose(Pose::Identity());
    };
    QVERIFY(areNear(placed({"f", pose}), pose));
    QVERIFY(areNear(placed({"f", pose, kTable}), cell.bodies.withId(kTable)->pose * pose));
    QVERIFY(areNear(placed({"f", pose, 0, "upper"}), upper * pose));
    QVERIFY(areNear(placed({"f", pose, kHeld}), upper * cell.bodies.withId(kHeld)->pose * pose));
    QVERIFY(areNear(*poseOfFrame("", placementOf(cell, {})), Pose::Identity()));
  }

  // Targets keep their poses whatever happens to their carriers.
  void placesAreKept() {
    const RobotCellSnapshot cell = cellWithBodies(m_package.urdf());
    QVERIFY(rc::check("places", [&] {
      CellPlans plans;
      plans.frames = {anyFrame("a"), anyFrame("b")};
      plans.targets = {{"on table", anyPose(), kTable}, {"in a", anyPose(), 0, "a"}, {"free", anyPose()}};
      plans.workFrame = *rc::gen::element<std::string>("", "a", "b");
      const CellPlacement at = placementOf(cell, plans);
      const NamedFrame carried =
          *carriedFrame(plans.frames[0], *rc::gen::element<BodyId>(0, kTable, kHeld), "upper", at);
      RC_ASSERT(areNear(*poseOfFrame(carried, at), *poseOfFrame("a", at)));
      RC_ASSERT(carried.body == 0 || carried.link.empty());
      const NamedTarget& target = plans.targets[*rc::gen::inRange<std::size_t>(0, 3)];
      const Pose before = *poseOfTarget(target, at);
      const std::string other = *rc::gen::element<std::string>("", "a", "b");
      const NamedTarget moved = *targetInFrame(target, other, at);
      RC_ASSERT(moved.frame == other && moved.body == 0);
      RC_ASSERT(areNear(*poseOfTarget(moved, at), before));
      RC_ASSERT(areNear(targetShownAt(target, shownPose(target, at), at).pose, target.pose));
      const Pose there = anyPose();
      RC_ASSERT(areNear(*poseOfTarget(targetAt(target, there, at), at), there));
      RC_ASSERT(areNear(*poseOfFrame(frameAt(plans.frames[1], there, at), at), there));
      const CellPlans renamed = withFrameRenamed(plans, "a", "c");
      const CellPlans without = withoutFrame("a", at);
      RC_ASSERT(!renamed.frame("a") && renamed.frame("c") && !without.frame("a") && without.workFrame != "a");
      RC_ASSERT(renamed.workFrame == (plans.workFrame == "a" ? "c" : plans.workFrame));
      for (const CellPlans* const after : {&renamed, &without}) {
        RC_ASSERT(after->targets.size() == plans.targets.size());
        for (std::size_t i = 0; i < plans.targets.size(); ++i)
          RC_ASSERT(areNear(*poseOfTarget(after->targets[i], placementOf(cell, *after)),
                            *poseOfTarget(plans.targets[i], at)));
      }
    }));
  }

  // A target moves with its frame, by the same motion of the whole space, whatever moves that.
  void targetsMoveAlong() {
    QVERIFY(rc::check("moves", [&] {
      const RobotCellSnapshot cell = cellWithBodies(m_package.urdf());
      CellPlans plans;
      plans.frames = {anyFrame("a")};
      plans.targets = {{"spot", anyPose(), 0, "a"}};
      const Pose frame = *poseOfFrame("a", placementOf(cell, plans));
      const Pose target = *poseOfTarget(plans.targets[0], placementOf(cell, plans));
      RobotCellSnapshot after = cell;
      after.joints = values({anyOf(0.0, 1000.0), anyOf(-2.0, 2.0)});
      Body table = *cell.bodies.withId(kTable);
      table.pose = anyPose();
      after.bodies = cell.bodies.with(std::make_shared<const Body>(table));
      if (*rc::gen::arbitrary<bool>()) plans.frames[0].pose = anyPose();
      const Pose motion = *poseOfFrame("a", placementOf(after, plans)) * frame.inverse(Eigen::Isometry);
      RC_ASSERT(areNear(*poseOfTarget(plans.targets[0], placementOf(after, plans)), motion * target));
    }));
  }

  void strays() {
    const RobotCellSnapshot cell = cellWithBodies(m_package.urdf());
    CellPlans plans;
    plans.frames = {{"on gone", poseOf({1.0, 0.0, 0.0}, Vec3::Zero()), 99}, {"by gone", Pose::Identity(), 0, "gone"}};
    plans.targets = {{"a", poseOf({2.0, 0.0, 0.0}, Vec3::Zero()), 0, "on gone"}, {"b", Pose::Identity(), 0, "none"}};
    plans.workFrame = "on gone";
    const CellPlacement at = placementOf(cell, plans);
    for (const char* const name : {"on gone", "by gone"}) {
      const Result<Pose> pose = poseOfFrame(name, at);
      QVERIFY(!pose && pose.error().code == CellError::FrameStray);
      QVERIFY(carriedFrame(*plans.frame(name), kTable, "", at).error().code == CellError::FrameStray);
      // Set anew it stands.
      const NamedFrame again = frameAt(*plans.frame(name), poseOf({5.0, 6.0, 7.0}, Vec3::Zero()), at);
      QVERIFY(again.body == 0 && again.link.empty() && again.pose.translation() == Vec3(5.0, 6.0, 7.0));
    }
    QVERIFY(poseOfTarget(plans.targets[0], at).error().code == CellError::FrameStray);
    QVERIFY(poseOfTarget(plans.targets[1], at).error().code == CellError::FrameMissing);
    QVERIFY(targetInFrame({"c"}, "none", at).error().code == CellError::FrameMissing);
    QVERIFY(carriedFrame({"c"}, 99, "", at).error().code == ErrorCode::ReferenceMissing);
    QVERIFY(carriedFrame({"c"}, 0, "gone", at).error().code == ErrorCode::ReferenceMissing);
    QVERIFY(areNear(shownPose(plans.targets[1], at), plans.targets[1].pose));
    // Its targets wait for the body as the frame did.
    const CellPlans without = withoutFrame("on gone", at);
    QCOMPARE(without.targets[0].body, std::uint32_t{99});
    QVERIFY(without.targets[0].frame.empty() && without.targets[0].pose.translation() == Vec3(3.0, 0.0, 0.0));
  }

  // Frames are moved by the joints between the root and their carrier, and by mimic joints of these.
  void whatMovesIt() {
    const RobotCellSnapshot cell = cellWithBodies(m_package.urdf());
    const std::uint32_t slide[] = {0}, turn[] = {1};
    const auto moves = [&](const NamedFrame& frame, std::span<const std::uint32_t> dofs) {
      return movesWith(frame, cell.bodies, cell.robot->model, dofs);
    };
    const Pose at = Pose::Identity();
    QVERIFY(!moves({"f", at}, slide) && !moves({"f", at, kTable}, slide) && !moves({"f", at, 0, "foot"}, slide));
    QVERIFY(moves({"f", at, 0, "sledge"}, slide) && !moves({"f", at, 0, "sledge"}, turn));
    for (const NamedFrame& frame : {NamedFrame{"f", at, 0, "claw"}, NamedFrame{"f", at, kHeld}})
      QVERIFY(moves(frame, slide) && moves(frame, turn) && !moves(frame, {}));
    QVERIFY(!moves({"f", at, 0, "gone"}, slide) && !moves({"f", at, 99}, slide));
  }

  // If a robot is removed, bodies on its links keep their poses; those of other robots still move.
  void robotRemoved() {
    const RobotCellSnapshot one = cellWithBodies(m_package.urdf());
    RobotCellSnapshot two =
        *withRobotAdded(one, {std::make_shared<const RobotCellSnapshot>(cellIn(importOrThrow(m_package.urdf()))),
                              "second", poseOf({0.0, 3000.0, 0.0}, Vec3::Zero())});
    const Pose own = poseOf({10.0, 20.0, 30.0}, {0.1, 0.2, 0.3});
    CellPlans plans = *two.plans;
    plans.frames = {{"mine", own, 0, "upper"}, {"its", own, 0, "second_upper"}, {"table's", own, kTable}};
    plans.targets = {{"spot", own, 0, "mine"}};
    two.plans = std::make_shared<const CellPlans>(plans);
    const Result<RobotCellSnapshot> rest = withRobotRemoved(two, 0);
    QVERIFY(rest.hasValue());
    const CellPlans& left = *rest->plans;
    QCOMPARE(left.frames.size(), std::size_t{3});
    QVERIFY(left.frames[0].link.empty() && areNear(left.frames[0].pose, upperAt(250.0, 0.8) * own));
    QVERIFY(left.frames[1] == plans.frames[1] && left.frames[2] == plans.frames[2] && left.targets == plans.targets);
    QVERIFY(poseOfFrame("its", placementOf(*rest, left)).hasValue());
  }

  // Edits like those of the panel and `set`; each is one step that can be undone.
  void properties() {
    OpenedFile opened = importOrThrow(m_package.urdf());
    auto content = std::make_shared<RobotCellSnapshot>(cellWithBodies(m_package.urdf()));
    CellPlans plans;
    plans.frames = {{"a.b", poseOf({100.0, 0.0, 0.0}, {0.0, 0.0, 0.5 * std::numbers::pi})}};
    plans.targets = {{"spot", poseOf({130.0, 50.0, 7.0}, Vec3::Zero())}};
    content->plans = std::make_shared<const CellPlans>(plans);
    opened.content = content;
    RobotCellDocument document(std::move(opened));
    const auto number = [&](const char* id) { return std::get<double>(document.property(id)->value); };
    const auto undone = [&](const CellPlans& before) {
      document.history()->undo();
      const bool isSame = *document.plans() == before;
      document.history()->redo();
      return isSame;
    };
    const auto shownWhere = [&] {
      const auto property = document.property("target.spot.coordinates");
      const auto* const name = std::get_if<std::string>(&property->value);
      return name ? *name : std::string();
    };
    QCOMPARE(shownWhere(), std::string());  // in the cell
    // 30 mm along x and 50 mm along y are 50 mm along the x, and -30 mm along the y, of a frame that is turned by 90°.
    QCOMPARE(number("target.spot.x"), 130.0);
    QVERIFY(document.setProperty("frame", 1.0).hasValue());
    QCOMPARE(document.plans()->workFrame, std::string("a.b"));
    QCOMPARE(shownWhere(), std::string("a.b"));  // though the target does not move with it
    QVERIFY(!document.setProperty("target.spot.coordinates", 1.0).hasValue());
    QVERIFY(undone(plans));
    QVERIFY(std::abs(number("target.spot.x") - 50.0) < 1e-9 && std::abs(number("target.spot.y") + 30.0) < 1e-9);
    QVERIFY(document.setProperty("target.spot.x", 60.0).hasValue());
    QVERIFY((document.plans()->targets[0].pose.translation() - Vec3(130.0, 60.0, 7.0)).norm() < 1e-9);
    // In the frame it keeps its pose; then the frame moves, and the target with it.
    QVERIFY(document.setProperty("target.spot.frame", 1.0).hasValue());
    QVERIFY((document.plans()->targets[0].pose.translation() - Vec3(60.0, -30.0, 7.0)).norm() < 1e-9);
    CellPlans before = *document.plans();
    QVERIFY(document.setProperty("frame.a.b.x", 500.0).hasValue());
    QVERIFY(undone(before));
    QVERIFY(
        (poseOfTarget(document.plans()->targets[0], document.placement())->translation() - Vec3(530, 60, 7)).norm() <
        1e-9);
    // Its carrier: nothing, one of the links, one of the bodies.
    const auto carrier = document.property("frame.a.b.carrier");
    const auto& choices = carrier->choices;
    QCOMPARE(choices.size(), 1 + document.robot().model.links.size() + 2);
    const auto choose = [&](const char* word) {
      const auto at = std::find(choices.begin(), choices.end(), word) - choices.begin();
      return document.setProperty("frame.a.b.carrier", static_cast<double>(at)).hasValue();
    };
    before = *document.plans();
    const Pose stands = *poseOfFrame("a.b", document.placement());
    QVERIFY(choose("upper"));
    QVERIFY(undone(before));
    QCOMPARE(document.plans()->frames[0].link, std::string("upper"));
    QVERIFY(areNear(*poseOfFrame("a.b", document.placement()), stands));
    QVERIFY(choose("table") && document.plans()->frames[0].body == kTable && document.plans()->frames[0].link.empty());
    QVERIFY(areNear(*poseOfFrame("a.b", document.placement()), stands));
    QVERIFY(choose("nothing") && areNear(document.plans()->frames[0].pose, stands));
    for (const char* const id : {"frame.other.x", "frame.a.b.w", "target.spot.w"}) QVERIFY(!document.property(id));
    QVERIFY(document.setProperty("frame.other.x", 1.0).error().code == ErrorCode::ReferenceMissing);
    QVERIFY(document.setProperty("frame.a.b.x", 1e9).error().code == ErrorCode::ValueOutOfRange);
    for (const char* const id : {"frame", "frame.a.b.x", "frame.a.b.carrier", "target.spot.frame"}) {
      QVERIFY(document.setProperty(id, std::nan("")).error().code == ErrorCode::ElementMalformed);
      if (!document.property(id)->choices.empty())
        QVERIFY(document.setProperty(id, 1e3).error().code == ErrorCode::ElementMalformed);
    }
  }

  // The body under a frame is removed and comes back.
  void bodyRemovedAndUndone() {
    OpenedFile opened = importOrThrow(m_package.urdf());
    auto content = std::make_shared<RobotCellSnapshot>(cellWithBodies(m_package.urdf()));
    CellPlans plans;
    plans.frames = {{"f", Pose::Identity(), kTable}};
    plans.targets = {{"spot", Pose::Identity(), 0, "f"}};
    content->plans = std::make_shared<const CellPlans>(plans);
    opened.content = content;
    RobotCellDocument document(std::move(opened));
    const Pose before = *poseOfTarget(plans.targets[0], document.placement());
    const BodyId gone[] = {kTable};
    document.commit("Remove", removeBodiesEdit(document.bodies(), gone));
    QVERIFY(poseOfTarget(plans.targets[0], document.placement()).error().code == CellError::FrameStray);
    QVERIFY(!document.property("frame.f.carrier")->problem.empty());
    document.history()->undo();
    QVERIFY(areNear(*poseOfTarget(plans.targets[0], document.placement()), before));
    QVERIFY(document.property("frame.f.carrier")->problem.empty());
  }

 private:
  ArmPackage m_package;
};

HANDWHEEL_TEST(CellFramesTest)
#include "CellFramesTest.moc"
