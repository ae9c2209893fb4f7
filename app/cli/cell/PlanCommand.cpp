// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/PlanCommand.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/cell/PlannedPathOutput.h"

namespace handwheel {

namespace {

Result<PlannedAndChecked> planned(const OperationValues& values, const CellScene& scene, const RobotCellSnapshot& cell,
                                  Progress progress) {
  const Result<std::vector<PathPlace>> places = placesOf(values, scene, cell);
  if (!places) return places.error();
  const RouteSettings settings = routeSettingsOf(values, *cell.plans);
  Result<PlannedPath> path = plannedThrough(scene, *cell.plans, *places, settings, progress.part(0.0, 0.8));
  if (!path) return path.error();
  return checkedAs(std::move(path).value(), values, scene, cell, progress.part(0.8, 1.0));
}

int runPlan(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(planOperation());
  const std::string& id = planOperation().id;
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, id);
  for (const char* const end : {"from", "to"}) {
    if (!values.isSet(end)) return failUsage(std::string("The option --") + end + " PLACE is missing.", id);
  }
  const Result<CellFile> file = openCell(arguments.operands[0], kinds);
  if (!file) return fail(file.error());
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
  return {std::move(spec), runPlan};
}

}  // namespace handwheel
