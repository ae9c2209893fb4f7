// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairByVolume.h"

#include "base/NumberText.h"
#include "cli/FidelityOption.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/ThinJson.h"
#include "cli/Wording.h"
#include "cli/mesh/MeshOutput.h"
#include "document/ThinNotes.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/MeshSnapshot.h"
#include "mesh/measure/Deviation.h"
#include "mesh/structure/MeshBuilder.h"
#include "text/NoteText.h"
#include "text/RepairText.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeFidelity.h"
#include "volume/repair/TriangleWalls.h"
#include "volume/repair/VolumeRepair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

constexpr double kUnsaidDistance = 0.01;  // in voxels

constexpr std::array<std::string_view, 9> kVolumeRepairOptions{"by",       "voxel",  "close-gaps", "wall", "yes",
                                                               "fidelity", "output", "partial",    "json"};

// The triangles of a mesh, with neighbours that agree, or of the surface of a volume.
Result<TriangleSoup> surfaceIn(const Input& input, const VolumeRepairRequest& request) {
  if (const MeshSnapshot* document = input.meshDocument()) return document->mesh.mesh.compact().soup;
  if (input.mesh) return buildMesh(input.mesh->soup).mesh.compact().soup;
  if (isContainerName(request.output))
    return Error{
        ErrorCode::Unsupported, {"a document as the output for one that is no mesh"}, {}, request.output.string()};
  return placedSoup(input.opened.kind->display(*input.opened.content));
}

// The input and the outcome, or the reason why nothing was written.
struct VolumeRepairRun {
  DocumentFile file;
  std::string refusal;
  RepairedByVolume repaired;
};

Result<VolumeRepairRun> repairFileByVolume(const VolumeRepairRequest& request, const DocumentKinds& kinds,
                                           MemoryNotice& notice, Progress progress) {
  const Result<Input> input = readInput(request.input, request.read, kinds, progress.part(0.0, 0.1));
  if (!input) return input.error();
  VolumeRepairRun run{input->opened.file, refusalToReplace(request.output, input->opened.file), {}};
  if (!run.refusal.empty()) return run;
  Result<RepairedByVolume> repaired = repairInputByVolume(*input, request, notice, progress.part(0.1, 0.9));
  if (!repaired) return repaired.error();
  run.repaired = std::move(*repaired);
  const Status written = writeRepairedByVolume(*input, run.repaired, request, progress.part(0.9, 1.0));
  if (!written) return written.error();
  return run;
}

std::string volumeRepairText(const RepairedByVolume& done, const VolumeRepairRequest& request) {
  return request.output.string() + ": " + stateText(done.after).toStdString() + ". Voxels of " +
         roundedText(done.voxel) + " mm; " + std::to_string(done.after.triangles) +
         " triangles; 99 % of the scan's area is within " + roundedText(done.deviation.ofScan.percentiles.back(), 3) +
         " mm of it, the farthest point at " + roundedText(std::abs(done.deviation.ofScan.farthest().distance), 3) +
         " mm." +
         (done.repair.keptDistance > kUnsaidDistance * done.voxel
              ? " Of surfaces that bound material, the farthest is at " + roundedText(done.repair.keptDistance, 3) +
                    " mm."
              : std::string()) +
         (done.repair.keptDistance > done.voxel ? " Walls thinner than a voxel were lost: choose smaller voxels.\n"
                                                : "\n") +
         (done.repair.removedCrumbs > 0
              ? "Crumbs at the rims of openings removed: " + std::to_string(done.repair.removedCrumbs) + ".\n"
              : std::string()) +
         (request.gaps > 0.0 ? "Gaps filled: " + roundedText(done.repair.filled, 3) + " mm³.\n" : std::string());
}

nlohmann::ordered_json volumeRepairJson(const RepairedByVolume& done, const MemoryNotice& notice) {
  nlohmann::ordered_json report = {{"by", "volume"},
                                   {"voxel_mm", done.voxel},
                                   {"closed_boundaries", done.repair.closedBoundaries},
                                   {"crumbs_removed", done.repair.removedCrumbs},
                                   {"near_share", done.repair.nearShare},
                                   {"triangles_sampled", done.repair.sampledTriangles},
                                   {"triangles", done.after.triangles},
                                   {"scan_distance_99_mm", done.deviation.ofScan.percentiles.back()},
                                   {"scan_distance_mm", std::abs(done.deviation.ofScan.farthest().distance)},
                                   {"filled_mm3", done.repair.filled},
                                   {"kept_distance_mm", done.repair.keptDistance},
                                   {"enclosed_mm3", done.repair.enclosed}};
  report["volume_mm3"] = done.after.volumeMm3 ? nlohmann::ordered_json(*done.after.volumeMm3) : nullptr;
  addThinParts(report, done.repair.walls, done.repair.gaps);
  report["sound"] = isSound(done);
  notice.addTo(report);
  return report;
}

}  // namespace

