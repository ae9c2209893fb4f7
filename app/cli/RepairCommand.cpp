// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/RepairCommand.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/Picture.h"
#include "cli/RepairJson.h"
#include "cli/ReportJson.h"
#include "cli/Wording.h"
#include "document/AtomicFile.h"
#include "fidelity/MeasuredSettings.h"
#include "mesh/MeshFidelity.h"

#include <algorithm>

namespace handwheel {

namespace {

bool readIds(std::string_view list, std::set<int>& ids) {
  while (true) {
    const std::size_t comma = list.find(',');
    int id = 0;
    if (!readNumber(list.substr(0, comma), id)) return false;
    ids.insert(id);
    if (comma == std::string_view::npos) return true;
    list.remove_prefix(comma + 1);
  }
}

// OUT may be IN, but what is written beside must not replace either, nor another document, nor one another.
std::string problemBeside(const RepairRequest& request, const Arguments& arguments, const DocumentKinds& kinds) {
  const std::string report = arguments.valueOf("report"), picture = arguments.valueOf("screenshot");
  for (const std::string& beside : {report, picture}) {
    if (beside.empty()) continue;
    if (isSameFile(beside, request.input) || isSameFile(beside, request.output)) {
      return "IN and OUT cannot be the report or the screenshot too: " + beside + ".";
    }
  }
  const bool both = !report.empty() && !picture.empty();
  if (both && isSameFile(report, picture)) return "The report and the screenshot need a file each.";
  if (isDocumentName(report, kinds)) return "--report takes a name such as part.json, not that of a document.";
  if (!picture.empty() && !isPictureName(picture)) return "--screenshot takes a name that ends in .png.";
  return {};
}

// Turns the words into a request. Returns what is wrong with them, or nothing.
std::string readRequest(const Arguments& arguments, const DocumentKinds& kinds, RepairRequest& request) {
  if (!arguments.has("output")) return "The option -o OUT is missing.";
  request.input = arguments.operands[0];
  request.output = arguments.valueOf("output");
  request.read.partial = arguments.has("partial");
  request.countSelfIntersections = arguments.has("report");
  request.options.fillRims = arguments.has("fill-rims");
  request.options.removeDebris = arguments.has("remove-debris");
  if (arguments.has("fidelity")) {
    const Result<FidelityValues> values = readValues(measuredSettings(), arguments.valueOf("fidelity"));
    if (!values) return sentenceFor(values.error());
    apply(*values, request.options);
  }
  if (arguments.has("fill")) {
    const auto method = fillMethodFor(arguments.valueOf("fill"));
    if (!method) return "--fill takes fair, refined, ear or minimal.";
    request.options.fill.method = *method;
  }
  if (arguments.has("keep-open") && !readIds(arguments.valueOf("keep-open"), request.options.keepOpen)) {
    return "--keep-open takes loop numbers separated by commas.";
  }
  if (arguments.has("max-hole") &&
      (!readNumber(arguments.valueOf("max-hole"), request.options.maxEdges) || request.options.maxEdges == 0)) {
    return "--max-hole takes a number of edges above zero.";
  }
  const std::string unit = arguments.valueOf("unit");
  if (arguments.has("unit") && unit != "mm" && unit != "cm" && unit != "m" && unit != "in") {
    return "--unit takes mm, cm, m or in.";
  }
  return problemBeside(request, arguments, kinds);
}

// "closed, manifold and oriented", or what of it the file is not.
std::string verdict(const MeshReport& file) {
  if (file.isSound()) return " is closed, manifold and oriented.\n";
  std::string missing;
  const auto add = [&missing](bool holds, const char* property) {
    if (!holds) missing += (missing.empty() ? " is not " : ", not ") + std::string(property);
  };
  add(file.closed, "closed");
  add(file.manifold, "manifold");
  add(file.oriented, "oriented");
  return missing + ".\n";
}

std::string summary(const RepairRun& run, const RepairRequest& request) {
  const auto filled = std::count_if(run.repair.loops.begin(), run.repair.loops.end(),
                                    [](const LoopResult& l) { return l.outcome == LoopOutcome::Filled; });
  return std::to_string(filled) + " of " + std::to_string(run.repair.loops.size()) + " holes filled. " +
         request.output.string() + verdict(run.after) + changesLine(run.repair);
}

// Tells what came of it, on stdout and stderr and in the files asked for.
int deliver(const RepairRun& run, const RepairRequest& request, const Arguments& arguments) {
  tellLosses(run.file);
  if (arguments.has("report")) {
    const std::string unit = arguments.has("unit") ? arguments.valueOf("unit") : "mm";
    const Status written = writeFileAtomically(arguments.valueOf("report"), textOf(toJson(run, request, unit)));
    if (!written) return fail(written.error());
  }
  if (arguments.has("screenshot")) {
    // No picture is no failure: the repair is done.
    if (makePictureApart(request.output, arguments.valueOf("screenshot"), false) == kExitInterrupted) {
      return kExitInterrupted;
    }
  }
  for (const std::string& sentence : leftovers(run.repair, run.after)) complain(sentence);
  const int printed = print(summary(run, request));
  if (printed != kExitDone) return printed;
  return run.after.isSound() ? kExitDone : kExitSomethingLeft;
}

}  // namespace

CommandSpec repairSpec() {
  return {
      "repair",
      "IN",
      "Fills the holes of a mesh, removes degenerate and duplicate faces and mends non-manifold places. Everything\n"
      "else stays as it is, bit for bit. Exit code 0: the written file is closed, manifold and oriented;\n"
      "2: something is left and told on stderr; 1: error. The format is that of OUT's ending.",
      {
          {"output", 'o', "OUT", "The repaired mesh: .stl, .ply, .obj, .off, .3mf or .handwheel; may be the input"},
          {"fidelity", 0, "LIST", "draft, balanced or exact, and single values: mesh.near_weld=1e-4,..."},
          {"fill", 0, "METHOD", "fair (default), refined, ear or minimal"},
          {"keep-open", 0, "ID,...", "Loops to leave open, numbered as 'handwheel inspect' does"},
          {"fill-rims", 0, "", "Also fill the outer edges of open sheets"},
          {"max-hole", 0, "N", "Leave loops with more than N edges open"},
          {"remove-debris", 0, "", "Remove parts far smaller than the largest"},
          {"unit", 0, "UNIT", "mm (default), cm, m or in: noted in the report, nothing is scaled"},
          {"partial", 0, "", "Read what is readable of a damaged file"},
          {"report", 0, "FILE", "Write figures before and after, and what became of each loop, as JSON"},
          {"screenshot", 0, "PNG", "Draw the result; where that fails the repair is done all the same"},
          {"help", 'h', "", "Show this page"},
      }};
}

int runRepair(const Arguments& arguments, const DocumentKinds& kinds) {
  RepairRequest request;
  const std::string problem = readRequest(arguments, kinds, request);
  if (!problem.empty()) return failUsage(problem, "repair");

  std::optional<Result<RepairRun>> run;
  runInterruptible("Repairing", [&](Job& job) { run = repairFile(request, kinds, job); });
  if (!*run) return fail(run->error());
  const RepairRun& result = run->value();
  if (!result.refusal.empty()) {
    tellLosses(result.file);
    return refuse(result.refusal);
  }
  if (!result.unknownLoops.empty()) {
    return failUsage("There is no loop " + std::to_string(result.unknownLoops.front()) +
                         " to keep open; 'handwheel inspect' lists them.",
                     "repair");
  }
  if (result.nothingLeft) {
    return refuse(request.input.string() + ": no triangle has an area, so there is nothing to repair.");
  }
  if (!result.isMeasured) {
    complain(kCancelledTooLate);
    return kExitInterrupted;
  }
  return deliver(result, request, arguments);
}

}  // namespace handwheel
