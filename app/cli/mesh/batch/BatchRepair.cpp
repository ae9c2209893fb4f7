// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/batch/BatchRepair.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/mesh/RepairArguments.h"
#include "cli/mesh/batch/BatchRun.h"
#include "cli/mesh/batch/ChildRepair.h"
#include "document/AtomicSaveFile.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 4> kOfMany{"jobs", "format", "resume", "time-limit"};
constexpr std::array<std::string_view, 2> kOfOne{"keep-open", "screenshot"};
constexpr std::size_t kMostJobs = 64;

std::string readRunOptions(const Arguments& arguments, BatchRequest& request) {
  if (arguments.has("jobs") &&
      (!readNumber(arguments.valueOf("jobs"), request.jobs) || request.jobs < 1 || request.jobs > kMostJobs)) {
    return "--jobs takes a number from 1 to " + std::to_string(kMostJobs) + ".";
  }
  const std::string problem = checkFormat(arguments);
  return problem.empty() ? readTimeLimit(arguments, request.timeLimit) : problem;
}

// Turns the words into a request, but for the plan and the earlier run. Returns what is wrong with them, or nothing.
std::string readBatchRequest(const Arguments& arguments, const DocumentKinds& kinds, BatchRequest& request) {
  for (std::string_view name : kOfOne) {
    if (arguments.has(name)) return "--" + std::string(name) + " can be used with one file only.";
  }
  if (!arguments.has("output")) return "The option -o OUT is missing.";
  const fs::path output = arguments.valueOf("output");
  std::error_code ignored;
  if (!fs::is_directory(output, ignored) && (fs::exists(output, ignored) || isDocumentName(output, kinds))) {
    return output.string() + " is not a folder; several files need one.";
  }
  RepairRequest repair;  // read here only to say what is wrong once, and at once
  const std::string problem = readRepairOptions(arguments, repair);
  if (!problem.empty()) return problem;
  request.repairOptions = repairOptions(arguments);
  request.unit = unitOf(arguments);
  request.asJson = arguments.has("json");
  request.report = arguments.has("report") ? fs::path(arguments.valueOf("report")) : output / "repair-report.json";
  if (isDocumentName(request.report, kinds)) {
    return "--report takes a name such as parts.json, not that of a document.";
  }
  return readRunOptions(arguments, request);
}

// The sentence without its full stop, for another that goes on.
std::string beginningOf(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

}  // namespace

bool isBatch(const Arguments& arguments) {
  std::error_code ignored;
  return arguments.operands.size() > 1 || fs::is_directory(arguments.operands[0], ignored) ||
         std::any_of(kOfMany.begin(), kOfMany.end(), [&](std::string_view name) { return arguments.has(name); });
}

int runBatchRepair(const Arguments& arguments, const DocumentKinds& kinds) {
  BatchRequest request;
  const std::string problem = readBatchRequest(arguments, kinds, request);
  if (!problem.empty()) return failUsage(problem, "repair");

  const fs::path output = arguments.valueOf("output");
  request.plan = planBatch(arguments.operands, output, arguments.valueOf("format"), kinds);
  if (wasInterrupted()) return fail({ErrorCode::Cancelled, {}, {}, {}});
  if (!request.plan.problem.empty()) return refuse(request.plan.problem);
  if (request.plan.files.empty()) return refuse("No mesh file was found.");
  if (request.plan.isInput(request.report)) return refuse(request.report.string() + " is an input too.");
  std::error_code error;
  if (arguments.has("report") && !fs::is_directory(folderOf(request.report), error)) {
    return refuse("There is no folder " + folderOf(request.report).string() + " for the report.");
  }
  if (arguments.has("resume")) {
    Result<std::optional<BatchReport>> earlier = readBatchReport(request.report);
    if (!earlier) {
      return refuse(request.report.string() +
                    " is not a report to resume from: " + beginningOf(sentenceFor(earlier.error())) + ".");
    }
    request.earlier = std::move(*earlier);
  }
  fs::create_directories(output, error);
  if (error) return fail({ErrorCode::WriteFailed, {error.message()}, {}, output.string()});
  return BatchRun(std::move(request)).run();
}

}  // namespace handwheel
