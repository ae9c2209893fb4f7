// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/DrillCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/TipTrajectory.h"
#include "cli/volume/DrillReport.h"
#include "cli/volume/VolumeFiles.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/MeshSnapshot.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeMaking.h"
#include "document/volume/exercise/DrillingTask.h"
#include "volume/VolumeErrors.h"
#include "volume/drilling/DrillProgram.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

namespace fs = std::filesystem;

constexpr double kVoxelAtRest = 1.0;  // mm, of a path that goes nowhere

struct DrillRequest {
  fs::path part, path, output, forces;
  ReadOptions read;
  bool isWhole = false;  // voxels are made of all of the part

  bool isMeshWritten() const { return !output.empty() && !isContainerName(output); }
};

NumberType numbersIn(const OpenedFile& opened) {
  const auto mesh = std::dynamic_pointer_cast<const MeshSnapshot>(opened.content);
  return mesh ? mesh->numbers : NumberType::Float64;
}

// The mean speed of the head while it moves, mm/s.
double feedOf(const std::vector<HandPose>& poses) {
  double length = 0.0, time = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double distance = (poses[i].position - poses[i - 1].position).norm();
    if (!(distance > 0.0)) continue;
    length += distance;
    time += poses[i].time - poses[i - 1].time;
  }
  return time > 0.0 ? length / time : 0.0;
}

// Returns the poses of the head's centre. The spindle has the speed of the program, unless the options state another.
Result<std::vector<HandPose>> posesOfProgram(std::string_view text, OperationValues& values) {
  const Result<DrillSetup> setup = drillSetupOf(values);
  if (!setup) return setup.error();
  const Result<DrillProgram> program = readDrillProgram(text);
  if (!program) return program.error();
  std::vector<HandPose> poses;
  for (const DrillProgram::Waypoint& waypoint : program->waypoints)
    poses.push_back(
        {waypoint.time, waypoint.tip + setup->tool.reach() * Vec3::UnitZ(), Eigen::Quaterniond::Identity(), 0});
  if (program->spindle && !values.isSet("rpm"))
    if (const std::string problem = values.set("rpm", *program->spindle); !problem.empty())
      return Error{VolumeErrors::ProgramValue, {"S", problem}, {}, {}};
  return poses;
}

// numbers: of the part.
Status writeResults(const DrillRequest& request, const DrillAnswer& done, NumberType numbers,
                    const DocumentKinds& kinds, Progress progress) {
  if (done.joined) {
    const HalfEdgeMesh& mesh = done.joined->mesh;
    if (mesh.liveFaceCount() == 0) return Error{VolumeErrors::NothingLeft, {}, {}, {}};
    const Result<ExportReport> written = exportMesh(mesh, numbers, request.output, progress);
    if (!written) return written.error();
  } else if (!request.output.empty()) {
    const DocumentKind& kind = *kinds.withId("volume");
    DocumentFile file;
    file.displayUnit = done.file.displayUnit;
    file.assigned = done.file.assigned;
    auto snapshot = done.before ? std::make_shared<VolumeSnapshot>(*done.before) : std::make_shared<VolumeSnapshot>();
    snapshot->volume = done.drilled.volume;
    snapshot->surface = VolumeSurface(snapshot->volume, progress.part(0.0, 0.5));
    snapshot->layers = nullptr;
    snapshot->source = sourceName(request.part);
    snapshot->holes.push_back(done.drilled.hole);
    const Result<WrittenFile> written = saveDocument(kind, file, *snapshot, request.output, progress.part(0.5, 1.0));
    if (!written) return written.error();
  }
  if (request.forces.empty()) return Done{};
  return writeFileAtomically(request.forces, drillForces(done.drilled));
}

// Takes the drill of the part's exercise, with its shank along the planned path, unless the options name another.
void takeTask(const DrillingTask& task, const OperationValues& values, DrillSetup& setup,
              std::vector<HandPose>& poses) {
  const bool isNamed = values.isSet("tool") || values.isSet("material") || values.isSet("rpm");
  if (!isNamed) setup = task.setup();
  for (HandPose& pose : poses)
    pose.orientation = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), -task.plan.direction);
}

