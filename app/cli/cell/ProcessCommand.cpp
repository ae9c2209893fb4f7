// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/ProcessCommand.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/cell/PlannedPathOutput.h"
#include "tools/cell/ProcessPathOperation.h"

namespace handwheel {

namespace {

Result<PlannedAndChecked> processed(const OperationValues& values, const CellScene& scene,
                                    const RobotCellSnapshot& cell, Progress progress) {
  const Result<BodyPointer> part = partCalled(values, scene);
  if (!part) return part.error();
  const auto surface = std::make_shared<const PartSurface>(*(*part)->geometry->surface());
  Result<PlannedPath> path = processPath(scene, cell, values, surface, **part, progress.part(0.0, 0.8));
  if (!path) return path.error();
  return checkedAs(std::move(path).value(), values, scene, cell, progress.part(0.8, 1.0));
}

int runProcess(const Arguments& arguments, const DocumentKinds& kinds) {
  OperationValues values(processPathOperation());
  const std::string& id = processPathOperation().id;
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, id);
  if (!values.isSet("part")) return failUsage("The option --part BODY is missing.", id);
  if (!values.isSet("near")) return failUsage("The option --near X,Y,Z is missing.", id);
  const Result<CellFile> file = openCellForArm(arguments, kinds);
  if (!file) return fail(file.error());
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  Result<PlannedAndChecked> result = Error{};
  runInterruptible("Planning", [&](CommandJob& job) {
    scene = sceneOf(*file->cell, meshes);
    if (scene) result = processed(values, *scene, *file->cell, job.progress());
  });
  if (!scene) return fail(scene.error());
  if (result && result->path.isJagged) {
    complain(
        "warning: the curve turns to and fro again and again, as edges of scanned parts do: follow a section or a "
        "drawn "
        "curve, or give a larger --tolerance");
  }
  return result ? outputPath(*result, *scene, *file, arguments) : outputUnsolved(result.error(), arguments);
}

}  // namespace

Command processCommand() {
  CommandSpec spec = {
      processPathOperation().id,
      "CELL",
      "Plans a path of the robot's tool along an edge, a section or a drawn curve of a part, proven free "
      "of collisions.",
      {}};
  spec.options = pathOptions(processPathOperation());
  return {std::move(spec), runProcess};
}

}  // namespace handwheel
