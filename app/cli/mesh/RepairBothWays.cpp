// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairBothWays.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/ReportText.h"
#include "cli/mesh/RepairArguments.h"
#include "cli/mesh/RepairByVolume.h"
#include "cli/mesh/RepairCommand.h"
#include "cli/mesh/RepairWaysTable.h"
#include "cli/mesh/batch/BatchFiles.h"
#include "document/AtomicFile.h"
#include "text/RepairText.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

RepairWayFigures wayOf(const MeshReport& after, const Deviation& deviation, double seconds) {
  return {after.isSound(),
          stateText(after).toStdString(),
          after.triangles,
          deviation.ofScan.percentiles.back(),
          std::abs(deviation.ofScan.farthest().distance),
          seconds};
}

struct BothWays {
  RepairRun run;  // by triangles; without output where there is a reason to write nothing
  RepairWayFigures triangles;
  std::optional<RepairWayFigures> volume;
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
  both.isByVolume = both.volume && both.volume->isSound && !both.triangles.isSound && both.lost == 0.0;
  const Status written = both.isByVolume
                             ? writeRepairedByVolume(*input, *repaired, byVolume, progress.part(0.9, 1.0))
                             : writeFilesAtomically(std::vector<FileContent>{{byTriangles.output, both.run.output}},
                                                    progress.part(0.9, 1.0));
  if (!written) return written.error();
  return both;
}

std::string rowOf(std::string_view name, const RepairWayFigures& way) {
  return rightAligned(std::string(name), 9) + rightAligned(std::to_string(way.triangles), 12) +
         rightAligned(roundedText(way.near99, 3), 16) + rightAligned(roundedText(way.farthest, 3), 14) +
         rightAligned(roundedText(way.seconds, 2), 11) + "  " + way.state + "\n";
}

std::string tableOf(const BothWays& both, const RepairRequest& request) {
  std::string text = "      way   triangles    99 % within mm   farthest mm    seconds  state\n";
  text += rowOf("triangles", both.triangles);
  text += both.volume ? rowOf("volume", *both.volume) : "   volume  " + sentenceFor(*both.volumeError) + "\n";
  text += "Distances are those of the input from the result.\n" + request.output.string() + ": ";
  if (both.isByVolume) return text + "the repair by volume, because the other leaves defects.\n";
  if (both.triangles.isSound) return text + "the repair by triangles, which leaves everything else as it was.\n";
  if (both.lost == 0.0) return text + "the repair by triangles; neither is free of defects.\n";
  return text +
         "the repair by triangles. That by volume has lost open sheets or walls thinner than its voxels: up to " +
         roundedText(both.lost, 3) + " mm of the input is away from it.\n";
}

