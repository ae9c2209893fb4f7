// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/VerifyCommand.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "cli/cell/CellFile.h"
#include "cli/cell/PathReport.h"

namespace handwheel {

namespace {

int runVerify(const Arguments& arguments, const DocumentKinds& kinds) {
  const Result<CellFile> file = openCellForArm(arguments, kinds, arguments.operands[1]);
  if (!file) return fail(file.error());
  PathCheckSettings check;
  double& clearance = check.clearance;
  if (arguments.has("clearance") && (!readNumber(arguments.valueOf("clearance"), clearance) || !(clearance >= 0.0)))
    return failUsage("The option --clearance takes a length in mm.", "verify");
  if (const std::string problem = readProof(arguments, check); !problem.empty()) return failUsage(problem, "verify");
  ProgramChoices choices;
  if (const std::string problem = readChoices(arguments, choices); !problem.empty())
    return failUsage(problem, "verify");
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  Result<RobotPath> path = Error{};
  std::vector<std::string> remarks;
  CellPlans plans = *file->cell->plans;
  Result<CheckedPath> checked = Error{};
  runInterruptible("Verifying", [&](CommandJob& job) {
    scene = sceneOf(*file->cell, meshes);
    if (scene) path = pathCalled(*scene, *file->cell, arguments.operands[1], plans, remarks);
    if (path) path = chosen(std::move(path).value(), choices);
    if (path && !arguments.has("clearance")) clearance = plans.clearanceOf(*path);
    if (path) checked = checkPath(*scene, plans, *path, check, job.progress());
  });
  if (!scene) return fail(scene.error());
  if (!path) return fail(path.error());
  warnOfProgram(remarks);
  if (!checked) return fail(checked.error());
  warnOfShapes(*scene);
  const int code =
      print(arguments.has("json") ? textOf(toJson(*scene, *path, *checked)) : textOf(*scene, *path, *checked));
  return code == kExitDone && !checked->isCertified() ? kExitSomethingLeft : code;
}

}  // namespace

Command verifyCommand() {
  CommandSpec spec = {"verify",
                      "CELL PATH",
                      "Verifies a path of a robot: proves each motion free of collisions, or lists all collisions.\n"
                      "PATH is the name of a path in the cell, or a file. Exit code 2: not all of it is free.",
                      {}};
  spec.options.push_back(armOption());
  spec.options.push_back(
      {"clearance", 0, "MM", "Clearance from all obstacles; default: that of the path, or else of the cell"});
  for (OptionSpec& option : programChoiceOptions(false)) spec.options.push_back(std::move(option));
  spec.options.push_back(resolutionOption());
  spec.options.push_back({"step", 0, "RAD", "Step of the checks of motions that are not proven free (default 0.01)"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runVerify};
}

}  // namespace handwheel
