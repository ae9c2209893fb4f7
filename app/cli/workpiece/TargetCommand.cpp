// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TargetCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "document/OperationText.h"
#include "document/workpiece/target/DrawingExport.h"
#include "document/workpiece/target/TargetImport.h"
#include "document/workpiece/target/TargetPosition.h"
#include "document/workpiece/target/TargetReport.h"
#include "text/NoteText.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace handwheel {

namespace {

constexpr double kMostFacing = 1e4;  // mm

struct TargetRequest {
  std::filesystem::path input, part, output;
  UnturnedFaces others = UnturnedFaces::Refuse;
  std::optional<double> allowance;  // mm
  bool isTurned = false;            // end for end
  bool asJson = false;
};

// The results of the command: data read, measured and written.
struct TargetOutcome {
  std::shared_ptr<const WorkpieceTarget> target;
  std::vector<Note> notes;
  double allowance = 0.0;  // mm, left for facing
  std::optional<TargetDeviation> deviation;
  DocumentFile file;    // the workpiece's file
  std::string refusal;  // a sentence; nothing was written
};

// A bar that has room for the part where it is: a millimetre more around it, and the allowance at its upper end.
WorkpieceSnapshot barFor(const ImportedTarget& imported, double allowance) {
  const TargetProfile& target = imported.profile;
  WorkpieceSnapshot workpiece;
  workpiece.stock.diameter = std::ceil(2.0 * target.largestRadius() + 1.0);
  workpiece.stock.length = std::ceil(target.length() + allowance);
  workpiece.stock.position = target.upperEnd() + allowance - workpiece.stock.length;
  workpiece.mesh = std::make_shared<const StockMesh>(workpiece.stock, workpiece.chord);
  return workpiece;
}

Result<WrittenFile> writeOutcome(const TargetRequest& request, const OpenedFile& file,
                                 const WorkpieceSnapshot& workpiece, Progress progress) {
  if (!isDrawingName(request.output)) return saveDocument(*file.kind, file.file, workpiece, request.output, progress);
  DrawingTitle title;
  title.name = request.input.stem().string();
  title.material = workpiece.material;
  return exportDrawing(workpiece.target->profile, title, request.output, progress);
}

Result<TargetOutcome> carryOut(const TargetRequest& request, const DocumentKinds& kinds, Progress progress) {
  const std::string overwrites = refusalToOverwrite(request.output, {request.input});
  if (!request.output.empty() && !overwrites.empty()) return TargetOutcome{{}, {}, 0.0, {}, {}, overwrites};
  Result<ImportedTarget> imported = importTarget(request.input, request.others, progress.part(0.0, 0.4));
  if (!imported) return imported.error();
  if (request.isTurned) imported->profile = imported->profile.turnedEndForEnd();
  OpenedFile file = DocumentKinds::blank(*kinds.withId("workpiece"));
  WorkpieceSnapshot workpiece = barFor(*imported, request.allowance.value_or(kUsualAllowance));
  const bool hasPart = !request.part.empty();
  if (hasPart) {
    Result<OpenedFile> opened = kinds.open(request.part, {}, progress.part(0.4, 0.5));
    if (!opened) return opened.error();
    const auto* const given = dynamic_cast<const WorkpieceSnapshot*>(opened->content.get());
    if (!given) return TargetOutcome{{}, {}, 0.0, {}, {}, request.part.string() + " is not a workpiece."};
    workpiece = *given;
    file = std::move(opened.value());
  }
  workpiece.target =
      hasPart ? placedTarget(*imported, workpiece.stock, request.allowance)
              : std::make_shared<const WorkpieceTarget>(WorkpieceTarget{imported->profile, imported->source});
  TargetOutcome outcome{
      workpiece.target, imported->notes, allowanceOf(workpiece.target->profile, workpiece.stock), {}, file.file, {}};
  if (request.isTurned) outcome.notes.push_back(endsNote(workpiece.target->profile));
  if (hasPart) outcome.deviation = deviationOf(workpiece, progress.part(0.5, 0.7));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (request.output.empty()) return outcome;
  outcome.refusal = refusalToReplace(request.output, file.file);
  if (!outcome.refusal.empty()) return outcome;
  const Result<WrittenFile> written = writeOutcome(request, file, workpiece, progress.part(0.7, 1.0));
  if (!written) return written.error();
  outcome.notes.insert(outcome.notes.end(), written->notes.begin(), written->notes.end());
  return outcome;
}

std::string deviationText(const char* what, const TargetDeviation::Extreme& deviation) {
  if (deviation.distance == 0.0) return std::string("Nothing is ") + what + ".\n";
  return roundedText(std::abs(deviation.distance), 4) + " mm " + what + " at Ø" + roundedText(2.0 * deviation.at.x()) +
         ", Z " + roundedText(deviation.at.y()) + ".\n";
}

std::string targetText(const TargetOutcome& outcome, bool asJson) {
  constexpr double kTolerance = 1e-3;  // mm, of features
  const TargetProfile& profile = outcome.target->profile;
  if (asJson) {
    nlohmann::json json = {{"volume", profile.volume()},          {"length", profile.length()},
                           {"lower_end", profile.lowerEnd()},     {"largest_diameter", 2.0 * profile.largestRadius()},
                           {"bored_through", profile.isClosed()}, {"dimensions", dimensionsJson(profile, kTolerance)},
                           {kAllowanceId, outcome.allowance}};
    if (outcome.deviation) json["deviation"] = deviationJson(*outcome.deviation);
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  }
  std::string text = "Turned part Ø" + roundedText(2.0 * profile.largestRadius()) + " × " +
                     roundedText(profile.length()) + " mm, volume " + roundedText(profile.volume()) + " mm³\n";
  for (const ProfileFeature& feature : withCurves(featuresOf(profile, kTolerance)))
    text += "  " + textOf(feature) + "\n";
  text += "Finished face, zero of the drawing and of programs: Z " + roundedText(profile.upperEnd()) + ", " +
          roundedText(outcome.allowance) + " mm behind the free end of the bar.\n";
  if (!outcome.deviation) return text;
  return text + deviationText("too large", outcome.deviation->largestOver) +
         deviationText("too small", outcome.deviation->largestUnder);
}

std::string targetPurpose() {
  return "Reads the target shape of a part: a turned part as a mesh or in STEP, a half section, or a workpiece.\n"
         "The name of IN ends in " +
         choicesText(targetEndings()) +
         ".\n"
         "Lists its dimensions. With --of, measures a workpiece against it. OUT ending in .pdf, .dxf or .svg is a\n"
         "drawing of it; one ending in .handwheel is that workpiece, or else a new bar, with it as its target.\n"
         "The allowance for facing at the free end of the bar is that of --facing, or else 1 mm if the bar is long\n"
         "enough; the target of a workpiece keeps its position.\n"
         "In drawings Z is to the right and the axis horizontal: the line on the layer or with the id 'axis', else\n"
         "y = 0 in DXF and the lowest line in SVG.";
}

}  // namespace

