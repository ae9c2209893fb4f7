// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/TipTrajectory.h"
#include "cli/workpiece/RecordedPasses.h"
#include "document/FileBytes.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "haptics/recording/RecordingCsv.h"
#include "machining/TurningFidelity.h"
#include "text/NoteText.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr double kLeastSpacing = 1e-6, kLargestSpacing = 1e3;  // mm
constexpr const char* kTouchesNothing = "The path does not touch the part.";

struct TurnRequest {
  std::filesystem::path input, path, output;
  double noseRadius = 1.0;
  double spacing = turnSpacingSetting().standard;
  bool isReplay = false;
  bool asJson = false;
};

std::string readLength(const Arguments& arguments, const char* name, double least, double largest, double& value) {
  if (!arguments.has(name)) return {};
  if (readNumber(arguments.valueOf(name), value) && value >= least && value <= largest) return {};
  return std::string("--") + name + " takes a length in mm from " + shortestText(least) + " to " +
         shortestText(largest) + ".";
}

// Returns what is wrong with the words, or nothing.
std::string readRequest(const Arguments& arguments, TurnRequest& request) {
  request.input = arguments.operands[0];
  request.path = arguments.valueOf("path");
  request.output = arguments.valueOf("output");
  request.isReplay = arguments.has("replay");
  request.asJson = arguments.has("json");
  if (request.isReplay == arguments.has("path")) return "Give either --path P.csv or --replay.";
  if (!request.isReplay && !arguments.has("output")) return "The option -o OUT is missing.";
  if (request.isReplay && arguments.has("output")) return "--replay writes nothing: leave out -o.";
  if (std::string problem =
          readLength(arguments, "nose-radius", TurningPass::kLeastNose, TurningPass::kLargestNose, request.noseRadius);
      !problem.empty())
    return problem;
  return readLength(arguments, "spacing", kLeastSpacing, kLargestSpacing, request.spacing);
}

// A path is one pass: its distance from the axis and its height above the lower end of the bar.
Result<std::vector<TurningPass>> passAlong(const std::vector<HandPose>& poses, double noseRadius, double base) {
  if (poses.size() > TurningPass::kMostPoints)
    return Error{ErrorCode::FileTooLarge,
                 {"lines", std::to_string(poses.size()), std::to_string(TurningPass::kMostPoints)},
                 {},
                 {}};
  TurningPass pass;
  pass.noseRadius = noseRadius;
  for (const HandPose& pose : poses) {
    pass.path.emplace_back(std::hypot(pose.position.x(), pose.position.y()), pose.position.z() - base);
    pass.times.push_back(pose.time - poses.front().time);
  }
  return std::vector<TurningPass>{std::move(pass)};
}

// What is wrong with a table that is neither a path nor a whole recording: the columns that it would need.
std::string missingColumns(std::string_view text, const std::string& problemAsPath) {
  const std::string_view header = text.substr(0, text.find('\n'));
  if (header.find("hip_x") == header.npos && header.find("proxy_x") == header.npos) return problemAsPath;
  std::string names;
  for (const std::string_view name : missingRecordingColumns(text))
    names += (names.empty() ? "" : ", ") + std::string(name);
  return "Of the columns of a recording these are missing: " + names + ".";
}

// problem: a sentence about the file, which is not cut as the arguments of an Error are.
Result<std::vector<TurningPass>> passesIn(std::string_view text, const TurnRequest& request, double base,
                                          std::string& problem, Progress progress) {
  if (isRecordingCsv(text)) {
    const Result<Recording> recording = recordingFromCsv(text, progress);
    if (!recording) return recording.error();
    return passesOf(*recording, request.noseRadius, base);
  }
  const TipTrajectory path = readTipTrajectory(text);
  if (path.problem.empty()) return passAlong(path.poses, request.noseRadius, base);
  problem = missingColumns(text, path.problem);
  return std::vector<TurningPass>();
}

Result<std::vector<TurningPass>> readPasses(const TurnRequest& request, double base, std::string& problem,
                                            Progress progress) {
  const Result<std::string> text = readFileBytes(request.path);
  Result<std::vector<TurningPass>> passes =
      text ? passesIn(*text, request, base, problem, progress) : Result<std::vector<TurningPass>>(text.error());
  if (passes) return passes;
  Error error = passes.error();
  error.subject = request.path.string();
  return error;
}

// The workpiece after these passes. Error: Cancelled.
Result<WorkpieceSnapshot> turn(WorkpieceSnapshot workpiece, std::vector<TurningPass> passes, double spacing,
                               Progress progress) {
  const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(passes.size()); };
  for (std::size_t i = 0; i < passes.size(); ++i) {
    auto turned = withPass(workpiece, std::move(passes[i]), spacing, progress.part(share(i), share(i + 1)));
    if (!turned) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (!turned->passes.empty()) workpiece.part = std::move(turned);  // else it is the bar still
  }
  return workpiece;
}

std::size_t passCount(const WorkpieceSnapshot& workpiece) {
  return workpiece.part ? workpiece.part->passes.size() : 0;
}

