// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/PostCommand.h"

#include "base/NumberText.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "cli/cell/CellFile.h"
#include "cli/cell/PathReport.h"
#include "tools/cell/path/PathExport.h"

#include <algorithm>
#include <span>

namespace handwheel {

namespace {

constexpr const char* kBaseFrame = "base";  // Base of the robot; a frame of the cell may have this name

std::string controllers() {
  std::string all;
  for (const auto& post : posts()) all += (all.empty() ? "" : ", ") + std::string(post->id());
  return all;
}

int runPost(const Arguments& arguments, const DocumentKinds& kinds) {
  if (!arguments.has("output")) return failUsage("The option -o OUT is missing.", "post");
  const PostProcessor* const post = arguments.has("controller") ? postCalled(arguments.valueOf("controller"))
                                                                : postForEnding(arguments.valueOf("output"));
  if (!post && arguments.has("controller"))
    return failUsage("The option --controller takes one of " + controllers() + ".", "post");
  if (!post)
    return failUsage("The ending of OUT is that of no language, so give --controller: " + controllers() + ".", "post");
  const bool leavesOutFrame = arguments.has("without-wobjdata");
  if (leavesOutFrame && post->id() != std::string_view("rapid"))
    return failUsage("The option --without-wobjdata needs --controller rapid.", "post");
  const Result<CellFile> file = openCellForArm(arguments, kinds, arguments.operands[1]);
  if (!file) return fail(file.error());
  PathCheckSettings check;
  if (const std::string problem = readProof(arguments, check); !problem.empty()) return failUsage(problem, "post");
  ProgramChoices choices;
  if (const std::string problem = readChoices(arguments, choices); !problem.empty()) return failUsage(problem, "post");
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  Status possible = Done{};  // an arm that the language cannot move is refused before any work
  Result<RobotPath> path = Error{};
  std::vector<std::string> remarks;
  CellPlans plans = *file->cell->plans;
  std::vector<std::size_t> leftOut;
  Result<CheckedPath> checked = Error{};
  runInterruptible("Verifying", [&](CommandJob& job) {
    scene = sceneOf(*file->cell, meshes);
    if (scene) possible = canBeWritten(*scene, *post);
    if (scene && possible) path = pathCalled(*scene, *file->cell, arguments.operands[1], plans, remarks);
    if (path) leftOut = linesLeftOut(*path, choices);
    if (path) path = chosen(std::move(path).value(), choices);
    if (path) check.clearance = plans.clearanceOf(*path);
    if (path) checked = checkPath(*scene, plans, *path, check, job.progress());
  });
  if (!scene) return fail(scene.error());
  if (!possible) return fail(possible.error());
  if (!path) return fail(path.error());
  warnOfProgram(remarks);
  if (!checked) return fail(checked.error());
  warnOfShapes(*scene);
  const std::string output = arguments.valueOf("output");
  if (arguments.has("frame")) {
    const std::string name = arguments.valueOf("frame");
    plans.workFrame = name == kBaseFrame && !plans.frame(name) ? std::string() : name;
  }
  const Result<WrittenProgram> written =
      writeProgram(*scene, plans, *path, *checked, *post, output,
                   {.outdated = arguments.has("outdated") ? OutdatedPath::Write : OutdatedPath::Refuse,
                    .frameData = leavesOutFrame ? FrameData::AtController : FrameData::InProgram,
                    .leftOut = leftOut});
  if (!written) return fail(written.error());
  const PostCheck& readBack = written->check;
  if (!written->otherRobot.empty()) {
    complain(std::string("warning: ") + post->title() + " is not the language of the controller of this robot, " +
             written->otherRobot);
  }
  for (const std::string& reason : reasonsOf(checked->outdated)) complain("warning: " + reason);
  const auto& pairs = checked->notChecked;
  for (const auto& [one, other] : std::span(pairs).first(std::min(pairs.size(), kMostListedPairs)))
    complain("warning: " + one + " with " + other + " was not checked, as they may touch");
  if (pairs.size() > kMostListedPairs)
    complain("warning: " + std::to_string(pairs.size() - kMostListedPairs) + " more pairs were not checked");
  if (checked->isTouching()) complain("warning: the robot touches something on the path: its clearance is 0 mm");
  if (const std::string blends = smallerBlendsText(written->smaller); !blends.empty()) complain("warning: " + blends);
  if (const std::size_t stops = written->stopsOfLanguage; stops > 0)
    complain("warning: " + std::to_string(stops) + (stops == 1 ? " blend" : " blends") +
             " became exact stops: " + post->title() + " has none there");
  if (!leftOut.empty())
    complain("warning: " + std::to_string(leftOut.size()) + (leftOut.size() == 1 ? " line" : " lines") +
             " of the opened program, as outputs and waiting, were left out; the head of the program has their "
             "numbers");
  if (arguments.has("json")) {
    return print(textOf({{"controller", post->id()},
                         {"motions", readBack.motions},
                         {"error_mm", readBack.distance},
                         {"error_deg", readBack.angle},
                         {"exact_stops", written->exactStops},
                         {"exact_stops_of_language", written->stopsOfLanguage},
                         {"cycle_s", written->seconds},
                         {"lines_left_out", leftOut},
                         {"smaller_blends", written->smaller.size()},
                         {"clearance_mm", checked->clearance},
                         {"touching", checked->isTouching()},
                         {"not_checked", checked->notChecked},
                         {"other_robot", !written->otherRobot.empty()},
                         {"outdated", checked->outdated.isAny()},
                         {"frame", written->frame.empty() ? nlohmann::json() : nlohmann::json(written->frame)},
                         {"certified", true}}));
  }
  std::string text = output + ": " + post->title() + ", " + std::to_string(readBack.motions) +
                     " motions, read back within " + roundedText(readBack.distance, 2) + " mm and " +
                     roundedText(readBack.angle, 2) + " degrees, about " + roundedText(written->seconds, 3) + " s\n";
  if (!written->frame.empty()) text += "Its places are in the frame " + written->frame + ".\n";
  if (written->exactStops > 0)
    text += std::to_string(written->exactStops) +
            " blends became exact stops: not every way within their zones is proven free\n";
  return print(text);
}

}  // namespace

Command postCommand() {
  CommandSpec spec = {
      "post",
      "CELL PATH",
      "Writes a path of a robot as a program of its controller, if it is proven free of collisions.\n"
      "The program is read back and compared with the path before it is written. docs/robots.md has more.",
      {}};
  spec.options.push_back(
      {"controller", 0, "NAME", "The language (default: that of the ending of OUT): " + controllers()});
  spec.options.push_back(armOption());
  spec.options.push_back({"frame", 0, "NAME",
                          "The frame of the cell that the places are written in (default: the one chosen in the cell); "
                          "'base': that of the robot"});
  spec.options.push_back({"without-wobjdata", 0, "",
                          "RAPID: only name the frame of the cell; another module of the same task has its data"});
  for (OptionSpec& option : programChoiceOptions(true)) spec.options.push_back(std::move(option));
  spec.options.push_back(resolutionOption());
  spec.options.push_back(
      {"outdated", 0, "",
       "Write it even if its part, its robot, a frame or a target has moved, or the tool or a configuration "
       "has changed, since it was planned; a comment of the program says so"});
  spec.options.push_back({"output", 'o', "OUT", "The file to write"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runPost};
}

}  // namespace handwheel