Command targetCommand() {
  static const std::string purpose = targetPurpose();
  return {{"target",
           "IN",
           purpose,
           {
               {"of", 0, "PART", "A workpiece to measure, or to give the target to"},
               {"facing", 0, "MM", "Allowance for facing at the free end of the bar"},
               {"turn-target", 0, "", "Turn the target end for end: the end at the chuck becomes the free one"},
               {"output", 'o', "OUT", "The drawing or document to write"},
               {"ignore-unturned", 0, "", "Leave out faces that are not of revolution, for example holes across"},
               {"json", 0, "", "Report as JSON"},
               {"help", 'h', "", "Show this help"},
           }},
          runTarget};
}

int runTarget(const Arguments& arguments, const DocumentKinds& kinds) {
  TargetRequest request;
  request.input = arguments.operands[0];
  request.part = arguments.valueOf("of");
  request.output = arguments.valueOf("output");
  request.others = arguments.has("ignore-unturned") ? UnturnedFaces::Ignore : UnturnedFaces::Refuse;
  request.isTurned = arguments.has("turn-target");
  request.asJson = arguments.has("json");
  if (arguments.has("facing")) {
    double facing = 0.0;
    if (!readNumber(arguments.valueOf("facing"), facing) || !(facing >= 0.0 && facing <= kMostFacing))
      return failUsage("--facing takes a length in mm from 0 to " + shortestText(kMostFacing) + ".", "target");
    request.allowance = facing;
  }
  std::optional<Result<TargetOutcome>> outcome;
  runInterruptible("Reading", [&](CommandJob& job) { outcome = carryOut(request, kinds, job.progress()); });
  if (!*outcome) return fail(outcome->error());
  const TargetOutcome& done = outcome->value();
  reportLosses(done.file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  for (const Note& note : done.notes) complain(noteText(note).toStdString());
  return print(targetText(done, request.asJson));
}

}  // namespace handwheel
