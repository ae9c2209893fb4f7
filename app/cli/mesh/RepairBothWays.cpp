// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairBothWays.h"

#include "base/NumberText.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/ReportText.h"
#include "cli/mesh/RepairArguments.h"
#include "cli/mesh/RepairByVolume.h"
#include "cli/mesh/RepairCommand.h"
#include "document/AtomicFile.h"
#include "text/RepairText.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

// What stands in the table for one way.
struct RepairWay {
  MeshReport after;
  double near99 = 0.0, farthest = 0.0;  // mm; of the scan from the result: of 99 % of its area, and of its points
  double seconds = 0.0;
};

RepairWay wayOf(const MeshReport& after, const Deviation& deviation, double seconds) {
  return {after, deviation.ofScan.percentiles.back(), std::abs(deviation.ofScan.farthest().distance), seconds};
}

struct BothWays {
  RepairRun run;  // by triangles; without output where there is a reason to write nothing
  RepairWay triangles;
  std::optional<RepairWay> volume;
  std::optional<Error> volumeError;  // why there is none
  double lost = 0.0;        // mm, by which the result by volume is farther than a voxel from what it should have kept
  bool isByVolume = false;  // what was written
};

Result<BothWays> repairFileBothWays(const RepairRequest& byTriangles, const VolumeRepairRequest& byVolume,
                                    const DocumentKinds& kinds, MemoryNotice& notice, Progress progress) {
  Result<RepairRun> run = repairFile(byTriangles, kinds, progress.part(0.0, 0.4));
  if (!run) return run.error();
  BothWays both;
  both.run = std::move(*run);
  if (both.run.output.empty()) return both;
  both.triangles = wayOf(both.run.after, *both.run.deviation, both.run.seconds);

  const Result<Input> input = readMeshInput(byVolume.input, byVolume.read, kinds, progress.part(0.4, 0.45));
  if (!input) return input.error();
  const auto start = std::chrono::steady_clock::now();
  const Result<RepairedByVolume> repaired = repairInputByVolume(*input, byVolume, notice, progress.part(0.45, 0.9));
  if (!repaired && repaired.error().code == ErrorCode::Cancelled) return repaired.error();
  if (repaired) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    both.volume = wayOf(repaired->after, repaired->deviation, seconds);
    // Walls within a volume are meant to go. What is outside of it now was a sheet, or thinner than a voxel.
    const double farthest = std::max(repaired->deviation.ofScan.highest.distance, repaired->repair.keptDistance);
    if (farthest > repaired->voxel) both.lost = farthest;
  } else {
    both.volumeError = repaired.error();
  }
  both.isByVolume = both.volume && both.volume->after.isSound() && !both.triangles.after.isSound() && both.lost == 0.0;
  const Status written = both.isByVolume
                             ? writeRepairedByVolume(*input, *repaired, byVolume, progress.part(0.9, 1.0))
                             : writeFilesAtomically(std::vector<FileContent>{{byTriangles.output, both.run.output}},
                                                    progress.part(0.9, 1.0));
  if (!written) return written.error();
  return both;
}

std::string rowOf(std::string_view name, const RepairWay& way) {
  return rightAligned(std::string(name), 9) + rightAligned(std::to_string(way.after.triangles), 12) +
         rightAligned(roundedText(way.near99, 3), 16) + rightAligned(roundedText(way.farthest, 3), 14) +
         rightAligned(roundedText(way.seconds, 2), 11) + "  " + stateText(way.after).toStdString() + "\n";
}

std::string tableOf(const BothWays& both, const RepairRequest& request) {
  std::string text = "      way   triangles    99 % within mm   farthest mm    seconds  state\n";
  text += rowOf("triangles", both.triangles);
  text += both.volume ? rowOf("volume", *both.volume) : "   volume  " + sentenceFor(*both.volumeError) + "\n";
  text += "Distances are those of the input from the result.\n" + request.output.string() + ": ";
  if (both.isByVolume) return text + "the repair by volume, because the other leaves defects.\n";
  if (both.triangles.after.isSound())
    return text + "the repair by triangles, which leaves everything else as it was.\n";
  if (both.lost == 0.0) return text + "the repair by triangles; neither is free of defects.\n";
  return text +
         "the repair by triangles. That by volume has lost open sheets or walls thinner than its voxels: up to " +
         roundedText(both.lost, 3) + " mm of the input is away from it.\n";
}

nlohmann::ordered_json jsonOf(std::string_view name, const RepairWay& way) {
  return {{"by", name},
          {"sound", way.after.isSound()},
          {"state", stateText(way.after).toStdString()},
          {"triangles", way.after.triangles},
          {"scan_distance_99_mm", way.near99},
          {"scan_distance_mm", way.farthest},
          {"seconds", way.seconds}};
}

nlohmann::ordered_json jsonOf(const BothWays& both) {
  nlohmann::ordered_json ways = {jsonOf("triangles", both.triangles)};
  if (both.volume)
    ways.push_back(jsonOf("volume", *both.volume));
  else
    ways.push_back({{"by", "volume"}, {"error", sentenceFor(*both.volumeError)}});
  return {{"written", both.isByVolume ? "volume" : "triangles"}, {"lost_by_volume_mm", both.lost}, {"ways", ways}};
}

}  // namespace

int runRepairBothWays(const Arguments& arguments, const DocumentKinds& kinds) {
  for (const char* const option : {"report", "screenshot", "jobs", "format", "resume", "time-limit"}) {
    if (arguments.has(option))
      return failUsage("--" + std::string(option) + " has no meaning where both ways of repair are compared.",
                       "repair");
  }
  if (arguments.operands.size() != 1) return failUsage("Both ways of repair are compared for one file.", "repair");
  RepairRequest byTriangles;
  VolumeRepairRequest byVolume;
  std::string problem = readRequest(arguments, kinds, byTriangles);
  if (problem.empty()) problem = readVolumeRequest(arguments, byVolume);
  if (!problem.empty()) return failUsage(problem, "repair");
  byTriangles.compare = true;

  MemoryNotice notice(arguments);
  std::optional<Result<BothWays>> result;
  runInterruptible("Repairing", [&](CommandJob& job) {
    result = repairFileBothWays(byTriangles, byVolume, kinds, notice.during(job), job.progress());
  });
  if (!*result) return fail(result->error());
  const BothWays& both = result->value();
  if (both.run.output.empty()) return reportNothingWritten(both.run, byTriangles);
  reportLosses(both.run.file);
  nlohmann::ordered_json report = jsonOf(both);
  notice.addTo(report);
  const int code = print(arguments.has("json") ? report.dump() + "\n" : tableOf(both, byTriangles));
  if (code != kExitDone) return code;
  return (both.isByVolume ? *both.volume : both.triangles).after.isSound() ? kExitDone : kExitSomethingLeft;
}

}  // namespace handwheel
