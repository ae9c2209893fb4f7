// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/RobotCellKind.h"
#include "document/cell/RobotCellSnapshot.h"
#include "document/container/Blobs.h"
#include "document/container/UnknownPart.h"
#include "document/container/ZipWriter.h"
#include "document/exercise/ExerciseKind.h"
#include "document/mesh/MeshKind.h"
#include "document/mesh/SubdivisionLevelStore.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeSnapshot.h"
#include "document/volume/exercise/DrillingSubject.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/exercise/TurningSubject.h"
#include "mesh/structure/MeshValidator.h"
#include "robot/UrdfReader.h"
#include "scene/MeshGeometry.h"
#include "scene/PrimitiveGeometry.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is an archive; or, where it
// begins with a brace, the manifest of one, so that changes get past the checksums. Each kind of document reads it.

using namespace handwheel;

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ContainerFuzz: %s\n", what);
  std::abort();
}

nlohmann::json ownPart(nlohmann::json manifest) {
  manifest.erase("handwheel");
  return manifest;
}

bool same(const Container& a, const Container& b) {
  return ownPart(*a.manifest) == ownPart(*b.manifest) && a.blobs == b.blobs;
}

// Writes a container that was read, and checks that it is read back the same, whole.
void writeAndRead(const Container& container, Compression compression) {
  const auto bytes = writeContainer(container, compression);
  if (!bytes && bytes.error().code == ErrorCode::FileTooLarge) return;  // a manifest grows when it is written
  require(bytes.hasValue(), "what was read cannot be written");
  require(looksLikeContainer(*bytes), "what was written is not recognised");
  const auto again = readContainer(*bytes);
  require(again.hasValue() && again->damage.empty(), "what was written is not read");
  require(same(again->container, container), "what was written is read differently");
}

void requireValid(const MeshSnapshot& mesh) {
  require(validate(mesh.mesh.mesh).empty(), "the mesh is not valid");
  if (!mesh.levels) return;
  require(isSameVersion(mesh.levels->mesh(), mesh.mesh.mesh), "the finest level is not the mesh");
  for (std::size_t i = 0; i < mesh.levels->finest(); ++i)
    require(validate(mesh.levels->mesh(i)).empty(), "a level is not valid");
}

// Reads any content; once it was read, it is saved and read without loss.
void readAs(const DocumentKind& kind, const Container& container) {
  std::vector<Error> damage;
  const auto content = kind.load(container, damage, {});
  if (!content) return;
  if (const auto* mesh = dynamic_cast<const MeshSnapshot*>(content->get())) requireValid(*mesh);
  Container saved, again;
  kind.save(**content, saved);
  const auto back = kind.load(saved, damage, {});
  require(back.hasValue(), "what was read is not saved");
  kind.save(**back, again);
  require(same(saved, again), "what was saved is read differently");
}

std::unique_ptr<ExerciseKind> exerciseKind() {
  std::vector<std::unique_ptr<ExerciseSubject>> subjects;
  subjects.push_back(std::make_unique<TurningSubject>());
  subjects.push_back(std::make_unique<DrillingSubject>());
  return std::make_unique<ExerciseKind>(std::move(subjects));
}

const std::vector<std::unique_ptr<DocumentKind>>& kinds() {
  static const std::vector<std::unique_ptr<DocumentKind>> kKinds = [] {
    std::vector<std::unique_ptr<DocumentKind>> all;
    all.push_back(std::make_unique<MeshKind>());
    all.push_back(std::make_unique<WorkpieceKind>());
    all.push_back(std::make_unique<RobotCellKind>());
    all.push_back(exerciseKind());
    all.push_back(std::make_unique<VolumeKind>());
    return all;
  }();
  return kKinds;
}

void judge(std::string_view archive, Compression compression) {
  const auto read = readContainer(archive);
  if (!read) return;
  require(read->container.manifest->is_object(), "the manifest is no object");
  for (const auto& [name, bytes] : read->container.blobs)
    require(!name.empty() && name.front() != '/' && name.find("..") == std::string::npos, "a name leads elsewhere");
  for (std::uint64_t count : {std::uint64_t{7}, ~std::uint64_t{0}}) {
    const auto array = readArray<double>(read->container, "mesh/positions", count, 3);
    require(array.values.size() <= 3 * count || count > 7, "more values than asked for");
  }
  if (read->container.manifest->value("document", nlohmann::json()).is_object()) {
    for (const auto& kind : kinds()) readAs(*kind, read->container);
  }
  writeAndRead(read->container, compression);
  const Container nothing;
  require(same(merged(unknownPart(read->container, nothing, {}), nothing), read->container), "unknown keys are lost");
}

