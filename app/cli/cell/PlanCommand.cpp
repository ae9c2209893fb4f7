// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/PlanCommand.h"

#include "base/NumberText.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "cli/cell/CellFile.h"
#include "cli/cell/PathReport.h"
#include "document/AtomicFile.h"
#include "document/cell/CellErrors.h"
#include "tools/cell/PlanOperation.h"

#include <optional>

namespace handwheel {

namespace {

struct Planned {
  PlannedPath path;
  CheckedPath checked;
};

Result<Planned> planned(const OperationValues& values, const CellScene& scene, const RobotCellSnapshot& cell,
                        Progress progress) {
  const Result<std::vector<PathPlace>> places = placesOf(values, scene, cell);
  if (!places) return places.error();
  const RouteSettings settings = routeSettingsOf(values, *cell.plans);
  Result<PlannedPath> path = plannedThrough(scene, *cell.plans, *places, settings, progress.part(0.0, 0.8));
  if (!path) return path.error();
  const std::string name = values.isSet("name") ? values.text("name") : "path";
  path->path.name = values.isSet("name") ? name : cell.plans->freePathName(name);
  Result<CheckedPath> checked =
      checkPath(scene, *cell.plans, path->path, settings.plan.check.clearance, progress.part(0.8, 1.0));
  if (!checked) return checked.error();
  return Planned{std::move(path).value(), std::move(checked).value()};
}

int write(const Planned& planned, const CellScene& scene, const CellFile& file, const std::filesystem::path& output) {
  if (!isContainerName(output)) {
    const std::string text = pathFile(scene, planned.path.path, planned.checked).dump(1) + "\n";
    const Status written = writeFileAtomically(output, text, {});
    return written ? kExitDone : fail(written.error());
  }
  RobotCellSnapshot cell = *file.cell;
  CellPlans plans = *cell.plans;
  std::erase_if(plans.paths, [&](const RobotPath& path) { return path.name == planned.path.path.name; });
  plans.paths.push_back(planned.path.path);
  cell.plans = std::make_shared<const CellPlans>(std::move(plans));
  return saveCell(file, cell, output);
}

// What made planning impossible: a report all the same, so that a script reads why.
int unsolved(const Error& error, bool asJson) {
  const bool isAnswer = error.code == CellError::RouteNotFound || error.code == CellError::PlaceCollides ||
                        error.code == CellError::PlaceBeyondLimits || error.code == CellError::LineUnreachable ||
                        error.code == CellError::PathCollides;
  if (!isAnswer) return fail(error);
  complain(fullSentenceFor(error));
  if (asJson) {
    const int code = print(textOf({{"solved", false}, {"certified", false}, {"reason", sentenceFor(error)}}));
    if (code != kExitDone) return code;
  }
  return kExitSomethingLeft;
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
  Result<Planned> result = Error{};
  runInterruptible("Planning", [&](CommandJob& job) {
    scene = sceneOf(*file->cell, meshes);
    if (scene) result = planned(values, *scene, *file->cell, job.progress());
  });
  if (!scene) return fail(scene.error());
  if (!result) return unsolved(result.error(), arguments.has("json"));
  for (const std::uint32_t link : scene->shapeless)
    complain("The mesh of the link " + file->cell->robot->model.links[link].name +
             " is missing: it collides with nothing.");
  if (arguments.has("output")) {
    if (const int code = write(*result, *scene, *file, arguments.valueOf("output")); code != kExitDone) return code;
  }
  nlohmann::ordered_json report = {{"solved", true}};
  report.update(toJson(*scene, result->path.path, result->checked));
  report["seconds"] = result->path.seconds;
  report["checks"] = result->path.steps;
  const std::string text = arguments.has("json") ? textOf(report)
                                                 : textOf(*scene, result->path.path, result->checked) + "planned in " +
                                                       roundedText(result->path.seconds, 3) + " s\n";
  const int code = print(text);
  return code == kExitDone && !result->checked.isCertified() ? kExitSomethingLeft : code;
}

}  // namespace

Command planCommand() {
  CommandSpec spec = {planOperation().id,
                      "CELL",
                      "Plans a path of the robot in a cell, proves it free of collisions, and measures it.\n"
                      "CELL is a document, a URDF, a table after Denavit and Hartenberg, or a built-in robot (irb120).",
                      {}};
  spec.options = optionsOf(planOperation());
  spec.options.push_back({"output", 'o', "OUT", "The path as JSON, or the cell with the path as .handwheel"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runPlan};
}

}  // namespace handwheel
