// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/Picture.h"
#include "cli/ReportJson.h"
#include "cli/Wording.h"
#include "cli/mesh/MeshOutput.h"
#include "cli/mesh/RepairArguments.h"
#include "cli/mesh/RepairByVolume.h"
#include "cli/mesh/RepairComparison.h"
#include "cli/mesh/RepairJson.h"
#include "cli/mesh/batch/BatchRepair.h"
#include "document/AtomicFile.h"
#include "text/RepairText.h"
#include "tools/mesh/operations/RepairOperation.h"

namespace handwheel {

namespace {

// Fraction of the diagonal. A part near the origin loses less.
constexpr double kReportedRounding = 1e-6;

std::string summary(const RepairRun& run, const RepairRequest& request) {
  return outcomesText(countOutcomes(run.repair)) + ". " + request.output.string() + ": " +
         stateText(run.after).toStdString() + ".\n" + changesLine(run.repair);
}

// The messages of a repair, complete before anything is written: then even a lack of memory leaves nothing half done.
struct Delivery {
  std::vector<std::string> complaints;
  std::string report;  // the bytes of the file
  std::string text;    // for stdout
};

Delivery deliveryOf(const RepairRun& run, const RepairRequest& request, const Arguments& arguments) {
  Delivery delivery{lossSentences(run.file), {}, {}};
  if (run.roundingMove > kReportedRounding * run.after.box.diagonal().norm()) {
    delivery.complaints.push_back("The single precision of the format moved vertices by up to " +
                                  roundedText(run.roundingMove) +
                                  " mm. Move the part near the origin, or write .ply, .obj or .off.");
  }
  if (arguments.has("report")) delivery.report = textOf(toJson(run, request, unitOf(arguments)));
  const bool asJson = arguments.has("json");
  if (!asJson) {
    for (std::string& sentence : leftovers(run.repair, request.options, run.before, run.after))
      delivery.complaints.push_back(std::move(sentence));
    for (std::string& sentence : repairWarnings(run.repair)) delivery.complaints.push_back(std::move(sentence));
  }
  delivery.text = asJson ? outcomeLine(run, request) : summary(run, request);
  return delivery;
}

// The report first: whenever there is an error the output is the old one.
Status writeFiles(const RepairRun& run, const RepairRequest& request, const Arguments& arguments,
                  const Delivery& delivery, Progress progress) {
  std::vector<FileContent> files;
  if (arguments.has("report")) files.push_back({arguments.valueOf("report"), delivery.report});
  files.push_back({request.output, run.output});
  return writeFilesAtomically(files, progress);
}

struct Repaired {
  RepairRun run;
  Delivery delivery;
};

// Repairs and writes. Where there is nothing to write the run says why.
Result<Repaired> repairAndWrite(const RepairRequest& request, const Arguments& arguments, const DocumentKinds& kinds,
                                Progress progress) {
  Result<RepairRun> run = repairFile(request, kinds, progress.part(0.0, 0.95));
  if (!run) return run.error();
  Repaired done{std::move(run.value()), {}};
  if (done.run.output.empty()) return done;
  done.delivery = deliveryOf(done.run, request, arguments);
  const Status written = writeFiles(done.run, request, arguments, done.delivery, progress.part(0.95, 1.0));
  if (!written) return written.error();
  done.run.output = {};
  return done;
}

// Tells what came of it, on stdout and stderr, and draws it. No picture is no failure: the repair is done.
int deliver(const Repaired& done, const RepairRequest& request, const Arguments& arguments) {
  for (const std::string& sentence : done.delivery.complaints) complain(sentence);
  if (arguments.has("screenshot") &&
      renderInChildProcess({request.output, arguments.valueOf("screenshot")}) == kExitInterrupted) {
    complain("Cancelled. The result is written already.");
    return kExitInterrupted;
  }
  const int printed = print(done.delivery.text);
  if (printed != kExitDone) return printed;
  return done.run.after.isSound() ? kExitDone : kExitSomethingLeft;
}

}  // namespace

namespace {

std::string repairPurpose() {
  return "Fills the holes of a mesh, removes degenerate and duplicate triangles and repairs non-manifold places.\n"
         "Everything else is unchanged, bit for bit. Exit code 0: the written file is closed, manifold, oriented\n"
         "and free of self-intersections; 2: defects remain, as reported on stderr; 1: error. The\n"
         "format is given by the extension of OUT.\n\n"
         "With several files, a folder, or one of -j, --format, --resume and --time-limit it repairs many, each in a\n"
         "separate process. OUT is then a folder with the same subfolders as the input folders.\n"
         "Files of these formats are repaired: " +
         meshFormatNames() +
         ", also in\n"
         "subfolders, without hidden files and linked folders. Prints a line for each and a summary table; exit code "
         "2: defects remain; 1: a file failed. No input is ever replaced.";
}

}  // namespace

CommandSpec repairSpec() {
  static const std::string purpose = repairPurpose();
  std::vector<OptionSpec> options = {
      meshOutputOption(),
      {"fidelity", 0, "LIST", "draft, balanced or exact, and single values: mesh.near_weld=1e-4,..."}};
  for (OptionSpec& option : optionsOf(repairOperation(), {"numbers"})) options.push_back(std::move(option));
  const std::vector<OptionSpec> others = {
      {"keep-open", 0, "ID,...", "Loops to keep open, numbered as in 'handwheel inspect'"},
      {"unit", 0, "UNIT", "mm (default), cm, m or in: noted in the report and in 3MF, nothing is scaled"},
      {"partial", 0, "", "Read the undamaged part of a damaged file"},
      {"report", 0, "FILE",
       "Write figures before and after, and the result of each loop, as JSON; with several files, of each file.\n"
       "--by both, several files: the table, as .csv or .html"},
      {"screenshot", 0, "PNG", "Draw the result; the repair does not depend on it"},
      {"json", 0, "", "Print the result of each file as one line of JSON"},
      {"jobs", 'j', "N", "Repair many: N files at a time, 1 (default) to 64"},
      {"format", 0, "ENDING", "Repair many: write all as " + meshFormatWords(true)},
      {"resume", 0, "", "Repair many: skip files done by an earlier run with the same options"},
      {"time-limit", 0, "S", "Repair many: stop a file after S seconds"},
      {"help", 'h', "", "Show this help"},
  };
  for (OptionSpec& option : volumeRepairOptions()) options.push_back(std::move(option));
  options.insert(options.end(), others.begin(), others.end());
  return {"repair", "IN [IN...]", purpose, std::move(options)};
}

int reportNothingWritten(const RepairRun& run, const RepairRequest& request) {
  if (!run.refusal.empty()) {
    reportLosses(run.file);
    return refuse(run.refusal);
  }
  if (!run.unknownLoops.empty()) {
    return failUsage("There is no loop " + std::to_string(run.unknownLoops.front()) +
                         " to keep open; 'handwheel inspect' lists them.",
                     "repair");
  }
  return refuse(request.input.string() + ": no triangle has an area, so there is nothing to repair.");
}

int runRepair(const Arguments& arguments, const DocumentKinds& kinds) {
  if (arguments.valueOf("by") == "volume") return runRepairByVolume(arguments, kinds);
  if (arguments.valueOf("by") == "both") return runRepairComparison(arguments, kinds);
  if (arguments.has("voxel") || arguments.has("close-gaps") || arguments.has("wall") || arguments.has("yes") ||
      (arguments.has("by") && arguments.valueOf("by") != "triangles"))
    return failUsage("--by is triangles, volume or both; --voxel, --close-gaps, --wall and --yes belong to volume.",
                     "repair");
  if (isBatch(arguments)) return runBatchRepair(arguments, kinds);
  RepairRequest request;
  const std::string problem = readRequest(arguments, kinds, request);
  if (!problem.empty()) return failUsage(problem, "repair");

  std::optional<Result<Repaired>> done;
  runInterruptible("Repairing",
                   [&](CommandJob& job) { done = repairAndWrite(request, arguments, kinds, job.progress()); });
  if (!*done) return fail(done->error());
  const Repaired& repaired = done->value();
  if (repaired.delivery.text.empty()) return reportNothingWritten(repaired.run, request);
  return deliver(repaired, request, arguments);
}

}  // namespace handwheel
