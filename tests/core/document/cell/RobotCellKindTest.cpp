// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Cells.h"

#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "document/cell/CellDisplay.h"
#include "document/formats/MeshFileErrors.h"
#include "document/scene/BodyChanges.h"
#include "mesh/structure/MeshErrors.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const DisplayPart* partNamed(const DisplayModel& model, const std::string& name) {
  for (const DisplayPart& part : model.parts)
    if (part.name == name) return &part;
  return nullptr;
}

}  // namespace

class RobotCellKindTest : public QObject {
  Q_OBJECT

 private slots:
  void recognises();
  void makes();
  void checksLinks();
  void describesWaypoints();
  void imports();
  void meshesInMetres();
  void tablesWithMeshes();
  void colladaMeshes();
  void missingMeshes();
  void missingPackage();
  void damagedMeshes();
  void badDescription();
  void tooMuchToShow();
  void cancelled();
  void display();
  void describes();
  void exports();

 private:
  ArmPackage m_package;
};

void RobotCellKindTest::recognises() {
  QVERIFY(kKind.recognises("<?xml?><robot name='r'>", "anything.xml"));
  QVERIFY(kKind.recognises("", "r.urdf") && kKind.recognises("", "R.URDF"));
  QVERIFY(!kKind.recognises("solid a", "part.stl"));
  for (const FileFormat& format : kKind.formats()) {
    const bool isRobot = format.endings.front() == ".urdf" || format.endings.front() == ".dh.json";
    QVERIFY2(format.reads == isRobot && format.writes == !isRobot, format.name.c_str());
  }
}

// Makes a document like any other, with its content.
void RobotCellKindTest::makes() {
  OpenedFile opened = importOrThrow(m_package.urdf());
  const SnapshotPointer content = opened.content;
  const std::unique_ptr<Document> document = kKind.make(std::move(opened));
  const SnapshotPointer shown = document->snapshot();
  const auto& made = static_cast<const RobotCellSnapshot&>(*shown);
  const auto& given = static_cast<const RobotCellSnapshot&>(*content);
  QVERIFY(made.robot == given.robot && made.joints == given.joints);
}

// The file of a body's shape is looked for where the cell is; what is missing is said.
void RobotCellKindTest::checksLinks() {
  Body part{.name = "part", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {10, 10, 10})};
  part.link = BodyLink{m_package.path("gone.stl").toStdString(), {}, "00"};
  RobotCellDocument document(importOrThrow(m_package.urdf()));
  document.commit("Add", std::move(addBodyEdit(document.bodies(), std::move(part))).value());
  QCOMPARE(kKind.linkedFiles(*document.snapshot()).size(), std::size_t{1});
  std::vector<Note> notes;
  const SnapshotPointer checked =
      kKind.withCheckedLinks(document.snapshot(), m_package.path("").toStdString(), notes, {});
  QCOMPARE(notes.size(), std::size_t{1});
  QVERIFY(static_cast<const RobotCellSnapshot&>(*checked).bodies.withId(1)->link->state == LinkState::Missing);
}

// Places that plans name: on what they stand, and where.
void RobotCellKindTest::describesWaypoints() {
  auto cell = withJoints(cellIn(importOrThrow(m_package.urdf())), values({100, M_PI_2}));
  CellPlans plans = *cell->plans;
  plans.configurations.push_back({"home", values({250, 0})});
  plans.frames.push_back({.name = "table", .pose = poseOf({1, 2, 3}, {0, 0, 0})});
  plans.frames.push_back({.name = "hand", .pose = Pose::Identity(), .link = "tool0"});
  plans.workFrame = "hand";
  plans.targets.push_back({.name = "pick", .pose = poseOf({4, 5, 6}, {0, 0, M_PI}), .frame = "table"});
  cell->plans = std::make_shared<const CellPlans>(std::move(plans));
  const nlohmann::json d = kKind.describe(*cell);
  QVERIFY(d["configurations"][0]["name"] == nlohmann::json("home"));
  const nlohmann::json &table = d["frames"][0], &hand = d["frames"][1], &pick = d["targets"][0];
  QVERIFY(table["name"] == nlohmann::json("table") && table["link"].is_null() && table["body"].is_null());
  QVERIFY(table["position"] == nlohmann::json({1.0, 2.0, 3.0}) && table["chosen"] == nlohmann::json(false));
  QVERIFY(hand["link"] == nlohmann::json("tool0") && hand["chosen"] == nlohmann::json(true));
  QVERIFY(pick["frame"] == nlohmann::json("table") && pick["position"] == nlohmann::json({4.0, 5.0, 6.0}));
  QVERIFY(std::abs(std::abs(pick["quaternion"][3].get<double>()) - 1.0) < 1e-12);
}

