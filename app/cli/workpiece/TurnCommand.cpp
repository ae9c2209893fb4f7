// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnCommand.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/TipTrajectory.h"
#include "document/FileBytes.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "machining/TurningFidelity.h"
#include "text/NoteText.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

struct TurnRequest {
  std::filesystem::path input, path, output;
  double noseRadius = 1.0;
  double spacing = turnSpacingSetting().standard;
  bool isReplay = false;
  bool asJson = false;
};

std::string readLength(const Arguments& arguments, const char* name, double largest, double& value) {
  if (!arguments.has(name)) return {};
  if (readNumber(arguments.valueOf(name), value) && value > 0.0 && value <= largest) return {};
  return std::string("--") + name + " takes a length in mm above zero, at most " + shortestText(largest) + ".";
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
  if (std::string problem = readLength(arguments, "nose-radius", 1e3, request.noseRadius); !problem.empty())
    return problem;
  return readLength(arguments, "spacing", 1e3, request.spacing);
}

// The path as a pass: from its distance from the axis and its height above the lower end of the bar.
Result<TurningPass> readPass(const TurnRequest& request, const StockCylinder& stock) {
  const auto located = [&](Error error) {
    error.subject = request.path.string();
    return error;
  };
  const Result<std::string> text = readFileBytes(request.path);
  if (!text) return located(text.error());
  const TipTrajectory path = readTipTrajectory(*text);
  if (!path.problem.empty()) return located({ErrorCode::ElementMalformed, {"path", path.problem}, {}, {}});
  if (path.poses.size() > TurningPass::kMostPoints)
    return located({ErrorCode::FileTooLarge,
                    {"lines", std::to_string(path.poses.size()), std::to_string(TurningPass::kMostPoints)},
                    {},
                    {}});
  TurningPass pass;
  pass.noseRadius = request.noseRadius;
  for (const HandPose& pose : path.poses) {
    pass.path.emplace_back(std::hypot(pose.position.x(), pose.position.y()), pose.position.z() - stock.position);
    pass.times.push_back(pose.time - path.poses.front().time);
  }
  return pass;
}

std::string report(const WorkpieceSnapshot& workpiece, const TurnRequest& request, std::optional<bool> isSame) {
  const double volume = workpiece.part ? workpiece.part->profile.volume() : workpiece.stock.volume();
  const double removed = workpiece.stock.volume() - volume;
  const std::size_t passes = workpiece.part ? workpiece.part->passes.size() : 0;
  if (request.asJson) {
    nlohmann::json json = {{"passes", passes}, {"volume", volume}, {"removed", removed}};
    if (isSame) json["same"] = *isSame;
    return json.dump(2) + "\n";
  }
  std::string text = "Passes: " + std::to_string(passes) + ". Volume: " + roundedText(volume) + " mm³, " +
                     roundedText(removed) + " mm³ removed from the bar.\n";
  if (isSame)
    text += *isSame ? "Repeated, the passes give the same part.\n" : "Repeated, the passes give another part.\n";
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
  if (!given) return refuse(request.input.string() + " is no workpiece: only workpieces are turned.");
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
  Result<TurningPass> pass = readPass(request, given->stock);
  if (!pass) return fail(pass.error());
  WorkpieceSnapshot turned = *given;
  std::optional<Result<WrittenFile>> written;
  runInterruptible("Turning", [&](CommandJob& job) {
    turned.part = withPass(*given, std::move(pass.value()), request.spacing, job.progress().part(0.0, 0.7));
    if (turned.part)
      written = saveDocument(*file.kind, file.file, turned, request.output, job.progress().part(0.7, 1.0));
    else
      written = Error{ErrorCode::Cancelled, {}, {}, {}};
  });
  if (!*written) return fail(written->error());
  for (const Note& note : written->value().notes) complain(noteText(note).toStdString());
  return print(report(turned, request, {}));
}

std::vector<Command> workpieceCommands() {
  return {{{"turn",
            "IN",
            "Cuts a workpiece on a lathe along a recorded path of the tool, as one pass.\n"
            "P.csv has the columns t_s,x_mm,y_mm,z_mm: the centre of the nose. The part turns about z, so that its\n"
            "distance from that axis is what counts. Exit code 0: done; 2: --replay found a difference; 1: error.",
            {
                {"path", 0, "P.csv", "The path of the tool"},
                {"output", 'o', "OUT", "The document to write, .handwheel or an export; may be IN"},
                {"nose-radius", 0, "MM", "Radius of the round tool (default 1)"},
                {"spacing", 0, "MM", "Distance of the samples of the profile, for a bar that was not cut yet"},
                {"replay", 0, "", "Repeat the passes of IN on its bar and compare the result, bit for bit"},
                {"json", 0, "", "Report as JSON"},
                {"help", 'h', "", "Show this page"},
            }},
           runTurn}};
}

}  // namespace handwheel
