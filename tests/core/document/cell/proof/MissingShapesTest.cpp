// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/proof/MissingShapes.h"

#include "../Cells.h"
#include "TestClass.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellScene.h"
#include "document/cell/RobotChanges.h"
#include "document/scene/BodyChanges.h"
#include "robot/UrdfReader.h"
#include "robot/UrdfWriter.h"
#include "scene/PrimitiveGeometry.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using State = MissingShape::State;

// A robot of one joint, whose link has this collision element.
std::string robotWith(const std::string& collision) {
  return "<robot name='one'><link name='b'/><link name='l'><collision>" + collision +
         "</collision></link><joint name='j' type='revolute'><parent link='b'/><child link='l'/>"
         "<limit lower='-1' upper='1' effort='0' velocity='0'/></joint></robot>";
}

const std::string kCapsule = "<geometry><capsule radius='0.1' length='0.3'/></geometry>";

}  // namespace

// Shapes that could not be read stay in the cell as missing, until they are left out or replaced.
class MissingShapesTest : public QObject {
  Q_OBJECT

 private slots:
  void kinds_data() {
    QTest::addColumn<QString>("collision");
    QTest::addColumn<QString>("what");
    QTest::newRow("capsule") << QString::fromStdString(kCapsule) << "capsule";
    QTest::newRow("no number") << "<geometry><cylinder radius='${r}' length='0.1'/></geometry>"
                               << "cylinder";
    QTest::newRow("no length") << "<geometry><box size='0.1 0 0.1'/></geometry>"
                               << "box";
    QTest::newRow("missing mesh") << "<geometry><mesh filename='package://none/x.stl'/></geometry>"
                                  << "package://none/x.stl";
    QTest::newRow("no file") << "<geometry><mesh/></geometry>"
                             << "mesh";
    QTest::newRow("empty") << "<geometry/>"
                           << "no shape";
    QTest::newRow("nothing") << ""
                             << "no shape";
    QTest::newRow("nowhere") << "<origin xyz='a b c'/><geometry><sphere radius='0.1'/></geometry>"
                             << "sphere";
  }
  // It is known, saved, loaded and written again with the robot.
  void kinds() {
    QFETCH(QString, collision);
    QFETCH(QString, what);
    const QString file = m_folder.filePath("one.urdf");
    write(file, robotWith(collision.toStdString()));
    const OpenedFile opened = importOrThrow(file);
    QVERIFY(!opened.file.damage.empty());
    const MissingShape expected{.part = "l", .name = "l", .what = what.toStdString()};
    const auto missingIn = [](const RobotCellSnapshot& cell) {
      return missingShapes(*cell.robot, cell.bodies, *cell.plans);
    };
    QVERIFY(missingIn(cellIn(opened)) == std::vector{expected});
    std::vector<Error> damage;
    const auto again = loaded(saved(*opened.content), damage);
    QVERIFY(again && missingIn(*again) == std::vector{expected});
    const auto added = std::make_shared<RobotCellSnapshot>(cellIn(opened));
    const Result<RobotCellSnapshot> two = withRobotAdded(cellIn(opened), {added, "right", Pose::Identity()});
    QVERIFY(two.hasValue());
    const std::vector<MissingShape> both = missingIn(*two);
    QCOMPARE(both.size(), std::size_t{2});
    QVERIFY(both[0] == expected && both[1].part == "right_l");
  }