// Drills a part as a whole volume.
Status drillWhole(const DrillRequest& request, const OpenedFile& opened, const PoseTrajectory& path, double rate,
                  MemoryNotice& notice, DrillAnswer& done, Progress progress) {
  Result<SparseVolume> volume = materialOf(opened, request.part, done.voxel, {}, notice, progress.part(0.0, 0.4));
  if (!volume) return volume.error();
  done.voxel = volume->voxel();
  if (!done.before) done.made = MadeVoxels{false, volume->blockCount(), volume->blockCount(), volume->bytes()};
  Result<Drilled> drilled = drillAlong(std::move(*volume), done.setup, path, rate, progress.part(0.4, 1.0));
  if (!drilled) return drilled.error();
  done.drilled = std::move(*drilled);
  return Done{};
}

// Cuts the hole into the triangles of the part, if a mesh is written. False: it must be cut into the voxels.
Result<bool> joinHole(const DrillRequest& request, const OpenedFile& opened, const HybridPart& part, DrillAnswer& done,
                      Progress progress) {
  const Result<MeshFormat> format = formatForOutput(request.output);
  if (!format) return format.error();
  DrilledTriangles joined = drilledTriangles(placedSoup(opened.kind->display(*opened.content)), part,
                                             *done.drilled.hole, numberTypeOf(*format, numbersIn(opened)), progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  done.notJoined = notJoinedReason(joined.problem);
  if (joined.problem == SubtractionProblem::None) done.joined = std::move(joined);
  return done.joined.has_value();
}

// Drills a part that has voxels near the head only. False: they may differ from those of the whole part, or no mesh can
// be made of them, and nothing is drilled.
Result<bool> drillHybrid(const DrillRequest& request, const OpenedFile& opened, const PoseTrajectory& path, double rate,
                         DrillAnswer& done, Progress progress) {
  if (request.isMeshWritten() && std::isfinite(done.setup.erosion)) {
    done.notJoined = "--erosion leaves material in the head";
    return false;
  }
  if (request.isMeshWritten()) done.notJoined = "voxels near the head are not certain to be those of the whole part";
  Result<HybridPart> part = hybridOf(opened, request.part, done.voxel, progress.part(0.0, 0.3));
  // Bodies that are inside out can outweigh sound ones; voxels distinguish them.
  if (!part && part.error().code == VolumeErrors::NothingInside) return false;
  if (!part) return part.error();
  Result<Drilled> drilled = drillAlong(*part, done.setup, path, rate, progress.part(0.3, 0.7));
  if (!drilled) return drilled.error();
  if (!part->isExact()) return false;
  done.drilled = std::move(*drilled);
  if (request.isMeshWritten()) {
    const Result<bool> isJoined = joinHole(request, opened, *part, done, progress.part(0.7, 1.0));
    if (!isJoined || !*isJoined) return isJoined;
  }
  const HybridPart::Figures& figures = part->figures();
  done.made = MadeVoxels{true, figures.blocksMade, figures.mostBlocks, figures.mostBytes};
  return true;
}

Result<DrillAnswer> drillFile(const DrillRequest& request, const OperationValues& values, std::vector<HandPose> poses,
                              const DocumentKinds& kinds, MemoryNotice& notice, Progress progress) {
  Result<DrillSetup> setup = drillSetupOf(values);
  if (!setup) return setup.error();
  const Result<OpenedFile> opened = kinds.open(request.part, request.read, progress.part(0.0, 0.1));
  if (!opened) return opened.error();
  DrillAnswer done{opened->file, {}, {}, *setup, 0.0, {}, {}, {}, {}};
  if (const auto before = volumeIn(*opened)) {
    done.before = before;
  } else {
    done.file.assigned = {};
  }
  if (const auto task = assignedDrilling(done.file.assigned)) takeTask(*task, values, *setup, poses);
  done.setup = *setup;
  if (!request.output.empty()) done.refusal = refusalToReplace(request.output, opened->file);
  if (!done.refusal.empty()) return done;
  const double rate = values.number("rate"), feed = feedOf(poses);
  done.voxel = values.given("voxel").value_or(feed > 0.0 ? drillVoxel(feed, rate) : kVoxelAtRest);
  const PoseTrajectory path(poses);
  // Saving needs all voxels.
  bool isDrilled = false;
  if (!done.before && !request.isWhole && (request.output.empty() || request.isMeshWritten())) {
    const Result<bool> hybrid = drillHybrid(request, *opened, path, rate, done, progress.part(0.1, 0.5));
    if (!hybrid) return hybrid.error();
    isDrilled = *hybrid;
  }
  if (!isDrilled)
    if (const Status whole = drillWhole(request, *opened, path, rate, notice, done, progress.part(0.5, 0.8)); !whole)
      return whole.error();
  const Status written = writeResults(request, done, numbersIn(*opened), kinds, progress.part(0.8, 1.0));
  if (!written) return written.error();
  return done;
}

CommandSpec drillSpec() {
  CommandSpec spec = {
      "drill",
      "PART",
      "Drills a part along the path of a head and reports thrust, torque and work. Only the head removes "
      "material; its shank\npoints up, along z. The part may be any document. Of triangles, voxels are made near the "
      "head only, and a mesh (-o) has\nthe hole in the triangles of the part; a volume takes voxels of all of the "
      "part. "
      "Work on an exercise is drilled with the\nexercise's drill, along its planned path, and can be handed in.\n"
      "Exit code 0: done; 1: error.",
      {{"path", 0, "FILE", "The head's centre: CSV with the columns t_s, x_mm, y_mm, z_mm"},
       {"program", 0, "FILE", "Or a program: G0, G1, G81 to G83; X, Y, Z of the foremost point, S the spindle"},
       {"output", 'o', "OUT", "The drilled part: a .handwheel, or a mesh"},
       {"forces", 0, "CSV", "Write thrust and torque of each cycle"}}};
  for (OptionSpec& option : optionsOf(drillOperation())) spec.options.push_back(std::move(option));
  spec.options.push_back({"whole", 0, "", "Make voxels of all of the part, not near the head only"});
  spec.options.push_back(consentOption());
  addVolumeOptions(spec.options);
  return spec;
}

int runDrill(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(drillOperation());
  const std::string problem = readOptions(arguments, values);
  if (!problem.empty()) return failUsage(problem, "drill");
  if (arguments.has("path") == arguments.has("program"))
    return failUsage(arguments.has("path") ? "Choose one of --path and --program."
                                           : "The option --path FILE is missing, or --program FILE.",
                     "drill");
  DrillRequest request{arguments.operands[0],
                       arguments.valueOf(arguments.has("program") ? "program" : "path"),
                       arguments.valueOf("output"),
                       arguments.valueOf("forces"),
                       {},
                       arguments.has("whole")};
  request.read.partial = arguments.has("partial");
  if (!request.output.empty() && !isContainerName(request.output)) {
    if (const auto format = formatForOutput(request.output); !format) return fail(format.error());
  }
  const auto failFile = [&](Error error) {
    error.subject = request.path.string();
    return fail(error);
  };
  const Result<std::string> text = readFileBytes(request.path);
  if (!text) return failFile(text.error());
  std::vector<HandPose> poses;
  if (arguments.has("program")) {
    Result<std::vector<HandPose>> read = posesOfProgram(*text, values);
    if (!read) return failFile(read.error());
    poses = std::move(*read);
  } else {
    TipTrajectory path = readTipTrajectory(*text);
    if (!path.problem.empty()) return refuse(request.path.string() + ": " + path.problem);
    poses = std::move(path.poses);
  }
  MemoryNotice notice(arguments);
  std::optional<Result<DrillAnswer>> result;
  runInterruptible("Drilling", [&](CommandJob& job) {
    result = drillFile(request, values, poses, kinds, notice.during(job), job.progress());
  });
  if (!*result) return fail(result->error());
  const DrillAnswer& done = result->value();
  reportLosses(done.file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  return print(arguments.has("json") ? drillReport(done, notice).dump() + "\n" : drillText(done));
}

}  // namespace

Command drillCommand() {
  return {drillSpec(), runDrill};
}

}  // namespace handwheel