void RobotCellKindTest::imports() {
  const OpenedFile opened = importOrThrow(m_package.urdf());
  QVERIFY(opened.file.damage.empty());
  const RobotCellSnapshot& cell = cellIn(opened);
  QCOMPARE(cell.joints, values({0, 0}));
  QCOMPARE(QString::fromStdString(cell.source), m_package.urdf());
  QCOMPARE(cell.robot->description, kArmUrdf);
  QCOMPARE(cell.robot->surfaces.size(), std::size_t{2});  // the mesh is shared by what is seen and what collides
  QVERIFY(isNear(boxOf(*cell.robot->surfaces[0]), Vec3(-100, -100, -50), Vec3(100, 100, 50)));
}

// The file's numbers are metres, whatever the scale makes of them; and they are welded.
void RobotCellKindTest::meshesInMetres() {
  const RobotCellSnapshot cell = cellIn(importOrThrow(m_package.urdf()));
  const TriangleSoup& upper = *cell.robot->surfaces[1];
  QCOMPARE(upper.points.size(), std::size_t{8});
  QCOMPARE(upper.triangles.size(), std::size_t{12});
  QVERIFY(isNear(boxOf(upper), Vec3(-250, -50, -50), Vec3(250, 50, 50)));
  for (const char* ending : {"obj", "ply", "off"}) {
    const auto format = formatForName(std::string("a.") + ending);
    const QString file = m_package.path(QString("arm/meshes/part.") + ending);
    write(file, writeMesh(surfaceOf(BoxShape{{1, 2, 3}}), *format, NumberType::Float64));
    std::vector<Error> damage;
    const auto surface = readSurface(MeshShape{file.toStdString(), {0.0254, 0.0254, -0.0254}}, "/", damage);
    QVERIFY(surface.hasValue() && damage.empty());
    QVERIFY(isNear(boxOf(*surface), Vec3(-12.7, -25.4, -38.1), Vec3(12.7, 25.4, 38.1)));
  }
}