// Two triangles, subdivided twice.
MeshSnapshot smallMesh() {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}};
  PatchLevels levels(buildMesh(soup).mesh, {0, 1});
  levels.refine();
  levels.refine();
  MeshSnapshot content;
  content.build = std::make_shared<const BuildReport>();
  content.mesh.mesh = levels.mesh();
  content.levels = std::make_shared<const PatchLevels>(levels);
  return content;
}

// A bar with a groove, in 11 samples.
WorkpieceSnapshot smallWorkpiece() {
  WorkpieceSnapshot content;
  TurningPass pass;
  pass.path = {{30, 40}, {15, 40}};
  pass.times = {0, 1};
  content.part = withPass(content, pass, content.stock.length / 10);
  return content;
}

// A robot of one link with a mesh, beside it a body of each shape.
RobotCellSnapshot smallCell() {
  TriangleSoup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  CellRobot robot;
  robot.description =
      R"(<robot name="r"><link name="l"><visual><geometry><mesh filename="a.stl"/></geometry></visual></link></robot>)";
  const auto read = readUrdf(robot.description);
  require(read.hasValue(), "no robot");
  robot.model = read->robot;
  robot.arms = {wholeArm(robot.model)};
  robot.surfaces.push_back(std::make_shared<const TriangleSoup>(triangle));
  RobotCellSnapshot content;
  content.robot = std::make_shared<const CellRobot>(std::move(robot));
  const auto add = [&](const char* name, GeometryPointer geometry) {
    Body body;
    body.id = content.bodies.freeId();
    body.name = name;
    body.geometry = std::move(geometry);
    content.bodies = content.bodies.with(std::make_shared<const Body>(std::move(body)));
  };
  add("mesh", std::make_shared<const MeshGeometry>(triangle));
  std::vector<Note> notes;
  add("bar", WorkpieceKind().bodyGeometry(WorkpieceSnapshot(), notes));
  add("box", *PrimitiveGeometry::make(Primitive::Cuboid, {1, 2, 3}));
  return content;
}

// A voxel, beside a full block; an image of which one sample was painted.
VolumeSnapshot smallVolume() {
  VolumeSnapshot content;
  content.volume = SparseVolume(Vec3::Zero(), 0.5);
  auto block = std::make_shared<VolumeBlock>();
  block->depths.fill(VolumeBlock::kEmpty);
  block->depths[100] = VolumeBlock::kFull;
  content.volume.setContent(VoxelIndex(0, 0, 0), {std::move(block), false});
  content.volume.setContent(VoxelIndex(1, 0, 0), {nullptr, true});
  const ImageGrid grid{{18, 2, 1}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
  std::vector<std::int16_t> samples(grid.count(), -1000);
  samples[3] = 400;
  ImageVolume image(grid, std::move(samples));
  ImageHistogram histogram = histogramOf(image);
  content.scan = std::make_shared<const Scan>(Scan{std::move(image), std::move(histogram)});
  content.segment = Segment({300.0, 2000.0});
  auto brick = std::make_shared<SegmentBrick>();
  brick->set(1, 1, 0, true);
  content.segment.setBrick(grid.size, VoxelIndex(16, 0, 0), std::move(brick));
  return content;
}

// A new exercise with that bar as model solution and as work.
ExerciseSnapshot smallExercise(const ExerciseKind& kind) {
  ExerciseSnapshot content = static_cast<const ExerciseSnapshot&>(*kind.blank());
  content.solution = content.work = std::make_shared<const WorkpieceSnapshot>(smallWorkpiece());
  content.attempt = Attempt{"Ada", {}, {}, 1.0, {1}, {true}};
  return content;
}

// The blobs of all kinds; their names differ.
const std::map<std::string, std::string>& smallBlobs() {
  static const std::map<std::string, std::string> kBlobs = [] {
    Container container;
    MeshKind().save(smallMesh(), container);
    WorkpieceKind().save(smallWorkpiece(), container);
    RobotCellKind().save(smallCell(), container);
    VolumeKind().save(smallVolume(), container);
    const auto exercises = exerciseKind();
    exercises->save(smallExercise(*exercises), container);
    return container.blobs;
  }();
  return kBlobs;
}

std::string withManifest(std::string_view manifest) {
  std::vector<ZipEntry> entries = {{"manifest.json", manifest}, {"a", ""}};
  for (const auto& [name, bytes] : smallBlobs()) entries.push_back({name, bytes});
  const auto archive = writeZip(entries, Compression::None);
  require(archive.hasValue(), "no archive");
  return *archive;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Compression compression = size % 2 == 0 ? Compression::None : Compression::Fast;
  judge(bytes.starts_with('{') ? withManifest(bytes) : std::string(bytes), compression);
  return 0;
}
