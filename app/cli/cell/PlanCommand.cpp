// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/PlanCommand.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "cli/cell/ComparisonReport.h"
#include "cli/cell/PlannedPathOutput.h"

#include <algorithm>

namespace handwheel {

namespace {

Result<PlannedAndChecked> planned(const OperationValues& values, const CellScene& scene, const RobotCellSnapshot& cell,
                                  Progress progress) {
  const Result<std::vector<Waypoint>> waypoints = waypointsOf(values, scene, cell);
  if (!waypoints) return waypoints.error();
  const RouteSettings settings = routeSettingsOf(values, *cell.plans);
  Result<PlannedPath> path = plannedThrough(scene, *cell.plans, *waypoints, settings, progress.part(0.0, 0.8));
  if (!path) return path.error();
  return checkedAs(std::move(path).value(), values, scene, cell, progress.part(0.8, 1.0));
}

// The table of He 2008: without critical configurations, with one, with two and so on.
int runComparison(const Arguments& arguments, const OperationValues& values, const CellFile& file) {
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  Result<std::vector<Waypoint>> waypoints = Error{};
  std::vector<ComparedPath> paths;
  runInterruptible("Planning", [&](CommandJob& job) {
    scene = sceneOf(*file.cell, meshes);
    if (scene) waypoints = waypointsOf(values, *scene, *file.cell);
    if (!waypoints) return;
    paths = comparedPaths(*scene, *file.cell->plans, *waypoints, routeSettingsOf(values, *file.cell->plans),
                          job.progress());
  });
  if (!scene) return fail(scene.error());
  if (!waypoints) return fail(waypoints.error());
  std::vector<std::string> names;
  for (std::size_t i = 1; i + 1 < waypoints->size(); ++i)
    names.push_back((*waypoints)[i].name.empty() ? "place " + std::to_string(i) : (*waypoints)[i].name);
  const int code = print(arguments.has("json") ? textOf(toJson(*scene, paths, names)) : comparisonText(paths, names));
  const bool isWhole = std::all_of(
      paths.begin(), paths.end(), [](const ComparedPath& each) { return each.checked && each.checked->isCertified(); });
  return code == kExitDone && !isWhole ? kExitSomethingLeft : code;
}

int runPlan(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(planOperation());
  const std::string& id = planOperation().id;
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, id);
  for (const char* const end : {"from", "to"}) {
    if (!values.isSet(end)) return failUsage(std::string("The option --") + end + " PLACE is missing.", id);
  }
  const Result<CellFile> file = openCellForArm(arguments, kinds);
  if (!file) return fail(file.error());
  if (arguments.has("compare")) {
    if (arguments.has("output")) return failUsage("--compare cannot be combined with -o: it plans several paths.", id);
    return runComparison(arguments, values, *file);
  }
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  Result<PlannedAndChecked> result = Error{};
  runInterruptible("Planning", [&](CommandJob& job) {
    scene = sceneOf(*file->cell, meshes);
    if (scene) result = planned(values, *scene, *file->cell, job.progress());
  });
  if (!scene) return fail(scene.error());
  return result ? outputPath(*result, *scene, *file, arguments) : outputUnsolved(result.error(), arguments);
}

}  // namespace

Command planCommand() {
  CommandSpec spec = {planOperation().id,
                      "CELL",
                      "Plans a path of the robot in a cell, proves it free of collisions, and measures it.\n"
                      "CELL is a document, a URDF, a table after Denavit and Hartenberg, or a built-in robot (irb120).",
                      {}};
  spec.options = pathOptions(planOperation());
  spec.options.insert(
      spec.options.end() - 2,
      {"compare", 0, "", "A table: with none, the first, the first two… of --via, without and with shortcuts"});
  return {std::move(spec), runPlan};
}

}  // namespace handwheel
