// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/VolumeCommands.h"

#include "base/NumberText.h"
#include "cli/FidelityOption.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/ThinJson.h"
#include "cli/volume/BooleanCommand.h"
#include "cli/volume/ClayCommand.h"
#include "cli/volume/DrillCommand.h"
#include "cli/volume/DrillExperimentCommand.h"
#include "cli/volume/OutputName.h"
#include "cli/volume/SegmentCommand.h"
#include "cli/volume/ShellOffsetCommands.h"
#include "cli/volume/VolumeFiles.h"
#include "document/formats/MeshExport.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeMaking.h"
#include "report/BoundText.h"
#include "text/NoteText.h"
#include "tools/volume/VoxelizeOperations.h"
#include "volume/VolumeFidelity.h"
#include "volume/repair/TriangleWalls.h"

#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

namespace fs = std::filesystem;

struct Request {
  fs::path input, output;
  ReadOptions read;
  FidelityValues fidelity;
};

// Reads the words that both commands have. Returns what is wrong with them, or nothing.
std::string readRequest(const Arguments& arguments, Request& request, OperationValues& values) {
  if (!arguments.has("output")) return "The option -o OUT is missing.";
  request.input = arguments.operands[0];
  request.output = arguments.valueOf("output");
  request.read.partial = arguments.has("partial");
  return readOptions(arguments, values);
}

struct Answer {
  DocumentFile file;  // the file, with the damage found in reading
  std::string refusal;
  std::string text;
  nlohmann::ordered_json report;
  std::vector<Note> warnings;
  bool isSound = true;  // a mesh as it is in its file
};

