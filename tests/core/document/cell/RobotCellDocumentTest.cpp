// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Cells.h"

#include "TestClass.h"
#include "document/UndoCommand.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/JointEdit.h"
#include "document/cell/RobotsEdit.h"

#include <rapidcheck.h>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const Property* find(const std::vector<Property>& all, const std::string& id) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Property& p) { return p.id == id; });
  return found == all.end() ? nullptr : &*found;
}

double numberOf(const RobotCellDocument& document, const std::string& id) {
  const auto all = document.properties();
  const Property* property = find(all, id);
  return property ? std::get<double>(property->value) : std::nan("");
}

}  // namespace

class RobotCellDocumentTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void propertiesOfJoints();
  void toolPosition();
  void setting();
  void settingALimitAsShown();
  void settingRefuses();
  void settingWithoutLimits();
  void dragsAreOneStep();
  void editsKeepLimits();
  void snapshotsStay();
  void whatAStepHolds();
  void undoIsTheInverse();

 private:
  std::unique_ptr<ArmPackage> m_package;
  std::unique_ptr<RobotCellDocument> m_document;
};

void RobotCellDocumentTest::init() {
  m_package = std::make_unique<ArmPackage>();
  m_document = std::make_unique<RobotCellDocument>(importOrThrow(m_package->urdf()));
}

void RobotCellDocumentTest::propertiesOfJoints() {
  const auto all = m_document->properties();
  const Property* slide = find(all, "joint.slide");
  QVERIFY(slide);
  QVERIFY(slide->quantity == Quantity::Length && slide->least == 0.0 && slide->largest == 1000.0);
  QVERIFY(slide->continuous && slide->editable && !slide->translated && slide->problem.empty());
  QCOMPARE(slide->label, std::string("slide"));
  const Property* turn = find(all, "joint.turn");
  QVERIFY(turn->quantity == Quantity::Angle && turn->least == -2.0 && turn->largest == 2.0);
  QVERIFY(turn->problem.empty());
  const Property* effort = find(all, "joints.unknown_effort");
  QVERIFY(effort && !effort->editable);
  QCOMPARE(std::get<std::string>(effort->value), std::string("turn"));
  QVERIFY(!find(all, "joints.unknown_speed"));
  QVERIFY(!find(all, "joint.close"));  // it follows
  QVERIFY(!find(all, "joint.end"));
  QCOMPARE(std::get<std::string>(find(all, "robot")->value), std::string("arm"));
  QCOMPARE(std::get<std::string>(find(all, "tool")->value), std::string("tool0"));
  QVERIFY(find(all, "tool.x")->editable && find(all, "tool.x")->quantity == Quantity::Length);
  QVERIFY(find(all, "display_unit"));
}

void RobotCellDocumentTest::toolPosition() {
  QVERIFY(m_document->setProperty("joint.slide", 250.0).hasValue());
  QVERIFY(m_document->setProperty("joint.turn", 0.5).hasValue());
  QVERIFY(std::abs(numberOf(*m_document, "tool.x") - (250 + 500 * std::cos(0.5))) < 1e-9);
  QVERIFY(std::abs(numberOf(*m_document, "tool.y") - 500 * std::sin(0.5)) < 1e-9);
  QVERIFY(std::abs(numberOf(*m_document, "tool.z")) < 1e-9);
}

void RobotCellDocumentTest::setting() {
  QSignalSpy changed(m_document.get(), &Document::changed);
  QVERIFY(m_document->setProperty("joint.turn", 1.5).hasValue());
  QCOMPARE(m_document->joints(), values({0, 1.5}));
  QVERIFY(m_document->isModified());
  QVERIFY(m_document->setProperty("joint.turn", 1.5).hasValue());  // nothing to do
  QCOMPARE(m_document->history()->count(), 1);
  QCOMPARE(changed.count(), 1);
  m_document->history()->undo();
  QCOMPARE(m_document->joints(), values({0, 0}));
  QVERIFY(!m_document->isModified());
  m_document->history()->redo();
  QCOMPARE(m_document->joints(), values({0, 1.5}));
}

void RobotCellDocumentTest::settingALimitAsShown() {
  QVERIFY(m_document->setProperty("joint.turn", 114.5916 * kRadiansPerDegree).hasValue());
  QCOMPARE(m_document->joints()[1], 2.0);
  QVERIFY(m_document->setProperty("joint.turn", -114.5916 * kRadiansPerDegree).hasValue());
  QCOMPARE(m_document->joints()[1], -2.0);
}