// The meshes of a table stand in the frames of their rows, at 0 by 200 along x, 100 along z and a quarter turn about x;
// their numbers are mm or m.
void RobotCellKindTest::tablesWithMeshes() {
  for (const char* unit : {"mm", "m"}) {
    const double scale = std::string(unit) == "m" ? 1e-3 : 1.0;
    const QString folder = QString("table_") + unit + '/';
    const auto box = [&](const char* name, const Vec3& size) {
      write(m_package.path(folder + name),
            writeMesh(surfaceOf(BoxShape{scale * size}), MeshFormat::Stl, NumberType::Float32));
    };
    box("foot.stl", Vec3(300, 200, 100));
    box("links/upper.stl", Vec3(40, 20, 10));
    const nlohmann::json row = {{"a", 200}, {"alpha", 90}, {"d", 100}, {"theta", 0}, {"mesh", "links/upper.stl"}};
    nlohmann::json table = {{"name", "two"}, {"mesh_unit", unit}, {"base_mesh", "foot.stl"}};
    table["joints"] = {row, {{"a", 50}, {"alpha", 0}, {"mesh", "hand.stl"}}};
    const QString file = m_package.path(folder + "two.dh.json");
    write(file, table.dump());
    // The hand is missing, which is said, and the rest opens.
    const OpenedFile opened = importOrThrow(file);
    QCOMPARE(opened.file.damage.size(), std::size_t{1});
    QCOMPARE(opened.file.damage[0].code, ErrorCode::ReferenceMissing);
    QVERIFY(kKind.describe(*opened.content)["missing_meshes"] == nlohmann::json({"hand.stl"}));
    const RobotCellSnapshot& cell = cellIn(opened);
    const auto boxAt = [&](const char* part, const JointValues& joints) {
      const DisplayModel model = displayOf(*cell.robot, joints);
      const DisplayPart* const found = partNamed(model, part);
      return found ? DisplayModel{{*found}}.bounds() : Box();
    };
    const JointValues ahead = values({0, 0}), left = values({M_PI_2, 1.0});
    QVERIFY(isNear(boxAt("base/0", ahead), Vec3(-150, -100, -50), Vec3(150, 100, 50)));
    QVERIFY(isNear(boxAt("base/0", left), Vec3(-150, -100, -50), Vec3(150, 100, 50)));
    QVERIFY(isNear(boxAt("link_1/0", ahead), Vec3(180, -5, 90), Vec3(220, 5, 110)));
    QVERIFY(isNear(boxAt("link_1/0", left), Vec3(-5, 180, 90), Vec3(5, 220, 110)));
    QVERIFY(displayOf(*cell.robot, ahead).parts.size() == 2);
    // With it nothing is missing.
    box("hand.stl", Vec3(10, 10, 10));
    const OpenedFile whole = importOrThrow(file);
    QVERIFY(whole.file.damage.empty());
    QCOMPARE(kKind.display(*whole.content).parts.size(), std::size_t{3});
  }
  const QString inches = m_package.path("inches.dh.json");
  write(inches, R"({"mesh_unit": "inch", "joints": [{"a": 1, "alpha": 0}]})");
  QCOMPARE(kKind.import(inches.toStdString(), {}, {}).error().code, ErrorCode::ElementMalformed);
}

// The unit of the file once, the scale of the description once, and millimetres.
void RobotCellKindTest::colladaMeshes() {
  const std::string dae =
      "<COLLADA><asset><unit meter='0.0254'/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id='g'><mesh>"
      "<source id='p'><float_array>0 0 0 10 0 0 0 20 30</float_array></source><vertices id='v'><input "
      "semantic='POSITION' source='#p'/></vertices><triangles><input semantic='VERTEX' source='#v' offset='0'/>"
      "<p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene><node>"
      "<instance_geometry url='#g'/></node></visual_scene></library_visual_scenes></COLLADA>";
  const QString file = m_package.path("inch.dae");
  write(file, dae);
  std::vector<Error> damage;
  const auto surface = readSurface(MeshShape{file.toStdString(), {2, 1, 1}}, "/", damage);
  QVERIFY(surface.hasValue());
  QVERIFY(isNear(boxOf(*surface), Vec3::Zero(), Vec3(508, 508, 762)));
}

void RobotCellKindTest::missingMeshes() {
  const ArmPackage package;
  QVERIFY(QFile::remove(package.mesh()));
  const OpenedFile opened = importOrThrow(package.urdf());
  QCOMPARE(opened.file.damage.size(), std::size_t{1});
  QCOMPARE(opened.file.damage[0].code, ErrorCode::ReferenceMissing);
  QVERIFY(!cellIn(opened).robot->surfaces[1]);
  QCOMPARE(kKind.display(*opened.content).parts.size(), std::size_t{1});
  const nlohmann::json description = kKind.describe(*opened.content);
  QVERIFY(description["missing_meshes"] == nlohmann::json({"package://arm/meshes/upper.stl"}));
  // Saved and loaded it is still missing, and that is no damage of the container.
  std::vector<Error> damage;
  const auto again = loaded(saved(*opened.content), damage);
  QVERIFY(again && !again->robot->surfaces[1]);
  QVERIFY(damage.empty());
}

