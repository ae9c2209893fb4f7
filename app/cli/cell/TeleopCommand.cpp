// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/TeleopCommand.h"

#include "base/NumberText.h"
#include "base/ShownDistance.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "cli/TipTrajectory.h"
#include "cli/cell/CellFile.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellScene.h"
#include "planning/GuideCurve.h"
#include "planning/Teleoperation.h"
#include "tools/cell/path/PathCheck.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Result of a run.
struct TeleopRun {
  std::string table = "t_s,x_mm,y_mm,z_mm,behind_mm,fx_N,fy_N,fz_N,blocked,at_limit";
  std::size_t steps = 0;
  double seconds = 0.0, blocked = 0.0, atLimit = 0.0;  // s
  double mean = 0.0, most = 0.0;                       // mm behind
  double leastClearance = 1'000.0;                     // mm
  double largestForce = 0.0;                           // N
  ArmValues end;
  FollowingStatistics following;  // Deviation from the path, if there is one
};

// Settings of following a hand.
struct Following {
  double scale = 1.0;                            // mm of the tool to a mm of the hand
  std::shared_ptr<const GuideCurve> guide = {};  // null: no path is followed
  ArmValues start = {};                          // Beginning of the path
  double snapDistance = 0.0;                     // mm; 0: no virtual fixture
};

// A recorded hand, and what the person who led it had to go by.
struct RecordedHand {
  std::string help;  // the option that names it
  std::string file;
  std::vector<HandPose> poses = {};
};

void addRow(TeleopRun& run, double time, const Teleoperation::Step& step, const ArmValues& values) {
  const Vec3 at = step.tool.translation();
  std::string row = shortestText(time);
  for (const double value : {at.x(), at.y(), at.z(), step.behind, step.force.x(), step.force.y(), step.force.z()})
    row += "," + roundedText(value, 7);
  row += std::string(",") + (step.isBlocked ? "1" : "0") + "," + (step.isAtLimit ? "1" : "0");
  for (const double value : values) row += "," + roundedText(value, 9);
  run.table += row + "\n";
}

// The hand begins where the tool is, which is the begin of the path if there is one, and keeps its turn.
TeleopRun teleoperated(const CellScene& scene, const RobotCellSnapshot& cell, const std::vector<HandPose>& hand,
                       const Following& how, Progress progress) {
  TeleopRun run;
  for (const std::uint32_t dof : scene.dofs) run.table += "," + scene.robot->model.jointOfDof(dof).name;
  run.table += "\n";
  TeleoperationSettings settings;
  settings.check.clearance = cell.plans->clearance;
  Teleoperation robot(scene.scene, scene.arm, cell.plans->tool, how.guide ? how.start : scene.planned(cell.joints),
                      settings);
  std::optional<FollowingTry> attempt;
  if (how.guide) attempt.emplace(*how.guide);
  const Pose begin = robot.tool();
  const Vec3 handBegin = hand.front().position;
  double before = hand.front().time;
  for (std::size_t i = 0; i < hand.size() && !progress.cancelled(); ++i) {
    progress.set(static_cast<double>(i) / static_cast<double>(hand.size()));
    Pose wanted = begin;
    wanted.translation() += how.scale * (hand[i].position - handBegin);
    if (how.guide) wanted.translation() = how.guide->drawn(wanted.translation(), how.snapDistance);
    const double seconds = hand[i].time - before;
    const Teleoperation::Step step = robot.follow(wanted, seconds);
    before = hand[i].time;
    if (attempt) attempt->add(hand[i].time, step.tool.translation());
    addRow(run, hand[i].time - hand.front().time, step, robot.values());
    ++run.steps;
    run.seconds += seconds;
    run.blocked += step.isBlocked ? seconds : 0.0;
    run.atLimit += step.isAtLimit ? seconds : 0.0;
    run.mean += step.behind / static_cast<double>(hand.size());
    run.most = std::max(run.most, step.behind);
    run.largestForce = std::max(run.largestForce, step.force.norm());
    run.leastClearance =
        std::min(run.leastClearance, scene.scene.nearestObstacle(robot.values(), run.leastClearance).distance);
  }
  run.end = robot.values();
  if (attempt) run.following = attempt->figures();
  return run;
}