  // Each decision is one step, which undo takes back; the scene has it.
  void decided() {
    write(m_folder.filePath("one.urdf"), robotWith(kCapsule));
    RobotCellDocument document(importOrThrow(m_folder.filePath("one.urdf")));
    const auto state = [&] { return missingShapes(document.robot(), document.bodies(), *document.plans())[0].state; };
    QVERIFY(state() == State::Open && !document.property("missing.l")->problem.empty());
    const auto set = [&](double choice) {
      document.commit("Decide", std::move(document.propertyEdit("missing.l", choice)).value());
    };
    set(1.0);
    QVERIFY(state() == State::LeftOut && document.property("missing.l")->problem.empty());
    document.history()->undo();
    QVERIFY(state() == State::Open);
    QVERIFY(!document.propertyEdit("missing.l", 2.0).hasValue());  // nothing is there to replace it
    QVERIFY(!document.propertyEdit("missing.b", 1.0).hasValue());
    // A body that the link carries takes its place.
    Body body{
        .name = "stand-in", .carrier = "l", .geometry = *PrimitiveGeometry::make(Primitive::Cylinder, {100, 500})};
    document.commit("Add", std::move(addBodyEdit(document.bodies(), body)).value());
    set(2.0);
    const auto content = std::static_pointer_cast<const RobotCellSnapshot>(document.snapshot());
    CollisionMeshes meshes;
    const Result<CellScene> scene = sceneOf(*content, meshes);
    QVERIFY(scene.hasValue());
    QVERIFY(scene->missing.size() == 1 && scene->missing[0].state == State::Replaced);
    QCOMPARE(scene->missing[0].by, std::string("stand-in"));
    std::vector<Error> damage;
    const auto again = loaded(saved(*content), damage);
    QVERIFY(again && *again->plans == *content->plans);
    // Without the body the shape is missing as before.
    const std::vector<BodyId> ids{document.bodies().withName("stand-in")->id};
    document.commit("Remove", removeBodiesEdit(document.bodies(), ids));
    QVERIFY(state() == State::Open);
  }

  // A robot collides with what it shows if it has no collision shapes, also with what could not be read of that.
  void shapesThatAreOnlyShown() {
    std::string urdf = robotWith(kCapsule);
    for (std::size_t at = urdf.find("collision"); at != urdf.npos; at = urdf.find("collision"))
      urdf.replace(at, 9, "visual");
    write(m_folder.filePath("one.urdf"), urdf);
    const OpenedFile opened = importOrThrow(m_folder.filePath("one.urdf"));
    const RobotCellSnapshot& cell = cellIn(opened);
    QCOMPARE(missingShapes(*cell.robot, cell.bodies, *cell.plans).size(), std::size_t{1});
  }

  // A robot without visual shapes, or without those that could be read, is drawn by its collision shapes.
  void drawnByCollisions() {
    const std::string box = "<geometry><box size='0.1 0.1 0.1'/></geometry>";
    const std::string mesh = "</collision><visual><geometry><mesh filename='none.stl'/></geometry></visual><collision>";
    for (const std::string& collision : {box, box + mesh + box}) {
      write(m_folder.filePath("one.urdf"), robotWith(collision));
      const OpenedFile opened = importOrThrow(m_folder.filePath("one.urdf"));
      QVERIFY(isNear(kKind.display(*opened.content).bounds(), Vec3::Constant(-50.0), Vec3::Constant(50.0)));
    }
  }

  // A mesh in mm in a description, which is in metres, and a joint with its origin in mm.
  void unlikelySizes() {
    write(m_folder.filePath("big.stl"),
          writeMesh(surfaceOf(BoxShape{{300.0, 40.0, 40.0}}), MeshFormat::Stl, NumberType::Float32));
    write(m_folder.filePath("one.urdf"), robotWith("<geometry><mesh filename='big.stl'/></geometry>"));
    const OpenedFile opened = importOrThrow(m_folder.filePath("one.urdf"));
    QCOMPARE(opened.file.notes.size(), std::size_t{1});
    QVERIFY((opened.file.notes[0].arguments == std::vector<std::string>{"l", "300"}));
    std::string far = robotWith("<geometry><box size='0.1 0.1 0.1'/></geometry>");
    far.replace(far.find("<child"), 0, "<origin xyz='0 0 400'/>");
    write(m_folder.filePath("one.urdf"), far);
    const OpenedFile other = importOrThrow(m_folder.filePath("one.urdf"));
    QCOMPARE(other.file.notes.size(), std::size_t{1});
    QVERIFY((other.file.notes[0].arguments == std::vector<std::string>{"j", "400"}));
  }

 private:
  QTemporaryDir m_folder;
};

HANDWHEEL_TEST(MissingShapesTest)
#include "MissingShapesTest.moc"
