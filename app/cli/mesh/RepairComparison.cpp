// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairComparison.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/MemoryNotice.h"
#include "cli/Messages.h"
#include "cli/ProgressBar.h"
#include "cli/ReportText.h"
#include "cli/mesh/RepairArguments.h"
#include "cli/mesh/RepairByVolume.h"
#include "cli/mesh/RepairCommand.h"
#include "cli/mesh/RepairMethodTable.h"
#include "cli/mesh/batch/BatchFiles.h"
#include "cli/mesh/batch/ChildRepair.h"
#include "document/AtomicFile.h"
#include "text/RepairText.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>

namespace handwheel {
namespace {

MethodFigures figuresOf(const MeshReport& after, const Deviation& deviation, double seconds) {
  return {after.isSound(),
          stateText(after).toStdString(),
          after.triangles,
          deviation.ofScan.percentiles.back(),
          std::abs(deviation.ofScan.farthest().distance),
          seconds};
}

struct RepairComparison {
  RepairRun run;  // by triangles; without output where there is a reason to write nothing
  MethodFigures triangles;
  std::optional<MethodFigures> volume;
  std::optional<Error> volumeError;  // the reason if there is none
  double lost = 0.0;          // mm, by which the result by volume is farther than a voxel from what it should have kept
  bool hasLostWalls = false;  // parts of walls thinner than two voxels are lost
  bool isByVolume = false;    // the written result is by volume
};

Result<RepairComparison> repairByBoth(const RepairRequest& byTriangles, const VolumeRepairRequest& byVolume,
                                      const DocumentKinds& kinds, MemoryNotice& notice, Progress progress) {
  Result<RepairRun> run = repairFile(byTriangles, kinds, progress.part(0.0, 0.4));
  if (!run) return run.error();
  RepairComparison both;
  both.run = std::move(*run);
  if (both.run.output.empty()) return both;
  both.triangles = figuresOf(both.run.after, *both.run.deviation, both.run.seconds);

  const Result<Input> input = readMeshInput(byVolume.input, byVolume.read, kinds, progress.part(0.4, 0.45));
  if (!input) return input.error();
  const auto start = std::chrono::steady_clock::now();
  const Result<RepairedByVolume> repaired = repairInputByVolume(*input, byVolume, notice, progress.part(0.45, 0.9));
  if (!repaired && repaired.error().code == ErrorCode::Cancelled) return repaired.error();
  if (repaired) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    both.volume = figuresOf(repaired->after, repaired->deviation, seconds);
    both.volume->isSound = isSound(*repaired);
    both.hasLostWalls = repaired->repair.walls.isChanged();
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

std::string rowOf(std::string_view name, const MethodFigures& method) {
  return rightAligned(std::string(name), 9) + rightAligned(std::to_string(method.triangles), 12) +
         rightAligned(roundedText(method.near99, 3), 16) + rightAligned(roundedText(method.farthest, 3), 14) +
         rightAligned(roundedText(method.seconds, 2), 11) + "  " + method.state + "\n";
}

std::string tableOf(const RepairComparison& both, const RepairRequest& request) {
  std::string text = "      way   triangles    99 % within mm   farthest mm    seconds  state\n";
  text += rowOf("triangles", both.triangles);
  text += both.volume ? rowOf("volume", *both.volume) : "   volume  " + sentenceFor(*both.volumeError) + "\n";
  text += "Distances are those of the input from the result.\n" + request.output.string() + ": ";
  if (both.isByVolume) return text + "the repair by volume, because the other leaves defects.\n";
  if (both.triangles.isSound) return text + "the repair by triangles, which leaves everything else as it was.\n";
  if (both.lost == 0.0 && both.hasLostWalls)
    return text + "the repair by triangles. That by volume has lost parts of walls thinner than two voxels.\n";
  if (both.lost == 0.0) return text + "the repair by triangles; neither is free of defects.\n";
  return text +
         "the repair by triangles. That by volume has lost open sheets or walls thinner than its voxels: up to " +
         roundedText(both.lost, 3) + " mm of the input is away from it.\n";
}

nlohmann::ordered_json jsonOf(std::string_view name, const MethodFigures& method) {
  return {{"by", name},
          {"sound", method.isSound},
          {"state", method.state},
          {"triangles", method.triangles},
          {"scan_distance_99_mm", method.near99},
          {"scan_distance_mm", method.farthest},
          {"seconds", method.seconds}};
}

nlohmann::ordered_json jsonOf(const RepairComparison& both) {
  nlohmann::ordered_json methods = {jsonOf("triangles", both.triangles)};
  if (both.volume)
    methods.push_back(jsonOf("volume", *both.volume));
  else
    methods.push_back({{"by", "volume"}, {"error", sentenceFor(*both.volumeError)}});
  return {{"written", both.isByVolume ? "volume" : "triangles"}, {"lost_by_volume_mm", both.lost}, {"ways", methods}};
}

// The rows of a file, by the JSON of its own repair. Throws what the library throws where that is something else.
std::vector<MethodRow> rowsIn(const std::string& file, const nlohmann::json& both) {
  std::vector<MethodRow> rows;
  const double lost = both.at("lost_by_volume_mm").get<double>();
  for (const nlohmann::json& method : both.at("ways")) {
    MethodRow row{file, method.at("by").get<std::string>(), {}, {}, false};
    row.isWritten = row.method == both.at("written").get<std::string>();
    if (method.contains("error")) {
      row.reason = method.at("error").get<std::string>();
    } else {
      row.figures = MethodFigures{method.at("sound").get<bool>(),
                                  method.at("state").get<std::string>(),
                                  method.at("triangles").get<std::size_t>(),
                                  method.at("scan_distance_99_mm").get<double>(),
                                  method.at("scan_distance_mm").get<double>(),
                                  method.at("seconds").get<double>()};
    }
    if (row.method == "volume" && lost > 0.0)
      row.reason = "Open sheets or walls thinner than a voxel are lost: up to " + roundedText(lost, 3) +
                   " mm of the input is away from it.";
    rows.push_back(std::move(row));
  }
  return rows;
}

// Repairs several files one after the other, each in a process of its own: one that crashes, or takes longer than it
// may, is a row of the table, and the others go on.
class FileComparisons {
 public:
  FileComparisons(std::vector<std::string> options, std::optional<double> timeLimit)
      : m_options(std::move(options)), m_timeLimit(timeLimit) {}

  // Until a signal arrives.
  void repair(const std::vector<BatchFile>& files) {
    for (std::size_t i = 0; i < files.size() && !wasInterrupted(); ++i) {
      m_done = static_cast<double>(i) / static_cast<double>(files.size());
      repair(files[i]);
    }
    m_bar.clear();
  }
  const std::vector<MethodRow>& rows() const { return m_rows; }

 private:
  using Clock = std::chrono::steady_clock;

  void repair(const BatchFile& file) {
    const StartedRepair started = startRepair(file, m_options);
    if (!started.child) return fail(file, started.problem);
    const bool isStopped = waitFor(started.child);
    ChildProcess& child = *started.child;
    if (child.code() == kExitDone || child.code() == kExitSomethingLeft) {
      try {
        const std::vector<MethodRow> rows = rowsIn(file.input.string(), nlohmann::json::parse(child.output()));
        m_rows.insert(m_rows.end(), rows.begin(), rows.end());
        m_bar.clear();
        for (const std::string& sentence : complaintsOf(child)) complain(sentence);
        return;
      } catch (const nlohmann::json::exception&) {
        return fail(file, "Its process printed no result.");
      }
    }
    if (!wasInterrupted()) fail(file, isStopped ? tooLong(*m_timeLimit) : failureOf(child, file));
  }

  // Returns true if the child was asked to end.
  bool waitFor(const std::unique_ptr<ChildProcess>& child) {
    constexpr std::chrono::milliseconds kWaiting{5};
    const Clock::time_point start = Clock::now();
    std::optional<Clock::time_point> askedToEnd;
    while (!child->hasEnded()) {
      const auto now = Clock::now();
      const bool isLate = m_timeLimit && std::chrono::duration<double>(now - start).count() >= *m_timeLimit;
      if (!askedToEnd && (isLate || wasInterrupted())) {
        child->send(SIGTERM);
        askedToEnd = now;
      }
      if (askedToEnd && now - *askedToEnd > kChildGrace) child->send(SIGKILL);
      m_bar.show(m_done, static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(now - m_begin).count()));
      ChildProcess::wait(std::span(&child, 1), kWaiting);
    }
    return askedToEnd.has_value();
  }

  void fail(const BatchFile& file, std::string reason) {
    m_rows.push_back({file.input.string(), {}, {}, std::move(reason), false});
  }

  std::vector<std::string> m_options;
  std::optional<double> m_timeLimit;  // seconds
  std::vector<MethodRow> m_rows;
  ProgressBar m_bar{"Repairing"};
  Clock::time_point m_begin = Clock::now();
  double m_done = 0.0;
};

nlohmann::ordered_json jsonOf(const std::vector<MethodRow>& rows) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const MethodRow& row : rows) {
    nlohmann::ordered_json one = {{"file", row.file}};
    if (row.figures) one.update(jsonOf(row.method, *row.figures));
    if (!row.figures && !row.method.empty()) one["by"] = row.method;
    one["written"] = row.isWritten;
    if (!row.reason.empty()) one["reason"] = row.reason;
    all.push_back(std::move(one));
  }
  return {{"repairs", all}};
}