std::vector<OptionSpec> volumeRepairOptions() {
  return {{"by", 0, "WAY",
           "triangles (default); volume: the surface of the enclosed volume replaces all; both: the two compared, one "
           "written"},
          {"voxel", 0, "MM", "By volume: edge of a voxel; default: a 256th of the largest extent"},
          {"close-gaps", 0, "MM", "By volume: fill gaps that a ball of this radius does not get into"},
          {"wall", 0, "MM", "By volume: make walls of this thickness of triangles that enclose nothing"},
          {"yes", 0, "", "By volume: also where it needs more than a quarter of the available memory"}};
}

std::string readVolumeRequest(const Arguments& arguments, VolumeRepairRequest& request) {
  if (!arguments.has("output")) return "The option -o OUT is missing.";
  request.input = arguments.operands[0];
  request.output = arguments.valueOf("output");
  request.read.partial = arguments.has("partial");
  if (arguments.has("fidelity")) {
    const FidelitySetting read[] = {volumeVoxelsSetting(), volumeReductionSetting()};
    if (std::string problem = readFidelity(arguments, "repair", read, request.values); !problem.empty()) return problem;
  }
  for (const char* const option : {"voxel", "close-gaps", "wall"}) {
    if (!arguments.has(option)) continue;
    double length = 0.0;
    if (!readNumber(arguments.valueOf(option), length) || !(length > 0.0) || !std::isfinite(length))
      return "--" + std::string(option) + " needs a length in mm, above 0.";
    if (option == std::string_view("voxel"))
      request.voxel = length;
    else
      (option == std::string_view("wall") ? request.wall : request.gaps) = length;
  }
  return {};
}

Result<RepairedByVolume> repairInputByVolume(const Input& input, const VolumeRepairRequest& request,
                                             MemoryNotice& notice, Progress progress) {
  const Result<TriangleSoup> soup = surfaceIn(input, request);
  if (!soup) return soup.error();
  RepairedByVolume done;
  const VolumeRepairParameters parameters{request.voxel.value_or(0.0), request.gaps, request.wall};
  done.voxel = voxelFor(parameters, usualVoxel(*soup, request.values.of(volumeVoxelsSetting())));
  const TriangleSoup solid = request.wall > 0.0 ? wallsOf(*soup, request.wall) : *soup;
  const VolumeRepairOptions options{
      .voxel = done.voxel, .gaps = request.gaps, .within = request.values.of(volumeReductionSetting())};
  const Status begun = notice.begin(solid, options);
  Result<VolumeRepair> repair = begun ? repairByVolume(solid, options, progress.part(0.0, 0.75)) : begun.error();
  if (!repair) {
    Error error = repair.error();
    error.subject = request.input.string();
    return error;
  }
  done.repair = std::move(*repair);
  Result<Deviation> measured = deviation(done.repair.mesh, buildMesh(*soup).mesh, {}, progress.part(0.75, 0.9));
  if (!measured) return measured.error();
  done.deviation = std::move(*measured);
  done.after = reportOn(done.repair.mesh.compact().soup, SelfIntersections::Count, progress.part(0.9, 1.0));
  return done;
}

Status writeRepairedByVolume(const Input& input, const RepairedByVolume& repaired, const VolumeRepairRequest& request,
                             Progress progress) {
  if (input.mesh) return writeMesh(input, repaired.repair.mesh, request.output, progress);
  const Result<ExportReport> written = exportMesh(repaired.repair.mesh, NumberType::Float64, request.output, progress);
  return written ? Status(Done{}) : Status(written.error());
}

bool isSound(const RepairedByVolume& repaired) {
  return repaired.after.isSound() && !repaired.repair.walls.isChanged();
}

int runRepairByVolume(const Arguments& arguments, const DocumentKinds& kinds) {
  for (const auto& [name, value] : arguments.options) {
    if (std::find(kVolumeRepairOptions.begin(), kVolumeRepairOptions.end(), name) == kVolumeRepairOptions.end())
      return failUsage("--" + name + " has no meaning for a repair by volume.", "repair");
  }
  VolumeRepairRequest request;
  if (const std::string problem = readVolumeRequest(arguments, request); !problem.empty())
    return failUsage(problem, "repair");
  if (!isContainerName(request.output)) {
    if (const auto format = formatForOutput(request.output); !format) return fail(format.error());
  }
  MemoryNotice notice(arguments);
  std::optional<Result<VolumeRepairRun>> result;
  runInterruptible("Repairing", [&](CommandJob& job) {
    result = repairFileByVolume(request, kinds, notice.during(job), job.progress());
  });
  if (!*result) return fail(result->error());
  const VolumeRepairRun& run = result->value();
  reportLosses(run.file);
  if (!run.refusal.empty()) return refuse(run.refusal);
  const RepairedByVolume& done = run.repaired;
  for (const Note& note : notesOnThinParts(done.repair.walls, done.repair.gaps)) complain(noteText(note).toStdString());
  const int code =
      print(arguments.has("json") ? volumeRepairJson(done, notice).dump() + "\n" : volumeRepairText(done, request));
  if (code != kExitDone) return code;
  return isSound(done) ? kExitDone : kExitSomethingLeft;
}

}  // namespace handwheel
