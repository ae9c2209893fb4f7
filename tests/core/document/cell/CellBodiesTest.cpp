// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Cells.h"

#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellDisplay.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyDisplay.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <rapidcheck.h>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Body boxAt(const std::string& name, double size, const Pose& pose) {
  return {.name = name, .pose = pose, .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {size, size, size})};
}

void add(RobotCellDocument& cell, Body body) {
  cell.commit("Add", std::move(addBodyEdit(cell.bodies(), std::move(body))).value());
}

}  // namespace

class CellBodiesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { m_cell = std::make_unique<RobotCellDocument>(importOrThrow(m_package.urdf())); }

  void bodiesStandBesideTheRobot() {
    const std::size_t links = kKind.display(*m_cell->snapshot()).parts.size();
    add(*m_cell, boxAt("table", 100, poseOf({500, 0, 0}, {0, 0, 0})));
    const DisplayModel shown = kKind.display(*m_cell->snapshot());
    QCOMPARE(shown.parts.size(), links + 1);
    const DisplayPart& part = shown.parts.back();
    QCOMPARE(bodyOfPart(part.name), std::optional<BodyId>(1));
    QCOMPARE(linkOfPart(m_cell->robot(), part.name), kNone);
    QVERIFY((part.pose * part.soup->points[0] - Vec3(500, 0, 0)).cwiseAbs().isApprox(Vec3(50, 50, 50)));
    for (std::size_t i = 0; i < links; ++i) QVERIFY(!bodyOfPart(shown.parts[i].name));
  }

  // A body that is mounted keeps its pose, then moves with its link; released, it keeps its pose again.
  void carriedBodiesMoveWithTheirLink() {
    add(*m_cell, boxAt("gripper", 20, poseOf({620, 30, 5}, {0.1, 0.2, 0.3})));
    const Pose before = m_cell->bodies().withId(1)->pose;
    const auto shown = [&] { return kKind.display(*m_cell->snapshot()).parts.back().pose; };
    const auto property = m_cell->property("body.gripper.carrier");
    QVERIFY(property.has_value());
    const auto& names = property->choices;
    const auto tool = std::find(names.begin(), names.end(), "tool0");
    QVERIFY(tool != names.end());
    QVERIFY(m_cell->setProperty("body.1.carrier", static_cast<double>(tool - names.begin())));
    QCOMPARE(m_cell->bodies().withId(1)->carrier, std::string("tool0"));
    QVERIFY(shown().isApprox(before, 1e-12));
    m_cell->commit("Move", m_cell->jointEdit(values({200.0, 0.5})));
    // The arm turns about (200, 0, 0) by 0.5 rad after the slide of 200 mm.
    const Pose moved = Eigen::Translation3d(200, 0, 0) * Eigen::AngleAxisd(0.5, Vec3::UnitZ()) * before;
    QVERIFY(shown().isApprox(moved, 1e-9));
    QVERIFY(m_cell->setProperty("body.1.carrier", 0.0));
    QVERIFY(m_cell->bodies().withId(1)->carrier.empty());
    QVERIFY(m_cell->bodies().withId(1)->pose.isApprox(moved, 1e-9));
    m_cell->history()->undo();
    std::vector<Error> damage;
    const auto again = loaded(saved(*m_cell->snapshot()), damage);
    QVERIFY(again && damage.empty());

    QCOMPARE(again->bodies.withId(1)->carrier, std::string("tool0"));
    QVERIFY(again->bodies.withId(1)->pose.matrix() == m_cell->bodies().withId(1)->pose.matrix());
    QVERIFY(!m_cell->setProperty("body.1.carrier", 1e9).hasValue());
  }

  // A tool whose origin is where it is screwed on.
  void mountedBodiesStandOnTheirLink() {
    add(*m_cell, boxAt("gripper", 20, poseOf({620, 30, 5}, {0.1, 0.2, 0.3})));
    const RobotModel& robot = m_cell->robot().model;
    m_cell->commit("Mount", std::move(mountEdit(m_cell->bodies(), 1, toolLink(robot), robot)).value());
    const Pose shown = kKind.display(*m_cell->snapshot()).parts.back().pose;
    QVERIFY(shown.isApprox(Pose(Eigen::Translation3d(500, 0, 0)), 1e-9));
    QVERIFY(!mountEdit(m_cell->bodies(), 1, toolLink(robot), robot).value());
    QVERIFY(!mountEdit(m_cell->bodies(), 9, toolLink(robot), robot).hasValue());
  }

  // In one step, each where it was; one that the link carries already, and a body that is not there.
  void severalAreCarried() {
    const Pose first = poseOf({620, 30, 5}, {0.1, 0.2, 0.3}), second = poseOf({-10, 40, 70}, {0.4, 0, 0});
    add(*m_cell, boxAt("gripper", 20, first));
    add(*m_cell, boxAt("camera", 10, second));
    const RobotModel& robot = m_cell->robot().model;
    const auto carry = [&](const std::set<BodyId>& ids, std::uint32_t link) {
      return carryEdit(m_cell->bodies(), ids, link, robot, m_cell->joints());
    };
    m_cell->commit("Carry", std::move(carry({1, 2}, toolLink(robot))).value());
    const auto standAsBefore = [&] {
      const BodySet there = inFrameOfBase(m_cell->bodies(), robot, m_cell->joints());
      return there.withId(1)->pose.isApprox(first, 1e-12) && there.withId(2)->pose.isApprox(second, 1e-12);
    };
    QVERIFY(standAsBefore());
    QVERIFY(!m_cell->bodies().withId(1)->carrier.empty() && !m_cell->bodies().withId(2)->carrier.empty());
    QVERIFY(!carry({1, 2}, toolLink(robot)).value());
    QVERIFY(!carry({1, 9}, kNone).hasValue());
    m_cell->commit("Release", std::move(carry({1, 2}, kNone)).value());
    QVERIFY(standAsBefore() && m_cell->bodies().withId(2)->carrier.empty());
    m_cell->history()->undo();
    m_cell->history()->undo();
    QVERIFY(m_cell->bodies().withId(1)->carrier.empty() && m_cell->bodies().withId(2)->carrier.empty());
  }

  // A robot as the shape of a body is one mesh.
  void aRobotAsABodySaysWhatItLoses() {
    std::vector<Note> notes;
    const GeometryPointer shape = kKind.bodyGeometry(*m_cell->snapshot(), notes);
    QCOMPARE(shape->kind(), "mesh");
    QCOMPARE(notes.size(), std::size_t{1});
    QVERIFY(notes[0].text.find("joints") != std::string::npos && notes[0].text.find("colours") != std::string::npos);
  }

  void aMovedBodyKeepsItsSoup() {
    add(*m_cell, boxAt("table", 100, Pose::Identity()));
    const DisplayModel before = kKind.display(*m_cell->snapshot());
    QVERIFY(m_cell->setProperty("body.1.z", 30.0).hasValue());
    const DisplayModel after = kKind.display(*m_cell->snapshot());
    QCOMPARE(after.parts.back().soup, before.parts.back().soup);
    QCOMPARE(after.parts.back().pose.translation().z(), 30.0);
    QVERIFY(m_cell->setProperty("body.1.visible", false).hasValue());
    QCOMPARE(kKind.display(*m_cell->snapshot()).parts.size(), after.parts.size() - 1);
  }

  void linkedFilesAreNotReplaced() {
    const QString part = m_package.path("part.stl");
    Body linked = boxAt("part", 10, Pose::Identity());
    linked.link = BodyLink{part.toStdString(), {}, "00"};
    test::write(part, "the part");
    add(*m_cell, linked);
    for (const QString& path : {part, m_package.path("arm/../part.stl")}) {
      const auto written = saveDocument(kKind, m_cell->file(), *m_cell->snapshot(), path.toStdString());
      QVERIFY(!written);
      QCOMPARE(written.error().code, DocumentError::ReplacesLinked);
    }
    QFile file(part);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("the part"));
    QVERIFY(saveDocument(kKind, m_cell->file(), *m_cell->snapshot(), m_package.path("all.stl").toStdString()));
  }

  void saveAndLoad() {
    QVERIFY(rc::check("cells with bodies", [this] {
      init();
      for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        const auto any = [] { return *rc::gen::inRange(-1000, 1001) / 7.0; };
        add(*m_cell, boxAt(freeBodyName(m_cell->bodies(), "box"), 1.0 + i,
                           poseOf({any(), any(), any()}, {any() / 50, any() / 100, any() / 50})));
      }
      std::vector<Error> damage;
      const auto again = loaded(saved(*m_cell->snapshot()), damage);
      RC_ASSERT(again && damage.empty());
      RC_ASSERT(again->bodies.size() == m_cell->bodies().size());
      for (const BodyPointer& body : m_cell->bodies()) {
        const BodyPointer read = again->bodies.withId(body->id);
        RC_ASSERT(read && read->name == body->name && read->pose.matrix() == body->pose.matrix());
      }
    }));
  }

  void jointsAndBodiesUndoInTurn() {
    add(*m_cell, boxAt("table", 100, Pose::Identity()));
    QVERIFY(m_cell->setProperty("joint.turn", 1.0).hasValue());
    QVERIFY(m_cell->setProperty("body.1.name", std::string("bench")).hasValue());
    for (int i = 0; i < 3; ++i) m_cell->history()->undo();
    QVERIFY(m_cell->bodies().empty() && m_cell->joints()[1] == 0.0);
    for (int i = 0; i < 3; ++i) m_cell->history()->redo();
    QCOMPARE(m_cell->bodies().withId(1)->name, "bench");
    QCOMPARE(m_cell->joints()[1], 1.0);
  }

  void historyNamesTheBody() {
    add(*m_cell, boxAt("table", 100, Pose::Identity()));
    QVERIFY(m_cell->setProperty("body.1.z", 30.0).hasValue());
    QCOMPARE(m_cell->history()->undoText(), QString("Change Z of table"));
    QVERIFY(m_cell->setProperty("joint.turn", 1.0).hasValue());
    QCOMPARE(m_cell->history()->undoText(), QString("Change turn"));
  }

  void propertiesAreFoundByTheNameOfTheBody() {
    add(*m_cell, boxAt("table", 100, Pose::Identity()));
    add(*m_cell, boxAt("1.5 m bench", 100, poseOf({7, 0, 0}, {0, 0, 0})));
    QCOMPARE(m_cell->property("body.table.x")->id, std::string("body.1.x"));
    QCOMPARE(m_cell->property("body.1.5 m bench.x")->id, std::string("body.2.x"));
    QCOMPARE(m_cell->property("body.2.x")->value, PropertyValue(7.0));
    QCOMPARE(m_cell->property("joint.turn")->id, std::string("joint.turn"));
    for (const char* id : {"body.chair.x", "body.3.x", "body.table.q", "body.table", "body", "body."})
      QVERIFY2(!m_cell->property(id), id);
    for (const Property& each : m_cell->properties()) QCOMPARE(m_cell->property(each.id)->value, each.value);
  }

  void hiddenBodiesAreLeftOutOfAnExportWithANote() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("cell.stl").toStdString();
    for (const char* name : {"table", "vice", "lamp"}) add(*m_cell, boxAt(name, 100, Pose::Identity()));
    const auto notes = [&] { return kKind.exportTo(*m_cell->snapshot(), path, {})->notes; };
    QCOMPARE(notes().size(), std::size_t{1});
    QVERIFY(m_cell->setProperty("body.1.visible", false).hasValue());
    QCOMPARE(notes().at(1).arguments, std::vector<std::string>{"table"});
    QVERIFY(notes().at(1).isLoss);
    QVERIFY(m_cell->setProperty("body.3.visible", false).hasValue());
    QCOMPARE(notes().at(1).arguments, (std::vector<std::string>{"2", "table, lamp"}));
  }

  void describes() {
    add(*m_cell, boxAt("table", 100, poseOf({1, 2, 3}, {0, 0, 0})));
    const nlohmann::json bodies = kKind.describe(*m_cell->snapshot())["bodies"];
    QCOMPARE(bodies.size(), std::size_t{1});
    QCOMPARE(bodies[0]["name"].get<std::string>(), "table");
    QCOMPARE(bodies[0]["shape"].get<std::string>(), "box");
    QVERIFY(bodies[0]["position"] == nlohmann::json({1.0, 2.0, 3.0}));
    QVERIFY(bodies[0]["link"].is_null());
  }

  // Files of version 2 and earlier.
  void cellsWithoutBodies() {
    Container old = saved(*m_cell->snapshot());
    (*old.manifest)["document"].erase("bodies");
    (*old.manifest)["document"].erase("next_body");
    std::vector<Error> damage;
    const auto read = loaded(old, damage);
    QVERIFY(read && damage.empty() && read->bodies.empty());
  }

 private:
  ArmPackage m_package;
  std::unique_ptr<RobotCellDocument> m_cell;
};

HANDWHEEL_TEST(CellBodiesTest)
#include "CellBodiesTest.moc"