// The exit code of the table: 1 where a file has no result, 2 where one that was written has defects.
int codeOf(const std::vector<MethodRow>& rows) {
  int code = kExitDone;
  for (const MethodRow& row : rows) {
    if (row.method.empty()) return kExitError;
    if (row.isWritten && !row.figures->isSound) code = kExitSomethingLeft;
  }
  return code;
}

// Returns the rows without the names of files that may be those of patients. Reports go on to others.
std::vector<MethodRow> withoutPrivateNames(std::vector<MethodRow> rows, const DocumentKinds& kinds) {
  std::vector<std::string> names;  // in the order of the files
  for (MethodRow& row : rows) {
    const std::filesystem::path path = row.file;
    const Result<const DocumentKind*> kind = kinds.kindOf(path);
    if (!kind || !*kind || !(*kind)->hasPrivateName(path)) continue;
    if (names.empty() || names.back() != row.file) names.push_back(row.file);
    const std::string shown = "image " + std::to_string(names.size());
    // A reason may begin with the name of the input or of the output.
    if (row.reason.find(path.stem().string()) != std::string::npos) {
      const std::size_t colon = row.reason.find(": ");
      row.reason.erase(0, colon == std::string::npos ? row.reason.size() : colon + 2);
    }
    row.file = shown;
  }
  return rows;
}