std::string report(const WorkpieceSnapshot& workpiece, const TurnRequest& request, std::optional<bool> isSame) {
  const double volume = workpiece.part ? workpiece.part->profile.volume() : workpiece.stock.volume();
  const double removed = workpiece.stock.volume() - volume;
  const std::size_t passes = passCount(workpiece);
  if (request.asJson) {
    nlohmann::json json = {{"passes", passes}, {"volume", volume}, {"removed", removed}};
    if (isSame) json["same"] = *isSame;
    return json.dump(2) + "\n";
  }
  std::string text = "Passes: " + std::to_string(passes) + ". Volume: " + roundedText(volume) + " mm³, " +
                     roundedText(removed) + " mm³ removed from the bar.\n";
  if (isSame)
    text += *isSame ? "Replayed, the passes give the same part.\n" : "Replayed, the passes give a different part.\n";
  return text;
}

const WorkpieceSnapshot* workpieceIn(const OpenedFile& opened) {
  return dynamic_cast<const WorkpieceSnapshot*>(opened.content.get());
}

// Whether the passes cut the same part from the bar, bit for bit.
bool repeats(const WorkpieceSnapshot& workpiece, Progress progress) {
  if (!workpiece.part) return true;
  TurnedProfile profile(workpiece.stock, workpiece.part->profile.spacing());
  for (std::size_t i = 0; i < workpiece.part->passes.size() && !progress.cancelled(); ++i) {
    cut(profile, *workpiece.part->passes[i], progress);
  }
  return profile == workpiece.part->profile;
}

}  // namespace

int runTurn(const Arguments& arguments, const DocumentKinds& kinds) {
  TurnRequest request;
  if (const std::string problem = readRequest(arguments, request); !problem.empty()) return failUsage(problem, "turn");
  std::optional<Result<OpenedFile>> opened;
  runInterruptible("Reading", [&](CommandJob& job) { opened = kinds.open(request.input, {}, job.progress()); });
  if (!*opened) return fail(opened->error());
  const OpenedFile& file = opened->value();
  const WorkpieceSnapshot* const given = workpieceIn(file);
  if (!given) return refuse(request.input.string() + " is not a workpiece: only workpieces can be turned.");
  reportLosses(file.file);

  std::optional<Error> problem;
  if (request.isReplay) {
    bool isSame = false;
    runInterruptible("Turning", [&](CommandJob& job) {
      isSame = repeats(*given, job.progress());
      if (job.progress().cancelled()) problem = Error{ErrorCode::Cancelled, {}, {}, {}};
    });
    if (problem) return fail(*problem);
    const int code = print(report(*given, request, isSame));
    return code == kExitDone && !isSame ? kExitSomethingLeft : code;
  }

  if (const std::string refusal = refusalToReplace(request.output, file.file); !refusal.empty()) return refuse(refusal);
  std::string unreadable;
  std::optional<Result<WorkpieceSnapshot>> turned;
  std::optional<Result<WrittenFile>> written;
  runInterruptible("Turning", [&](CommandJob& job) {
    Result<std::vector<TurningPass>> passes =
        readPasses(request, given->stock.position, unreadable, job.progress().part(0.0, 0.2));
    turned = passes ? turn(*given, std::move(passes.value()), request.spacing, job.progress().part(0.2, 0.7))
                    : Result<WorkpieceSnapshot>(passes.error());
    if (*turned && passCount(turned->value()) > passCount(*given))
      written = saveDocument(*file.kind, file.file, turned->value(), request.output, job.progress().part(0.7, 1.0));
  });
  if (!*turned) return fail(turned->error());
  if (!unreadable.empty()) return refuse(request.path.string() + ": " + unreadable);
  if (!written) {
    complain(kTouchesNothing);
    return kExitSomethingLeft;
  }
  if (!*written) return fail(written->error());
  for (const Note& note : written->value().notes) complain(noteText(note).toStdString());
  return print(report(turned->value(), request, {}));
}

std::vector<Command> workpieceCommands() {
  return {
      {{"turn",
        "IN",
        "Cuts a workpiece on a lathe along a recorded path of the tool.\n"
        "P.csv has the columns t_s,x_mm,y_mm,z_mm: the centre of the tool nose, of one pass. Or it is a recording that "
        "the\n"
        "window has exported, in the coordinates of the document: each press of the first button is a pass, including\n"
        "passes discarded with Esc; it does not contain --nose-radius. The part turns about z: only the distance from\n"
        "that axis matters. Exit code 0: done; 2: the path does not touch the part and nothing is written, or\n"
        "--replay found a difference; 1: error.",
        {
            {"path", 0, "P.csv", "The path of the tool"},
            {"output", 'o', "OUT", "The document to write, .handwheel or an export; may be IN"},
            {"nose-radius", 0, "MM", "Radius of the round tool, 0.05 to 50 (default 1)"},
            {"spacing", 0, "MM", "Sample spacing of the profile, for a bar that was not cut yet"},
            {"replay", 0, "", "Replay the passes of IN on its bar and compare the result, bit for bit"},
            {"json", 0, "", "Report as JSON"},
            {"help", 'h', "", "Show this help"},
        },
        "IN (--path P.csv -o OUT [--nose-radius MM] [--spacing MM] | --replay) [--json]"},
       runTurn}};
}

}  // namespace handwheel
