// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/VolumeRepairTool.h"

#include "ClosedSurface.h"
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "StepWork.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"
#include "proximity/SelfIntersection.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"

#include <QTest>

using namespace handwheel;

namespace {

// A cube of 10 mm, and a bar that stands out of it by 5 × 5 × 5 mm.
TriangleSoup cubeAndBar() {
  TriangleSoup soup = test::cube(10.0);
  TriangleSoup other = test::cube(10.0);
  for (Vec3& p : other.points) p = Vec3(p.x() + 5.0, 0.5 * p.y() + 2.5, 0.5 * p.z() + 2.5);
  test::append(soup, other);
  return soup;
}

double settingOf(const VolumeRepairTool& tool, std::string_view id) {
  for (const Property& setting : tool.settings())
    if (setting.id == id) return std::get<double>(setting.value);
  return -1.0;
}

}  // namespace

class VolumeRepairToolTest : public QObject {
  Q_OBJECT

 private slots:
  void oneStepMakesItSound();
  void coordinatesAreThoseOfTheFile();
  void theVoxelOfTheUserStays();
  void gapsAreFilledOnRequest();
  void noTriangles();
  void aSheetStaysWithTheReason();
  void aSheetBecomesAWall();
  void aCancelledRepairChangesNothing();
};

// 1000 mm³, and what stands out.
void VolumeRepairToolTest::oneStepMakesItSound() {
  test::Work work(cubeAndBar());
  const HalfEdgeMesh before = work.document->mesh();
  VolumeRepairTool tool(*work.document, work.services());
  tool.setSetting("voxel", 0.2);
  QCOMPARE(tool.perform("commit"), ToolReply::Used);
  const HalfEdgeMesh& after = work.document->mesh();
  QCOMPARE(validate(after), std::string());
  const TriangleSoup soup = after.compact().soup;
  QVERIFY(test::isClosedManifold(soup));
  QVERIFY(selfIntersections(soup.points, soup.triangles)->empty());
  QCOMPARE(work.document->defects().components.size(), std::size_t{1});
  const double area = 600.0 + 4.0 * 25.0;  // mm², of which no part is farther off than a voxel
  QVERIFY(std::abs(test::volume(soup) - 1125.0) < 0.2 * area);
  QVERIFY2(work.step().starts_with("by-volume "), work.step().c_str());
  QCOMPARE(work.check(1), std::string());
  work.document->history()->undo();
  QVERIFY(test::sameMesh(work.document->mesh(), before));
}

void VolumeRepairToolTest::coordinatesAreThoseOfTheFile() {
  HalfEdgeMesh mesh = buildMesh(cubeAndBar()).mesh;
  volumeRepairChange({.voxel = 0.3}, NumberType::Float32).apply(mesh, {});
  QVERIFY(mesh.liveFaceCount() > 24);
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
    QVERIFY(mesh.position(v) == rounded(mesh.position(v), NumberType::Float32));
}

void VolumeRepairToolTest::theVoxelOfTheUserStays() {
  const auto document = test::meshDocument(test::cube(10.0));
  VolumeRepairTool tool(*document, immediateServices(*document));
  QCOMPARE(settingOf(tool, "voxel"), 10.0 / 256.0);
  const double fine = settingOf(tool, "memory");
  tool.setSetting("voxel", 1.0);
  QVERIFY(settingOf(tool, "memory") < fine);
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    tool.setSetting("voxel", bad);
    QCOMPARE(settingOf(tool, "voxel"), 1.0);
  }
  // The triangles of blocks and their hierarchy take more than anything else.
  tool.setSetting("voxel", 0.1);
  const double withoutFilling = settingOf(tool, "memory");
  tool.setSetting("close_gaps", 0.5);
  QVERIFY(settingOf(tool, "memory") > withoutFilling);
  tool.setSetting("voxel", 1.0);
  tool.documentChanged();
  QCOMPARE(settingOf(tool, "voxel"), 1.0);
}

// Two plates of 10 × 10 × 2 mm, 1 mm apart: a ball of 0.5 mm gets in between, one of 1 mm does not.
void VolumeRepairToolTest::gapsAreFilledOnRequest() {
  TriangleSoup plates;
  for (const double z : {0.0, 3.0}) {
    TriangleSoup plate = test::cube(10.0);
    for (Vec3& p : plate.points) p.z() = z + 0.2 * p.z();
    test::append(plates, plate);
  }
  for (const auto& [radius, pieces] : {std::pair(0.0, 2), std::pair(0.4, 2), std::pair(1.0, 1)}) {
    test::Work work(plates);
    VolumeRepairTool tool(*work.document, work.services());
    tool.setSetting("voxel", 0.2);
    tool.setSetting("close_gaps", radius);
    QCOMPARE(tool.perform("commit"), ToolReply::Used);
    QCOMPARE(work.document->defects().components.size(), std::size_t(pieces));
    QCOMPARE(work.check(1), std::string());
  }
}

void VolumeRepairToolTest::noTriangles() {
  const auto document = test::meshDocument(TriangleSoup());
  const VolumeRepairTool tool(*document, immediateServices(*document));
  QVERIFY(!tool.actions().front().enabled);
  QVERIFY(tool.settings().empty());
}

void VolumeRepairToolTest::aSheetStaysWithTheReason() {
  const auto document = test::meshDocument({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}});
  const HalfEdgeMesh before = document->mesh();
  const MeshChange change = volumeRepairChange({}, NumberType::Float64);
  QVERIFY(!commitChange(*document, change));
  QVERIFY2(std::string(reasonOf(change)).find("encloses nothing") != std::string::npos, reasonOf(change));
  QVERIFY(test::sameMesh(document->mesh(), before));
}

// A square of 10 mm becomes a plate of 2 mm, rounded by less than a voxel.
void VolumeRepairToolTest::aSheetBecomesAWall() {
  const auto document =
      test::meshDocument({{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 10, 0), Vec3(0, 10, 0)}, {{0, 1, 2}, {0, 2, 3}}});
  VolumeRepairTool tool(*document, immediateServices(*document));
  tool.setSetting("wall", 2.0);
  QCOMPARE(settingOf(tool, "voxel"), 10.0 / 256.0);
  tool.setSetting("wall", 0.1);
  QCOMPARE(settingOf(tool, "voxel"), 0.025);  // four to the wall
  tool.setSetting("wall", 2.0);
  tool.setSetting("voxel", 0.25);
  QCOMPARE(tool.perform("commit"), ToolReply::Used);
  const TriangleSoup soup = document->mesh().compact().soup;
  QVERIFY(test::isClosedManifold(soup));
  QVERIFY(std::abs(test::volume(soup) - 200.0) < 0.25 * 280.0);  // its area by a voxel
}

void VolumeRepairToolTest::aCancelledRepairChangesNothing() {
  const auto document = test::meshDocument(cubeAndBar());
  const HalfEdgeMesh before = document->mesh();
  JobState state;
  state.cancelled = true;
  QVERIFY(!commitChange(*document, volumeRepairChange({.voxel = 0.2}, NumberType::Float64), Progress(state)));
  QVERIFY(test::sameMesh(document->mesh(), before));
}

HANDWHEEL_TEST(VolumeRepairToolTest)
#include "VolumeRepairToolTest.moc"