nlohmann::ordered_json jsonOf(std::string_view name, const RepairWayFigures& way) {
  return {{"by", name},
          {"sound", way.isSound},
          {"state", way.state},
          {"triangles", way.triangles},
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

// What the words say of each file.
struct BothWaysRequest {
  RepairRequest byTriangles;
  VolumeRepairRequest byVolume;
};

void addRows(const std::string& file, const BothWays& both, std::vector<RepairWayRow>& rows) {
  rows.push_back({file, "triangles", both.triangles, {}, !both.isByVolume});
  RepairWayRow volume{file, "volume", both.volume, {}, both.isByVolume};
  if (both.volumeError) volume.reason = sentenceFor(*both.volumeError);
  if (both.lost > 0.0)
    volume.reason = "Open sheets or walls thinner than a voxel are lost: up to " + roundedText(both.lost, 3) +
                    " mm of the input is away from it.";
  rows.push_back(std::move(volume));
}

// Repairs one file of several. What fails is a row of the table. False: cancelled.
bool addFile(const BatchFile& file, BothWaysRequest request, const DocumentKinds& kinds, MemoryNotice& notice,
             std::vector<RepairWayRow>& rows, Progress progress) {
  const std::string name = file.input.string();
  const auto failed = [&](std::string reason) { rows.push_back({name, {}, {}, std::move(reason), false}); };
  if (!file.problem.empty()) {
    failed(file.problem);
    return true;
  }
  request.byTriangles.input = request.byVolume.input = file.input;
  request.byTriangles.output = request.byVolume.output = file.output;
  std::error_code problem;
  std::filesystem::create_directories(file.output.parent_path(), problem);
  if (problem) {
    failed(sentenceFor(Error{ErrorCode::WriteFailed, {problem.message()}, {}, file.output.string()}));
    return true;
  }
  const Result<BothWays> both = repairFileBothWays(request.byTriangles, request.byVolume, kinds, notice, progress);
  if (!both && both.error().code == ErrorCode::Cancelled) return false;
  if (!both) {
    failed(sentenceFor(both.error()));
  } else if (both->run.output.empty()) {
    failed(both->run.refusal.empty() ? name + ": no triangle has an area, so there is nothing to repair."
                                     : both->run.refusal);
  } else {
    addRows(name, *both, rows);
  }
  return true;
}

nlohmann::ordered_json jsonOf(const std::vector<RepairWayRow>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const RepairWayRow& row : rows) {
    nlohmann::ordered_json one = {{"file", row.file}};
    if (row.figures) one.update(jsonOf(row.way, *row.figures));
    if (!row.figures && !row.way.empty()) one["by"] = row.way;
    one["written"] = row.isWritten;
    if (!row.reason.empty()) one["reason"] = row.reason;
    all.push_back(std::move(one));
  }
  return {{"repairs", all}};
}

// The exit code of the table: 1 where a file has no result, 2 where one that was written has defects.
int codeOf(const std::vector<RepairWayRow>& rows) {
  int code = kExitDone;
  for (const RepairWayRow& row : rows) {
    if (row.way.empty()) return kExitError;
    if (row.isWritten && !row.figures->isSound) code = kExitSomethingLeft;
  }
  return code;
}

int runManyBothWays(const Arguments& arguments, const BothWaysRequest& request, const DocumentKinds& kinds) {
  namespace fs = std::filesystem;
  const fs::path output = arguments.valueOf("output"), report = arguments.valueOf("report");
  const std::string ending = report.extension().string();
  if (arguments.has("report") && ending != ".csv" && ending != ".html")
    return failUsage("--report takes a name that ends in .csv or .html where both ways of repair are compared.",
                     "repair");
  std::error_code problem;
  if (!fs::is_directory(output, problem) && (fs::exists(output, problem) || isDocumentName(output, kinds)))
    return failUsage(output.string() + " is not a folder; several files need one.", "repair");
  const BatchPlan plan = planBatch(arguments.operands, output, arguments.valueOf("format"), kinds);
  if (wasInterrupted()) return fail({ErrorCode::Cancelled, {}, {}, {}});
  if (!plan.problem.empty()) return refuse(plan.problem);
  if (plan.files.empty()) return refuse("No mesh file was found.");
  if (arguments.has("report") && plan.isInput(report)) return refuse(report.string() + " is an input too.");

  MemoryNotice notice(arguments);
  std::vector<RepairWayRow> rows;
  bool isCancelled = false;
  runInterruptible("Repairing", [&](CommandJob& job) {
    const auto count = static_cast<double>(plan.files.size());
    for (std::size_t i = 0; i < plan.files.size() && !isCancelled; ++i) {
      const auto at = static_cast<double>(i);
      isCancelled = !addFile(plan.files[i], request, kinds, notice.during(job), rows,
                             job.progress().part(at / count, (at + 1.0) / count));
    }
  });
  // What was repaired until then is told, too.
  if (arguments.has("report"))
    if (const Status written = writeFileAtomically(report, ending == ".csv" ? csvText(rows) : htmlText(rows)); !written)
      return fail(written.error());
  nlohmann::ordered_json json = jsonOf(rows);
  notice.addTo(json);
  const int code = print(arguments.has("json") ? json.dump() + "\n" : alignedText(rows));
  if (isCancelled) return fail({ErrorCode::Cancelled, {}, {}, {}});
  return code == kExitDone ? codeOf(rows) : code;
}

}  // namespace

int runRepairBothWays(const Arguments& arguments, const DocumentKinds& kinds) {
  std::error_code ignored;
  const bool isMany = arguments.operands.size() > 1 || arguments.has("format") ||
                      std::filesystem::is_directory(arguments.operands[0], ignored);
  for (const char* const option : {"screenshot", "jobs", "resume", "time-limit"}) {
    if (arguments.has(option))
      return failUsage("--" + std::string(option) + " has no meaning where both ways of repair are compared.",
                       "repair");
  }
  if (isMany && arguments.has("keep-open")) return failUsage("--keep-open can be used with one file only.", "repair");
  if (!isMany && arguments.has("report"))
    return failUsage("--report has no meaning where both ways of repair are compared for one file.", "repair");
  RepairRequest byTriangles;
  VolumeRepairRequest byVolume;
  if (isMany && !arguments.has("output")) return failUsage("The option -o OUT is missing.", "repair");
  std::string problem = isMany ? readRepairOptions(arguments, byTriangles) : readRequest(arguments, kinds, byTriangles);
  if (problem.empty()) problem = readVolumeRequest(arguments, byVolume);
  if (!problem.empty()) return failUsage(problem, "repair");
  byTriangles.compare = true;
  if (isMany) return runManyBothWays(arguments, {byTriangles, byVolume}, kinds);

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
  return (both.isByVolume ? *both.volume : both.triangles).isSound ? kExitDone : kExitSomethingLeft;
}

}  // namespace handwheel