void RobotCellDocumentTest::settingRefuses() {
  const auto codeOf = [&](const char* id, const PropertyValue& value) {
    const Status status = m_document->setProperty(id, value);
    return status ? ErrorCode::Cancelled : status.error().code;
  };
  QCOMPARE(codeOf("joint.turn", 2.1), ErrorCode::ValueOutOfRange);
  QCOMPARE(codeOf("joint.slide", -1e-9), ErrorCode::ValueOutOfRange);
  QCOMPARE(codeOf("joint.turn", std::nan("")), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf("joint.turn", INFINITY), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf("joint.turn", std::string("1")), ErrorCode::ElementMalformed);
  QCOMPARE(codeOf("joint.none", 1.0), ErrorCode::ReferenceMissing);
  QCOMPARE(codeOf("tool.w", 1.0), ErrorCode::ReferenceMissing);
  QCOMPARE(m_document->history()->count(), 0);
  // Degrees, within a millionth of 2 rad = 114.59155902…°; whoever enters what is shown means the limit.
  const Status refused = m_document->setProperty("joint.turn", 90.0);
  QCOMPARE(refused.error().arguments, (std::vector<std::string>{"turn", "5156.62", "-114.5916", "114.5916"}));
}

void RobotCellDocumentTest::settingWithoutLimits() {
  write(m_package->path("free.urdf"),
        "<robot><link name='a'/><link name='b'/><joint name='j' type='revolute'><parent link='a'/><child link='b'/>"
        "</joint></robot>");
  RobotCellDocument document(importOrThrow(m_package->path("free.urdf")));
  const auto all = document.properties();
  QVERIFY(!find(all, "joint.j")->continuous);  // a slider needs ends
  QVERIFY(document.setProperty("joint.j", 100.0).hasValue());
  QCOMPARE(numberOf(document, "joint.j"), 100.0);
  const Status refused = document.setProperty("joint.j", 1e300);
  QVERIFY(!refused);
  QCOMPARE(refused.error().code, ErrorCode::ValueOutOfRange);
}

void RobotCellDocumentTest::dragsAreOneStep() {
  for (double v : {0.1, 0.2, 0.3}) QVERIFY(m_document->setProperty("joint.turn", v, DragPhase::Continues).hasValue());
  QVERIFY(m_document->setProperty("joint.turn", 0.4, DragPhase::Ends).hasValue());
  QCOMPARE(m_document->history()->count(), 1);
  QVERIFY(m_document->setProperty("joint.turn", 0.5, DragPhase::Ends).hasValue());  // another drag
  QCOMPARE(m_document->history()->count(), 2);
  m_document->history()->undo();
  QCOMPARE(m_document->joints()[1], 0.4);
  m_document->history()->undo();
  QCOMPARE(m_document->joints()[1], 0.0);
  m_document->history()->redo();
  QCOMPARE(m_document->joints()[1], 0.4);
  // Different joints do not merge, even in one stroke.
  QVERIFY(m_document->setProperty("joint.turn", 0.6, DragPhase::Continues).hasValue());
  QVERIFY(m_document->setProperty("joint.slide", 100.0, DragPhase::Continues).hasValue());
  QCOMPARE(m_document->history()->count(), 3);
}

void RobotCellDocumentTest::editsKeepLimits() {
  m_document->commit("Move", m_document->jointEdit(values({2000, -7})));
  QCOMPARE(m_document->joints(), values({1000, -2}));
  QVERIFY(!m_document->jointEdit(values({5000, -3})));  // nothing moves
}

void RobotCellDocumentTest::snapshotsStay() {
  const SnapshotPointer before = m_document->snapshot();
  QVERIFY(m_document->setProperty("joint.turn", 1.0).hasValue());
  const SnapshotPointer after = m_document->snapshot();
  const auto& a = static_cast<const RobotCellSnapshot&>(*before);
  const auto& b = static_cast<const RobotCellSnapshot&>(*after);
  QCOMPARE(a.joints[1], 0.0);
  QCOMPARE(b.joints[1], 1.0);
  QCOMPARE(a.robot, b.robot);
  // Displayed parts keep their surfaces; one part moved.
  const DisplayModel shownA = displayOf(*a.robot, a.joints), shownB = displayOf(*b.robot, b.joints);
  QCOMPARE(shownA.parts.size(), std::size_t{2});
  int moved = 0;
  for (std::size_t i = 0; i < shownA.parts.size(); ++i) {
    QCOMPARE(shownA.parts[i].name, shownB.parts[i].name);
    QCOMPARE(shownA.parts[i].soup, shownB.parts[i].soup);
    moved += !shownA.parts[i].pose.isApprox(shownB.parts[i].pose);
  }
  QCOMPARE(moved, 1);
}

