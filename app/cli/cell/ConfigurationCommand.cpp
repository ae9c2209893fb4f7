// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/ConfigurationCommand.h"

#include "base/NumberText.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationJson.h"
#include "cli/OperationOptions.h"
#include "cli/PlansText.h"
#include "cli/ReportJson.h"
#include "cli/cell/CellFile.h"
#include "cli/cell/PathReport.h"
#include "document/FileBytes.h"
#include "document/cell/CellArms.h"
#include "document/cell/PlansEdit.h"
#include "document/cell/path/OutdatedReasons.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyErrors.h"
#include "robot/program/PathFile.h"
#include "tools/cell/ConfigurationOperation.h"
#include "tools/cell/ConfigurationPoses.h"
#include "tools/cell/path/DefaultClearance.h"
#include "tools/cell/path/IkSolutionText.h"
#include "tools/cell/path/PathExport.h"
#include "tools/cell/path/ProgramFrames.h"
#include "tools/cell/path/ProgramRemarks.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The plans with what a semantic description adds.
Result<CellPlans> withSrdf(CellPlans plans, const std::string& path, const RobotCellSnapshot& cell) {
  const auto named = [&](Error error) {
    error.subject = path;
    return error;
  };
  const Result<std::string> bytes = readFileBytes(path);
  if (!bytes) return named(bytes.error());
  const Result<RobotSemantics> semantics =
      readSrdf(*bytes, cell.robot->model, cell.robot->arms, activeArmNumber(*cell.robot, plans));
  if (!semantics) return named(semantics.error());
  for (const Error& damage : semantics->damage) complain(sentenceFor(named(damage)));
  Result<CellPlans> changed = withSemantics(std::move(plans), *semantics, cell);
  return changed ? changed : named(changed.error());
}

// Report on a path that was opened.
struct OpenedPath {
  TakenFrames frames = {};
  std::vector<std::string> remarks = {};  // programRemarks()
};

// Adds the path of a program or a path file, called as the arguments say or as the file, and the frames that it gives.
Result<OpenedPath> openPath(const Arguments& arguments, RobotCellSnapshot& cell, Progress progress) {
  const std::filesystem::path file = arguments.valueOf("open");
  const std::string name = arguments.has("name") ? arguments.valueOf("name") : file.stem().string();
  if (arguments.has("name") && !isBodyName(name))
    return Error{BodyError::NameUnusable, {name, std::to_string(kLongestBodyName)}, {}, {}};
  CollisionMeshes meshes;
  const Result<CellScene> scene = sceneOf(cell, meshes);
  if (!scene) return scene.error();
  Result<ProgramPath> read = pathFromFile(*scene, cell, file, progress);
  if (!read) return read.error();
  OpenedPath opened;
  for (const QString& remark : programRemarks(*read, cell.plans->tool)) opened.remarks.push_back(remark.toStdString());
  CellPlans plans = *cell.plans;
  if (arguments.has("name")) std::erase_if(plans.paths, [&](const RobotPath& path) { return path.name == name; });
  read->path.name = plans.freePathName(isBodyName(name) ? name : "path");
  const double offered = defaultClearance(*cell.robot, plans);
  read->path.clearance = plans.ownClearance(read->path.clearance.value_or(offered));
  opened.frames = takeProgram(std::move(read).value(), *cell.robot,
                              {*cell.plans, cell.bodies, cell.robot->model, cell.joints}, plans);
  cell.plans = std::make_shared<const CellPlans>(std::move(plans));
  return opened;
}

std::string configurationsReport(const nlohmann::json& described, const OpenedPath& opened, bool asJson) {
  const TakenFrames& frames = opened.frames;
  if (asJson)
    return textOf({{"configurations", described["configurations"]},
                   {"targets", described["targets"]},
                   {"frames", described["frames"]},
                   {"paths", described["paths"]},
                   {"frames_made", frames.made},
                   {"frames_used", frames.used},
                   {"remarks", opened.remarks}});
  std::string text = plansText(described);
  for (const std::string& frame : frames.made) text += "The program's frame " + frame + " is in the cell now.\n";
  for (const std::string& frame : frames.used) text += "The program is in the frame " + frame + " of the cell.\n";
  return text;
}

// Returns all configurations in which the arm brings its tool to the pose that the values give.
Result<nlohmann::json> solutionsJson(const OperationValues& values, const RobotCellSnapshot& cell) {
  const Result<Pose> pose = givenPose(values, cell);
  if (!pose) return pose.error();
  CollisionMeshes meshes;
  const Result<CellScene> scene = sceneOf(cell, meshes);
  if (!scene) return scene.error();
  nlohmann::json list = nlohmann::json::array();
  std::size_t chosen = 0;  // Number among those that --solution takes, which come first
  for (const CellIkSolution& solution : ikSolutionsTo(*scene, *cell.plans, *pose, scene->planned(cell.joints))) {
    const QString configuration =
        solution.arm.configuration ? configurationText(*solution.arm.configuration) : QString();
    const nlohmann::json number = solution.isWithinLimits() ? nlohmann::json(++chosen) : nlohmann::json();
    list.push_back({{"number", number},
                    {"joints", toJson(cell.robot->model, scene->whole(solution.arm.values))},
                    {"configuration", configuration.toStdString()},
                    {"stance", configuration.toStdString()},  // the former key
                    {"within_limits", solution.isWithinLimits()},
                    {"free", solution.isFree()},
                    {"problem", problemText(*scene, solution).toStdString()},
                    {"turned_off", turnedOffText(solution).toStdString()},
                    {"way_mm", solution.arm.distance}});
  }
  return list;
}