nlohmann::ordered_json jsonOf(const FollowingStatistics& figures) {
  return {{"rms_mm", figures.rms},
          {"max_mm", figures.most},
          {"seconds", figures.seconds},
          {"share", figures.share},
          {"complete", figures.isComplete()}};
}

nlohmann::ordered_json jsonOf(const TeleopRun& run, bool hasPath) {
  nlohmann::ordered_json report = {{"steps", run.steps},
                                   {"seconds", run.seconds},
                                   {"blocked_s", run.blocked},
                                   {"at_limit_s", run.atLimit},
                                   {"behind_mean_mm", run.mean},
                                   {"behind_max_mm", run.most},
                                   {"max_force_N", run.largestForce},
                                   {"min_clearance_mm", run.leastClearance},
                                   {"q", std::vector<double>(run.end.begin(), run.end.end())}};
  if (hasPath) report["following"] = jsonOf(run.following);
  return report;
}

std::string sentenceOf(const FollowingStatistics& figures) {
  if (figures.share <= 0.0) return "the tool did not reach the beginning of the path";
  return roundedText(figures.rms, 3) + " mm from the path (RMS), at most " + roundedText(figures.most, 3) + " mm, in " +
         roundedText(figures.seconds, 4) + " s" +
         (figures.isComplete() ? "" : ", only " + roundedText(100.0 * figures.share, 3) + " % of it");
}

std::string sentenceOf(const TeleopRun& run) {
  return std::to_string(run.steps) + " steps in " + roundedText(run.seconds, 4) + " s: blocked for " +
         roundedText(run.blocked, 3) + " s, at a limit for " + roundedText(run.atLimit, 3) +
         " s; the tool was behind the hand by " + roundedText(run.mean, 3) + " mm, at most " +
         roundedText(run.most, 3) + " mm; least clearance " + shownText(shownDistance(run.leastClearance)) + " mm\n";
}

// The hands that the options name, and what is wrong with the options otherwise.
struct TeleopOptions {
  std::vector<RecordedHand> hands;
  Following how;
  std::string problem;  // a sentence; empty: nothing
};

TeleopOptions optionsOf(const Arguments& arguments) {
  TeleopOptions options;
  for (const char* const help : {"path", "eyes", "force", "fixture"})
    if (arguments.has(help)) options.hands.push_back({help, arguments.valueOf(help)});
  if (options.hands.empty()) options.problem = "The option --path HAND.csv is missing.";
  const auto number = [&](const char* name, double least, double& value) {
    if (!arguments.has(name)) return;
    if (!readNumber(arguments.valueOf(name), value) || !(value >= least && value <= 1e3))
      options.problem =
          std::string("The option --") + name + " takes a number of " + roundedText(least, 6) + " to 1000.";
  };
  number("scale", -1e3, options.how.scale);
  options.how.snapDistance = 10.0;
  number("snap", 0.0, options.how.snapDistance);
  const bool isCompared = !options.hands.empty() && (options.hands.size() > 1 || options.hands[0].help != "path");
  if (isCompared && arguments.has("path"))
    options.problem = "The option --path does not go with --eyes, --force and --fixture.";
  if ((isCompared || arguments.has("snap")) && !arguments.has("follow"))
    options.problem = "The option --follow PATH is missing.";
  if (isCompared && arguments.has("output")) options.problem = "The option --output takes one hand, that of --path.";
  return options;
}

// The table of eyes, force, and force and fixture (He 2008, chapter 6).
int printComparison(const std::vector<RecordedHand>& hands, const std::vector<TeleopRun>& runs, bool isJson) {
  nlohmann::ordered_json report = nlohmann::ordered_json::object();
  std::string text;
  for (std::size_t i = 0; i < hands.size(); ++i) {
    report[hands[i].help] = jsonOf(runs[i].following);
    text += hands[i].help + std::string(9 - hands[i].help.size(), ' ') + sentenceOf(runs[i].following) + "\n";
  }
  return print(isJson ? textOf(report) : text);
}