// Reported once, whatever the number of its meshes.
void RobotCellKindTest::missingPackage() {
  QTemporaryDir folder;
  std::string meshes;
  for (const char* name : {"a", "b", "c"})
    meshes +=
        std::string("<visual><geometry><mesh filename='package://elsewhere/") + name + ".stl'/></geometry></visual>";
  write(folder.filePath("r.urdf"), "<robot name='r'><link name='foot'>" + meshes + "</link></robot>");
  const OpenedFile opened = importOrThrow(folder.filePath("r.urdf"));
  QCOMPARE(opened.file.damage.size(), std::size_t{1});
  QCOMPARE(opened.file.unlistedDamage, std::size_t{0});
  QCOMPARE(opened.file.damage[0].arguments,
           (std::vector<std::string>{"the package", "elsewhere", folder.path().toStdString()}));
}

void RobotCellKindTest::damagedMeshes() {
  const auto damageOf = [](const char* name, const std::string& bytes) {
    ArmPackage package;
    write(package.path(name), bytes);
    std::vector<Error> damage;
    const auto surface = readSurface(MeshShape{package.path(name).toStdString(), Vec3::Ones()}, "/", damage);
    if (surface) return damage.empty() ? Error{ErrorCode::Cancelled, {}, {}, "no damage"} : damage[0];
    return surface.error();
  };
  QCOMPARE(damageOf("a.stl", "").code, ErrorCode::FileEmpty);
  QCOMPARE(damageOf("a.stl", "solid a\nfacet").subject.empty(), false);
  QCOMPARE(damageOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n").code, MeshFileError::IndexOutOfRange);
  QCOMPARE(damageOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1e200 0\nf 1 2 3\n").code, ErrorCode::ValueOutOfRange);
  QCOMPARE(damageOf("a.dae", "<COLLADA/>").code, MeshError::NoTriangles);
  QCOMPARE(damageOf("a.dae", "<COLLADA>").code, ErrorCode::ElementMalformed);
}

void RobotCellKindTest::badDescription() {
  write(m_package.path("bad.urdf"), "<robot name='r'><link name='a'/><link name='b'/></robot>");
  const auto opened = kKind.import(m_package.path("bad.urdf").toStdString(), {}, {});
  QVERIFY(!opened);
  QCOMPARE(opened.error().code, ErrorCode::ElementMalformed);
  QCOMPARE(kKind.import(m_package.path("none.urdf").toStdString(), {}, {}).error().code, ErrorCode::FileMissing);
  QCOMPARE(kKind.import(m_package.path("arm").toStdString(), {}, {}).error().code, ErrorCode::FileUnreadable);
}

// 2000 placements of a mesh of 30,000 triangles.
void RobotCellKindTest::tooMuchToShow() {
  TriangleSoup many;
  many.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  many.triangles.assign(30'000, {0, 1, 2});
  write(m_package.path("many.ply"), writeMesh(many, MeshFormat::Ply, NumberType::Float32));
  std::string visuals;
  for (int i = 0; i < 2000; ++i) visuals += "<visual><geometry><mesh filename='many.ply'/></geometry></visual>";
  write(m_package.path("many.urdf"), "<robot><link name='a'>" + visuals + "</link></robot>");
  const OpenedFile opened = importOrThrow(m_package.path("many.urdf"));
  QCOMPARE(opened.file.damage.size(), std::size_t{1});
  QCOMPARE(opened.file.damage[0].code, ErrorCode::FileTooLarge);
  QVERIFY(kKind.display(*opened.content).parts.empty());
}

void RobotCellKindTest::cancelled() {
  JobState state;
  state.cancelled = true;
  const auto opened = kKind.import(m_package.urdf().toStdString(), {}, Progress(state));
  QVERIFY(!opened);
  QCOMPARE(opened.error().code, ErrorCode::Cancelled);
}

void RobotCellKindTest::display() {
  const RobotCellSnapshot cell = cellIn(importOrThrow(m_package.urdf()));
  const DisplayModel model = displayOf(*cell.robot, values({100, M_PI_2}));
  QCOMPARE(model.parts.size(), std::size_t{2});
  const DisplayPart* upper = partNamed(model, "upper/0");
  QVERIFY(upper);
  QVERIFY((upper->pose.translation() - Vec3(100, 250, 0)).norm() < 1e-9);
  QVERIFY(upper->colour == (std::array<float, 3>{1, 0, 0}));
  QCOMPARE(linkOfPart(*cell.robot, "upper/0"), linkNamed(cell.robot->model, "upper"));
  QCOMPARE(linkOfPart(*cell.robot, "upper"), kNone);
  QCOMPARE(linkOfPart(*cell.robot, "none/0"), kNone);
  QVERIFY(isNear(model.bounds(), Vec3(-100, -100, -50), Vec3(150, 500, 50)));

  write(m_package.path("bare.urdf"),
        "<robot><link name='a'><collision><geometry><sphere radius='1'/></geometry></collision></link></robot>");
  QCOMPARE(kKind.display(*importOrThrow(m_package.path("bare.urdf")).content).parts.size(), std::size_t{1});
}

void RobotCellKindTest::describes() {
  const RobotCellSnapshot cell = cellIn(importOrThrow(m_package.urdf()));
  const nlohmann::json d = kKind.describe(*withJoints(cell, values({250, M_PI_2})));
  QVERIFY(d["robot"] == nlohmann::json("arm"));
  QVERIFY(d["links"] == nlohmann::json(5));
  QCOMPARE(d["joints"].size(), std::size_t{2});
  QVERIFY(d["joints"][1]["name"] == nlohmann::json("turn"));
  QVERIFY(d["joints"][1]["kind"] == nlohmann::json("revolute"));
  QVERIFY(d["joints"][1]["upper"] == nlohmann::json(2.0));
  QVERIFY(d["joints"][1]["effort"].is_null());
  QVERIFY(d["joints"][0]["velocity"] == nlohmann::json(500.0));
  QVERIFY(d["tool"]["link"] == nlohmann::json("tool0"));
  QVERIFY(std::abs(d["tool"]["position"][1].get<double>() - 500.0) < 1e-9);
  QVERIFY(std::abs(d["tool"]["quaternion"][0].get<double>() - std::sqrt(0.5)) < 1e-12);
  QVERIFY(d["triangles"] == nlohmann::json(24));
  QVERIFY(!d.dump().empty());
}

void RobotCellKindTest::exports() {
  const RobotCellSnapshot cell = cellIn(importOrThrow(m_package.urdf()));
  const auto moved = withJoints(cell, values({100, M_PI_2}));
  for (const char* name : {"out.stl", "out.obj", "out.ply", "out.off", "out.3mf"}) {
    const std::string path = m_package.path(name).toStdString();
    const auto written = kKind.exportTo(*moved, path, {});
    QVERIFY(written.hasValue());
    QCOMPARE(written->notes.size(), std::size_t{1});
    const auto back = readMeshFile(path, {});
    QVERIFY(back.hasValue());
    QCOMPARE(back->soup.triangles.size(), std::size_t{24});
    QVERIFY(isNear(boxOf(back->soup), Vec3(-100, -100, -50), Vec3(150, 500, 50)));
  }
  QCOMPARE(kKind.exportTo(*moved, m_package.path("out.urdf").toStdString(), {}).error().code,
           DocumentError::ExtensionUnknown);
  JobState state;
  state.cancelled = true;
  const QString path = m_package.path("cancelled.stl");
  QCOMPARE(kKind.exportTo(*moved, path.toStdString(), Progress(state)).error().code, ErrorCode::Cancelled);
  QVERIFY(!QFile::exists(path));
}

HANDWHEEL_TEST(RobotCellKindTest)
#include "RobotCellKindTest.moc"