int deliver(const std::optional<Result<Answer>>& result, const Arguments& arguments) {
  if (!*result) return fail(result->error());
  const Answer& done = result->value();
  reportLosses(done.file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  for (const Note& warning : done.warnings) complain(noteText(warning).toStdString());
  const int code = print(arguments.has("json") ? done.report.dump() + "\n" : done.text);
  return code == kExitDone && !done.isSound ? kExitSomethingLeft : code;
}

// File name extensions of volumes.
std::vector<std::string> volumeEndings() {
  return {".vdb", ".nrrd", std::string(kContainerEnding)};
}

Result<Answer> voxelizeFile(const Request& request, const OperationValues& values, const DocumentKinds& kinds,
                            MemoryNotice& notice, Progress progress) {
  if (!hasOneOf(request.output, volumeEndings())) return unknownEnding(request.output, volumeEndings());
  const Result<OpenedFile> opened = kinds.open(request.input, request.read, progress.part(0.0, 0.1));
  if (!opened) return opened.error();
  Answer done{opened->file, refusalToReplace(request.output, opened->file), {}, {}, {}};
  if (!done.refusal.empty()) return done;
  const TriangleSoup surface = placedSoup(opened->kind->display(*opened->content));
  const std::optional<double> wall = values.given("wall");
  const TriangleSoup solid = wall ? wallsOf(surface, *wall) : surface;
  const double voxel = values.given("voxel").value_or(usualVoxel(solid, request.fidelity.of(volumeVoxelsSetting())));
  const VoxelMethod method =
      values.isSet("method") ? static_cast<VoxelMethod>(values.whole("method")) : voxelMethodOf(request.fidelity);
  const Status begun = notice.begin(solid, voxel);
  const Result<MadeVolume> made =
      begun ? makeVolume(solid, voxel, sourceName(request.input), progress.part(0.1, 0.8), method) : begun.error();
  if (!made) {
    Error error = made.error();
    error.subject = request.input.string();
    return error;
  }
  const DocumentKind& kind = *kinds.withId("volume");
  DocumentFile file;
  file.displayUnit = opened->file.displayUnit;
  const Result<WrittenFile> written = saveDocument(kind, file, *made->volume, request.output, progress.part(0.8, 1.0));
  if (!written) return written.error();
  const SparseVolume& volume = made->volume->volume;
  done.report = {{"voxel_mm", volume.voxel()},
                 {"volume_mm3", volume.enclosed()},
                 {"enclosed_mm3", made->surface.expected},
                 {"near_share", made->surface.nearShare},
                 {"closed_boundaries", made->surface.closedBoundaries},
                 {"crumbs_removed", made->surface.removedCrumbs},
                 {"blocks", volume.blockCount()},
                 {"bytes", volume.bytes()}};
  const ThinFigures walls = thinFigures(made->surface.thin, ThinKind::Walls, made->surface.volume);
  addThinParts(done.report, walls, thinFigures(made->surface.thin, ThinKind::Gaps, made->surface.volume));
  done.report["sound"] = !walls.isChanged() && made->surface.nearShare >= 1.0 - kThinShare;
  notice.addTo(done.report);
  done.warnings = notesOn(made->surface);
  done.text = request.output.string() + ": voxels of " + roundedText(volume.voxel()) + " mm, " +
              roundedText(volume.enclosed()) + " mm³, " + roundedText(static_cast<double>(volume.bytes()) / 1e6, 3) +
              " MB.\n";
  if (made->surface.closedBoundaries > 0)
    done.text += "Boundaries closed: " + std::to_string(made->surface.closedBoundaries) + ".\n";
  if (made->surface.removedCrumbs > 0)
    done.text += "Crumbs at the rims of openings removed: " + std::to_string(made->surface.removedCrumbs) + ".\n";
  return done;
}

Result<Answer> remeshFile(const Request& request, const OperationValues& values, const DocumentKinds& kinds,
                          Progress progress) {
  if (const auto format = formatForOutput(request.output); !format) return format.error();
  const Result<OpenedFile> opened = kinds.open(request.input, request.read, progress.part(0.0, 0.1));
  if (!opened) return opened.error();
  Answer done{opened->file, {}, {}, {}, {}};
  const auto volume = volumeIn(*opened);
  if (!volume) {
    done.refusal = request.input.string() + ": it is not a volume. 'handwheel voxelize' makes one of a mesh.";
    return done;
  }
  const Result<Remeshed> made = remesh(volume->volume, values, progress.part(0.1, 0.8));
  if (!made) return made.error();
  const Result<ExportReport> written =
      exportMesh(made->mesh, NumberType::Float64, request.output, progress.part(0.8, 1.0));
  if (!written) return written.error();
  done.isSound = written->isSound();
  done.report = {
      {"triangles_before", made->before}, {"triangles", made->mesh.liveFaceCount()}, {"sound", done.isSound}};
  if (made->largestDistance) done.report["distance_mm"] = *made->largestDistance;
  done.text = request.output.string() + ": " + std::to_string(made->mesh.liveFaceCount()) + " triangles";
  if (made->largestDistance)
    done.text += " of " + std::to_string(made->before) + ", at most " + roundedUpText(*made->largestDistance) +
                 " mm from the surface";
  done.text += ".\n";
  done.warnings = notesOn(*written);
  return done;
}

CommandSpec voxelizeSpec() {
  CommandSpec spec = {
      "voxelize",
      "FILE",
      "Creates a volume from the surface of a document. Holes and gaps are closed, overlapping bodies are\n"
      "united, and walls within them vanish. Exit code 0: done; 1: error.",
      {{"output", 'o', "OUT", "The volume, as .handwheel, .vdb, or .nrrd (distances of all voxels)"}}};
  for (OptionSpec& option : optionsOf(voxelizeOperation())) spec.options.push_back(std::move(option));
  spec.options.push_back({"fidelity", 0, "LIST", "draft, balanced or exact, and single values: volume.voxels=400,..."});
  spec.options.push_back(consentOption());
  addVolumeOptions(spec.options);
  return spec;
}

CommandSpec remeshSpec() {
  CommandSpec spec = {"remesh",
                      "VOLUME",
                      "Creates a mesh of the surface of a volume: closed, manifold, oriented and free of "
                      "self-intersections.\n"
                      "Exit code 0: done; 1: error; 2: done, but rounded to the numbers of the file it is not that,\n"
                      "or has triangles without area.",
                      {{"output", 'o', "OUT", "The mesh, in any format of meshes"}}};
  for (OptionSpec& option : optionsOf(remeshOperation())) spec.options.push_back(std::move(option));
  addVolumeOptions(spec.options);
  return spec;
}

int runVoxelize(const Arguments& arguments, const DocumentKinds& kinds) {
  Request request;
  OperationValues values(voxelizeOperation());
  std::string problem = readRequest(arguments, request, values);
  if (problem.empty() && arguments.has("fidelity")) {
    const FidelitySetting read[] = {volumeVoxelsSetting(), volumeMethodSetting()};
    problem = readFidelity(arguments, "voxelize", read, request.fidelity);
  }
  if (!problem.empty()) return failUsage(problem, "voxelize");
  MemoryNotice notice(arguments);
  std::optional<Result<Answer>> result;
  runInterruptible("Making the volume", [&](CommandJob& job) {
    result = voxelizeFile(request, values, kinds, notice.during(job), job.progress());
  });
  return deliver(result, arguments);
}

int runRemesh(const Arguments& arguments, const DocumentKinds& kinds) {
  Request request;
  OperationValues values(remeshOperation());
  const std::string problem = readRequest(arguments, request, values);
  if (!problem.empty()) return failUsage(problem, "remesh");
  std::optional<Result<Answer>> result;
  runInterruptible("Making the mesh",
                   [&](CommandJob& job) { result = remeshFile(request, values, kinds, job.progress()); });
  return deliver(result, arguments);
}

}  // namespace

std::vector<Command> volumeCommands() {
  std::vector<Command> commands{{voxelizeSpec(), runVoxelize}, {remeshSpec(), runRemesh}, booleanCommand()};
  for (Command& command : shellOffsetCommands()) commands.push_back(std::move(command));
  commands.push_back(clayCommand());
  commands.push_back(drillCommand());
  commands.push_back(drillExperimentCommand());
  commands.push_back(segmentCommand());
  return commands;
}

}  // namespace handwheel