int runManyComparisons(const Arguments& arguments, const DocumentKinds& kinds) {
  namespace fs = std::filesystem;
  const fs::path output = arguments.valueOf("output"), report = arguments.valueOf("report");
  const std::string ending = report.extension().string();
  if (arguments.has("report") && ending != ".csv" && ending != ".html")
    return failUsage("--report takes a name that ends in .csv or .html where both ways of repair are compared.",
                     "repair");
  std::optional<double> timeLimit;
  std::string wrong = readTimeLimit(arguments, timeLimit);
  if (wrong.empty()) wrong = checkFormat(arguments);
  if (!wrong.empty()) return failUsage(wrong, "repair");
  std::error_code problem;
  if (!fs::is_directory(output, problem) && (fs::exists(output, problem) || isDocumentName(output, kinds)))
    return failUsage(output.string() + " is not a folder; several files need one.", "repair");
  const BatchPlan plan = planBatch(arguments.operands, output, arguments.valueOf("format"), kinds);
  if (wasInterrupted()) return fail({ErrorCode::Cancelled, {}, {}, {}});
  if (!plan.problem.empty()) return refuse(plan.problem);
  if (plan.files.empty()) return refuse("No mesh file was found.");
  if (arguments.has("report") && plan.isInput(report)) return refuse(report.string() + " is an input too.");

  FileComparisons repairs(repairOptions(arguments), timeLimit);
  repairs.repair(plan.files);
  const std::vector<MethodRow>& rows = repairs.rows();
  // The repairs until then are reported, too.
  if (arguments.has("report")) {
    const std::vector<MethodRow> shared = withoutPrivateNames(rows, kinds);
    if (const Status written = writeFileAtomically(report, ending == ".csv" ? csvText(shared) : htmlText(shared));
        !written)
      return fail(written.error());
  }
  const int code = print(arguments.has("json") ? jsonOf(rows).dump() + "\n" : alignedText(rows));
  if (wasInterrupted()) return fail({ErrorCode::Cancelled, {}, {}, {}});
  return code == kExitDone ? codeOf(rows) : code;
}

}  // namespace

int runRepairComparison(const Arguments& arguments, const DocumentKinds& kinds) {
  std::error_code ignored;
  const bool isMany = arguments.operands.size() > 1 || arguments.has("format") ||
                      std::filesystem::is_directory(arguments.operands[0], ignored);
  for (const char* const option : {"screenshot", "jobs", "resume", "time-limit"}) {
    if (arguments.has(option) && !(isMany && std::string_view(option) == "time-limit"))
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
  if (isMany) return runManyComparisons(arguments, kinds);

  MemoryNotice notice(arguments);
  std::optional<Result<RepairComparison>> result;
  runInterruptible("Repairing", [&](CommandJob& job) {
    result = repairByBoth(byTriangles, byVolume, kinds, notice.during(job), job.progress());
  });
  if (!*result) return fail(result->error());
  const RepairComparison& both = result->value();
  if (both.run.output.empty()) return reportNothingWritten(both.run, byTriangles);
  reportLosses(both.run.file);
  nlohmann::ordered_json report = jsonOf(both);
  notice.addTo(report);
  const int code = print(arguments.has("json") ? report.dump() + "\n" : tableOf(both, byTriangles));
  if (code != kExitDone) return code;
  return (both.isByVolume ? *both.volume : both.triangles).isSound ? kExitDone : kExitSomethingLeft;
}

}  // namespace handwheel
