// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/OptimiseCommand.h"

#include "base/NumberText.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/cell/PathReport.h"
#include "cli/cell/PlannedPathOutput.h"
#include "tools/cell/path/OptimisePathOperation.h"

namespace handwheel {

namespace {

PathRemarks remarksOn(const OptimisedPath& optimised) {
  nlohmann::ordered_json order = nlohmann::ordered_json::array();
  std::string numbers;
  for (const std::size_t index : optimised.order) {
    order.push_back(index + 1);
    numbers += " " + std::to_string(index + 1);
  }
  PathRemarks remarks;
  remarks.json = {{"changed", optimised.isChanged},
                  {"before_s", optimised.before},
                  {"after_s", optimised.after},
                  {"order", order},
                  {"reconfigured", optimised.reconfigured}};
  remarks.text = optimised.isChanged
                     ? "cycle time " + roundedText(optimised.before, 4) + " s before, " +
                           roundedText(optimised.after, 4) + " s now; critical places in the order" + numbers + ", " +
                           std::to_string(optimised.reconfigured) + " with other joint values\n"
                     : "nothing is quicker: the path stays as it is\n";
  return remarks;
}

int runOptimise(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(optimisePathOperation());
  const std::string& id = optimisePathOperation().id;
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, id);
  const Result<CellFile> file = openCellForArm(arguments, kinds, arguments.operands[1]);
  if (!file) return fail(file.error());
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  Result<RobotPath> path = Error{};
  std::vector<std::string> remarks;
  Result<OptimisedPath> optimised = Error{};
  Result<PlannedAndChecked> result = Error{};
  runInterruptible("Optimising", [&](CommandJob& job) {
    scene = sceneOf(*file->cell, meshes);
    CellPlans plans = *file->cell->plans;
    if (scene) path = pathCalled(*scene, *file->cell, arguments.operands[1], plans, remarks);
    if (!path) return;
    optimised =
        optimisedPath(*scene, plans, *path, optimisationSettingsOf(values, plans, *path), job.progress().part(0, 0.9));
    if (!optimised) return;
    const std::string name = optimised->planned.path.name;
    result = checkedAs(optimised->planned, values, *scene, *file->cell, job.progress().part(0.9, 1.0));
    if (result && !values.isSet("name")) result->path.path.name = name;
  });
  if (!scene) return fail(scene.error());
  if (!path) return fail(path.error());
  warnOfProgram(remarks);
  if (!optimised) return outputUnsolved(optimised.error(), arguments);
  if (!result) return fail(result.error());
  return outputPath(*result, *scene, *file, arguments, remarksOn(*optimised));
}

}  // namespace

Command optimiseCommand() {
  CommandSpec spec = {
      optimisePathOperation().id,
      "CELL PATH",
      "Chooses the order of the critical places of a path, and the configurations in which they are reached, "
      "that\ntake the least time; the first and the last stay. PATH is the name of a path in the cell, or a file.",
      {}};
  spec.options = pathOptions(optimisePathOperation());
  return {std::move(spec), runOptimise};
}

}  // namespace handwheel