int listSolutions(const OperationValues& values, const RobotCellSnapshot& cell, bool asJson) {
  const Result<nlohmann::json> solutions = solutionsJson(values, cell);
  if (!solutions) return fail(solutions.error());
  const auto isFree = [](const nlohmann::json& solution) { return solution["free"].get<bool>(); };
  const bool isAnyFree = std::any_of(solutions->begin(), solutions->end(), isFree);
  std::string text = solutions->empty() ? "The arm cannot bring its tool there.\n" : "";
  for (const nlohmann::json& solution : *solutions) {
    const std::string configuration = solution["configuration"], problem = solution["problem"],
                      turned = solution["turned_off"];
    text += (solution["number"].is_null() ? "-" : solution["number"].dump()) + ": " +
            (configuration.empty() ? std::string() : configuration + ", ") + (problem.empty() ? "free" : problem) +
            (turned.empty() ? "" : ", " + turned) + "\n  ";
    for (const auto& [joint, value] : solution["joints"].items())
      text += " " + joint + "=" + roundedText(std::round(1e6 * value.get<double>()) / 1e6, 9);
    text += "\n";
  }
  const int printed = print(asJson ? textOf({{"solutions", *solutions}}) : text);
  return printed != kExitDone ? printed : isAnyFree ? kExitDone : kExitSomethingLeft;
}

int runConfiguration(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(configurationOperation());
  const std::string& id = configurationOperation().id;
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, id);
  if (const std::string problem = problemOfConfigurationValues(values); !problem.empty())
    return failUsage(sentenceOf(problem), id);
  const bool isListing = values.flag("solutions");
  if (!isListing && !arguments.has("output")) return failUsage("The option -o OUT is missing.", id);
  if (arguments.has("name") && !arguments.has("open")) return failUsage("The option --name needs --open.", id);
  const Result<CellFile> file = openCellForArm(arguments, kinds);
  if (!file) return fail(file.error());
  if (isListing) return listSolutions(values, *file->cell, arguments.has("json"));
  Result<ChangedCell> changed = changedCell(values, *file->cell);
  if (!changed) return fail(changed.error());
  if (arguments.has("srdf")) {
    Result<CellPlans> plans = withSrdf(std::move(changed->plans), arguments.valueOf("srdf"), *file->cell);
    if (!plans) return fail(plans.error());
    changed->plans = std::move(plans).value();
  }
  RobotCellSnapshot cell = *file->cell;
  cell.plans = std::make_shared<const CellPlans>(std::move(changed->plans));
  cell.joints = changed->joints;
  Result<OpenedPath> opened = OpenedPath();
  if (arguments.has("open"))
    runInterruptible("Reading", [&](CommandJob& job) { opened = openPath(arguments, cell, job.progress()); });
  if (!opened) return fail(opened.error());
  warnOfProgram(opened->remarks);
  for (const std::string& frame : opened->frames.leftOut)
    complain("warning: there are too many frames in the cell for " + frame + " of the program");
  if (const Status fits = checkCounts(*cell.plans); !fits) return fail(fits.error());
  if (values.isSet("remove")) {
    for (const std::string& path : pathsThrough(*cell.plans, values.text("remove")))
      complain("warning: the path " + path + " keeps the joint values of " + values.text("remove"));
  }
  if (const int code = saveCell(*file, cell, arguments.valueOf("output")); code != kExitDone) return code;
  return print(configurationsReport(file->opened.kind->describe(cell), *opened, arguments.has("json")));
}

}  // namespace

Command configurationCommand() {
  CommandSpec spec = {configurationOperation().id,
                      "CELL",
                      "Stores named joint values, targets and frames in a robot cell, between which paths are planned, "
                      "and paths of programs, and moves the robot.\n"
                      "CELL is a document, a URDF, a table after Denavit and Hartenberg, or a built-in robot (irb120).",
                      {}};
  spec.options = optionsOf(configurationOperation());
  spec.options.push_back(armOption());
  spec.options.push_back({"srdf", 0, "FILE", "Adds the pairs that may touch and the states of a semantic description"});
  spec.options.push_back({"open", 0, "FILE",
                          "Stores the path of a robot program, or of a path file, and the frames that it gives; not "
                          "verified"});
  spec.options.push_back({"name", 0, "NAME",
                          "The name of that path (default: that of the file, with a number if it is taken); a path of "
                          "that name is replaced"});
  spec.options.push_back({"output", 'o', "OUT", "The document to write, .handwheel; may be CELL"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runConfiguration};
}

}  // namespace handwheel
