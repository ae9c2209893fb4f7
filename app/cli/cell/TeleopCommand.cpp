// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/TeleopCommand.h"

#include "base/NumberText.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "cli/TipTrajectory.h"
#include "cli/cell/CellFile.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "document/cell/CellScene.h"
#include "planning/Teleoperation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// What a run came to.
struct TeleopRun {
  std::string table = "t_s,x_mm,y_mm,z_mm,behind_mm,fx_N,fy_N,fz_N,blocked,at_limit";
  std::size_t steps = 0;
  double seconds = 0.0, blocked = 0.0, atLimit = 0.0;  // s
  double mean = 0.0, most = 0.0;                       // mm behind
  double leastClearance = 1'000.0;                     // mm
  double largestForce = 0.0;                           // N
  ArmValues end;
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

// The hand begins where the tool is, and keeps its turn.
TeleopRun teleoperated(const CellScene& scene, const RobotCellSnapshot& cell, const std::vector<HandPose>& hand,
                       double scale, Progress progress) {
  TeleopRun run;
  for (const std::uint32_t dof : scene.dofs) run.table += "," + scene.robot->model.jointOfDof(dof).name;
  run.table += "\n";
  TeleoperationSettings settings;
  settings.check.clearance = cell.plans->clearance;
  Teleoperation robot(scene.scene, scene.arm, cell.plans->tool, scene.planned(cell.joints), settings);
  const Pose begin = robot.tool();
  const Vec3 handBegin = hand.front().position;
  double before = hand.front().time;
  for (std::size_t i = 0; i < hand.size() && !progress.cancelled(); ++i) {
    progress.set(static_cast<double>(i) / static_cast<double>(hand.size()));
    Pose wanted = begin;
    wanted.translation() += scale * (hand[i].position - handBegin);
    const double seconds = hand[i].time - before;
    const Teleoperation::Step step = robot.follow(wanted, seconds);
    before = hand[i].time;
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
  return run;
}

int runTeleop(const Arguments& arguments, const DocumentKinds& kinds) {
  if (!arguments.has("path")) return failUsage("The option --path HAND.csv is missing.", "teleop");
  double scale = 1.0;
  if (arguments.has("scale") && (!readNumber(arguments.valueOf("scale"), scale) || !(std::abs(scale) <= 1e3)))
    return failUsage("The option --scale takes a number.", "teleop");
  const std::string file = arguments.valueOf("path");
  const Result<std::string> text = readFileBytes(file);
  if (!text) {
    Error error = text.error();
    error.subject = file;
    return fail(error);
  }
  const TipTrajectory hand = readTipTrajectory(*text);
  if (!hand.problem.empty()) return refuse(file + ": " + hand.problem);
  const Result<CellFile> opened = openCell(arguments.operands[0], kinds);
  if (!opened) return fail(opened.error());
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  TeleopRun run;
  runInterruptible("Following", [&](CommandJob& job) {
    scene = sceneOf(*opened->cell, meshes);
    if (scene) run = teleoperated(*scene, *opened->cell, hand.poses, scale, job.progress());
  });
  if (!scene) return fail(scene.error());
  if (arguments.has("output")) {
    const Status written = writeFileAtomically(arguments.valueOf("output"), run.table, {});
    if (!written) return fail(written.error());
  }
  if (arguments.has("json")) {
    return print(textOf({{"steps", run.steps},
                         {"seconds", run.seconds},
                         {"blocked_s", run.blocked},
                         {"at_limit_s", run.atLimit},
                         {"behind_mean_mm", run.mean},
                         {"behind_max_mm", run.most},
                         {"max_force_N", run.largestForce},
                         {"min_clearance_mm", run.leastClearance},
                         {"q", std::vector<double>(run.end.begin(), run.end.end())}}));
  }
  return print(std::to_string(run.steps) + " steps in " + roundedText(run.seconds, 4) + " s: blocked for " +
               roundedText(run.blocked, 3) + " s, at a limit for " + roundedText(run.atLimit, 3) +
               " s; the tool was behind the hand by " + roundedText(run.mean, 3) + " mm, at most " +
               roundedText(run.most, 3) + " mm; least clearance " + roundedText(run.leastClearance, 4) + " mm\n");
}

}  // namespace

Command teleopCommand() {
  CommandSpec spec = {"teleop",
                      "CELL",
                      "Lets a robot follow the recorded path of a hand, never beyond its limits nor through anything.\n"
                      "The hand begins where the tool is; HAND.csv has the columns t_s, x_mm, y_mm, z_mm.",
                      {}};
  spec.options.push_back({"path", 0, "HAND.csv", "The path of the hand"});
  spec.options.push_back({"scale", 0, "FACTOR", "mm of the tool to a mm of the hand (default 1)"});
  spec.options.push_back({"output", 'o', "OUT.csv", "Where the tool was, the force on the hand, and the joints"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runTeleop};
}

}  // namespace handwheel
