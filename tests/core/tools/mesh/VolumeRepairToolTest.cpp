// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/VolumeRepairTool.h"

#include "ClosedSurface.h"
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "ScriptWork.h"
#include "TestClass.h"
#include "mesh/structure/MeshValidator.h"
#include "process/SystemMemory.h"
#include "proximity/SelfIntersection.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"

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
  void wallsAreMeasuredByAJob();
  void aSheetStaysWithTheReason();
  void aSheetBecomesAWall();
  void aCancelledRepairChangesNothing();
  void muchMemoryIsAskedFor();
  void refusalsHaveTheirNumbers();
  void lostWallsAreSaid();
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

// Nothing waits for it but a repair with walls; a result that comes after a change of the mesh counts no more.
void VolumeRepairToolTest::wallsAreMeasuredByAJob() {
  test::Work work(test::cube(10.0));
  std::vector<ToolJob> jobs;
  MeshServices services = work.services();
  services.run = [&](const ToolJob& job) { jobs.push_back(job); };
  const MeshServices atOnce = work.services();
  VolumeRepairTool tool(*work.document, services), measured(*work.document, atOnce);
  const auto canStart = [](const VolumeRepairTool& one) { return one.actions().front().enabled; };
  QVERIFY(canStart(tool));
  QCOMPARE(settingOf(tool, "memory"), settingOf(measured, "memory"));
  for (VolumeRepairTool* each : {&tool, &measured}) each->setSetting("wall", 2.0);
  QVERIFY(!canStart(tool));
  QVERIFY(!tool.actions().front().reason.empty());
  QCOMPARE(settingOf(tool, "memory"), -1.0);
  QCOMPARE(tool.perform("commit"), ToolReply::Ignored);
  QVERIFY(canStart(measured));
  QCOMPARE(jobs.size(), std::size_t{1});
  const std::function<void()> late = jobs[0].work(Progress());
  tool.documentChanged();
  late();
  QVERIFY(!canStart(tool));
  QCOMPARE(jobs.size(), std::size_t{2});
  jobs[1].work(Progress())();
  QVERIFY(canStart(tool));
  QCOMPARE(settingOf(tool, "memory"), settingOf(measured, "memory"));
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

// The voxel for which a cube needs this share of the memory that is left.
double voxelForShare(double share) {
  const double one = predictedMakingBytes(600.0, Vec3::Constant(10.0), 1.0);  // it goes by the square
  return std::sqrt(one / (share * static_cast<double>(systemMemory())));
}

// A person is asked with the number, and what was not agreed to does not begin.
void VolumeRepairToolTest::muchMemoryIsAskedFor() {
  test::Work work(test::cube(10.0));
  std::vector<double> asked;
  std::vector<std::string> begun;
  MeshServices services = work.services();
  services.commit = [&](const MeshChange& change) { begun.push_back(change.step); };
  bool agrees = false;
  VolumeRepairTool tool(*work.document, services, [&](double bytes, const std::function<void()>& start) {
    asked.push_back(bytes);
    if (agrees) start();
  });
  tool.setSetting("voxel", 1.0);
  tool.perform("commit");
  QVERIFY(asked.empty());
  QCOMPARE(begun.size(), std::size_t{1});
  QVERIFY2(begun[0].find("yes") == std::string::npos, begun[0].c_str());
  tool.setSetting("voxel", voxelForShare(0.5));
  tool.perform("commit");
  QCOMPARE(asked.size(), std::size_t{1});
  QVERIFY(std::abs(asked[0] / (0.5 * static_cast<double>(systemMemory())) - 1.0) < 0.2);
  QCOMPARE(begun.size(), std::size_t{1});
  agrees = true;
  tool.perform("commit");
  QCOMPARE(begun.size(), std::size_t{2});
  QVERIFY2(begun[1].find("--yes") != std::string::npos, begun[1].c_str());
}

// Holds also for a step without this value.
void VolumeRepairToolTest::refusalsHaveTheirNumbers() {
  const auto document = test::meshDocument(test::cube(10.0));
  const auto refusal = [&](double voxel) {
    const MeshChange change = volumeRepairChange({.voxel = voxel}, NumberType::Float64);
    return commitChange(*document, change) ? std::optional<Error>() : change.volume->error;
  };
  for (const auto& [share, code] :
       {std::pair(0.5, ErrorCode(VolumeErrors::NeedsConsent)), std::pair(4.0, ErrorCode(VolumeErrors::TooLarge))}) {
    const std::optional<Error> error = refusal(voxelForShare(share));
    QVERIFY(error && error->arguments.size() == 3);
    QVERIFY(error->code == code);
    QVERIFY(std::abs(std::stod(error->arguments[1]) / (1e-6 * share * static_cast<double>(systemMemory())) - 1.0) <
            0.2);
  }
  const std::optional<Error> coarse = refusal(100.0);
  QVERIFY(coarse && coarse->arguments == std::vector<std::string>{"100"});
  QVERIFY(!refusal(1.0));
}

// A plate of a third of a voxel beside a cube, between the samples.
void VolumeRepairToolTest::lostWallsAreSaid() {
  for (const bool isThin : {false, true}) {
    TriangleSoup part = test::cube(10.0), plate = test::cube(1.0);
    for (Vec3& p : plate.points) p = Vec3(20.0 + (isThin ? 0.3 : 3.0) * p.x(), 10.0 * p.y(), 10.0 * p.z());
    test::append(part, plate);
    const auto document = test::meshDocument(part);
    const MeshChange change = volumeRepairChange({.voxel = 1.0}, NumberType::Float64);
    QVERIFY(commitChange(*document, change));
    QCOMPARE(change.volume->hasLostWalls, isThin);
  }
}

HANDWHEEL_TEST(VolumeRepairToolTest)
#include "VolumeRepairToolTest.moc"