Status readHand(RecordedHand& hand, std::string& problem) {
  const Result<std::string> text = readFileBytes(hand.file);
  if (!text) {
    Error error = text.error();
    error.subject = hand.file;
    return error;
  }
  TipTrajectory read = readTipTrajectory(*text);
  if (!read.problem.empty()) problem = hand.file + ": " + read.problem;
  hand.poses = std::move(read.poses);
  return Done{};
}

int runTeleop(const Arguments& arguments, const DocumentKinds& kinds) {
  TeleopOptions options = optionsOf(arguments);
  if (!options.problem.empty()) return failUsage(options.problem, "teleop");
  for (RecordedHand& hand : options.hands) {
    std::string problem;
    const Status read = readHand(hand, problem);
    if (!read) return fail(read.error());
    if (!problem.empty()) return refuse(problem);
  }
  const Result<CellFile> opened =
      openCellForArm(arguments, kinds, arguments.has("follow") ? arguments.valueOf("follow") : std::string());
  if (!opened) return fail(opened.error());
  const RobotCellSnapshot& cell = *opened->cell;
  const RobotPath* const path = arguments.has("follow") ? cell.plans->path(arguments.valueOf("follow")) : nullptr;
  if (arguments.has("follow") && (!path || path->waypoints.empty()))
    return refuse(arguments.operands[0] + ": there is no path \"" + arguments.valueOf("follow") + "\" in it.");
  if (path && !isSameArm(*cell.robot, path->arm, cell.plans->arm))
    return fail(Error{CellError::OfOtherArm, {path->name, path->arm}, {}, {}});
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  std::vector<TeleopRun> runs;
  runInterruptible("Following", [&](CommandJob& job) {
    scene = sceneOf(cell, meshes);
    if (!scene) return;
    if (path) {
      options.how.guide = std::make_shared<const GuideCurve>(toolCurve(*scene, *cell.plans, *path));
      options.how.start = scene->planned(path->waypoints.front().joints);
    }
    for (const RecordedHand& hand : options.hands) {
      Following how = options.how;
      if (hand.help != "fixture" && !(hand.help == "path" && arguments.has("snap"))) how.snapDistance = 0.0;
      runs.push_back(teleoperated(*scene, cell, hand.poses, how, job.progress()));
    }
  });
  if (!scene) return fail(scene.error());
  if (arguments.has("output")) {
    const Status written = writeFileAtomically(arguments.valueOf("output"), runs[0].table, {});
    if (!written) return fail(written.error());
  }
  if (options.hands[0].help != "path") return printComparison(options.hands, runs, arguments.has("json"));
  if (arguments.has("json")) return print(textOf(jsonOf(runs[0], path != nullptr)));
  return print(sentenceOf(runs[0]) + (path ? sentenceOf(runs[0].following) + "\n" : ""));
}

}  // namespace

Command teleopCommand() {
  CommandSpec spec = {
      "teleop",
      "CELL",
      "Lets a robot follow the recorded path of a hand within its joint limits and without collisions.\n"
      "The hand begins where the tool is; HAND.csv has the columns t_s, x_mm, y_mm, z_mm.\n"
      "With --follow it starts at the beginning of a path of the cell and reports how closely the tool\n"
      "followed it; --eyes, --force and --fixture compare three hands in one table.",
      {}};
  spec.options.push_back(armOption());
  spec.options.push_back({"path", 0, "HAND.csv", "The path of the hand"});
  spec.options.push_back({"scale", 0, "FACTOR", "mm of the tool to a mm of the hand (default 1)"});
  spec.options.push_back({"follow", 0, "PATH", "Path of the cell that the tool was to follow"});
  spec.options.push_back(
      {"snap", 0, "MM",
       "Virtual fixture: the tool is attracted to the path within this distance (default 10 for --fixture)"});
  spec.options.push_back({"eyes", 0, "HAND.csv", "Path of a hand that only saw the path"});
  spec.options.push_back({"force", 0, "HAND.csv", "Path of a hand that also felt the robot"});
  spec.options.push_back({"fixture", 0, "HAND.csv", "Path of a hand that also felt the robot and the fixture"});
  spec.options.push_back({"output", 'o', "OUT.csv", "Position of the tool, force on the hand, and joint values"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runTeleop};
}

}  // namespace handwheel