// The memory of an undo step includes surfaces that nothing else has, waypoints, names and values.
void RobotCellDocumentTest::whatAStepHolds() {
  const auto bytesOf = [](const RobotCellSnapshot& cell) { return RobotsEdit(cell, {}, {}).bytes(); };
  const auto near = [](std::size_t bytes, std::size_t least) { return bytes >= least && bytes < least + least / 10; };
  RobotCellSnapshot cell = static_cast<const RobotCellSnapshot&>(*m_document->snapshot());
  const std::size_t before = bytesOf(cell);
  CellPlans plans = *cell.plans;
  for (int i = 0; i < 1000; ++i) {
    plans.configurations.push_back({std::string(100, 'c'), values({0, 1})});
    plans.targets.push_back({.name = std::string(100, 't'), .frame = std::string(50, 'f')});
    plans.frames.push_back({.name = std::string(100, 'f'), .link = std::string(50, 'l')});
  }
  RobotPath path;
  path.waypoints.assign(1000, {.joints = values({0, 1}),
                               .name = std::string(30, 'p'),
                               .target = WaypointTarget{std::string(40, 't')},
                               .configuration = std::string(20, 'c')});
  path.process = PathProcess{.values = {{"curve", std::string(70'000, 'v')}, {"speed", 1.0}}};
  plans.paths = {path};
  cell.plans = std::make_shared<const CellPlans>(std::move(plans));
  const std::size_t ofNames = 1000 * (100 + 150 + 150 + 90) + 70'000, ofValues = 2 * 1000 * 2 * sizeof(double);
  const std::size_t ofWaypoints =
      1000 * (sizeof(NamedConfiguration) + sizeof(NamedTarget) + sizeof(NamedFrame) + sizeof(Waypoint));
  QVERIFY(near(bytesOf(cell) - before, ofNames + ofValues + ofWaypoints));

  // A box and a mesh, of 8 points and 12 triangles each. As soon as another version of the robot shares them, they do
  // not count.
  const std::size_t alone = bytesOf(cell);
  const CellRobot sharer = *cell.robot;
  QCOMPARE(bytesOf(cell), alone - 2 * (8 * sizeof(Vec3) + 12 * sizeof(Triangle)));
}

void RobotCellDocumentTest::undoIsTheInverse() {
  QVERIFY(rc::check("undo and redo", [this] {
    init();
    std::vector<JointValues> states{m_document->joints()};
    const int steps = *rc::gen::inRange(1, 12);
    for (int i = 0; i < steps; ++i) {
      const int before = m_document->history()->count();
      const DragPhase stroke = *rc::gen::arbitrary<bool>() ? DragPhase::Continues : DragPhase::Ends;
      if (*rc::gen::arbitrary<bool>())
        RC_ASSERT(m_document->setProperty("joint.turn", *rc::gen::inRange(-20, 21) / 10.0, stroke).hasValue());
      else if (auto edit = m_document->jointEdit(values({*rc::gen::inRange(0, 11) * 100.0, 1.0})))
        m_document->commit("Move", std::move(edit), stroke);
      const int after = m_document->history()->count();
      if (after < before) states.pop_back();  // the stroke led back to where it began: no step is left of it
      if (after == before) states.back() = m_document->joints();
      if (after > before) states.push_back(m_document->joints());
    }
    RC_ASSERT(states.size() == std::size_t(m_document->history()->count()) + 1);
    for (std::size_t i = states.size(); i-- > 1;) {
      RC_ASSERT(m_document->joints() == states[i]);
      m_document->history()->undo();
    }
    RC_ASSERT(m_document->joints() == states[0]);
    for (std::size_t i = 1; i < states.size(); ++i) {
      m_document->history()->redo();
      RC_ASSERT(m_document->joints() == states[i]);
    }
  }));
}

HANDWHEEL_TEST(RobotCellDocumentTest)
#include "RobotCellDocumentTest.moc"
