// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/PlannedPathOutput.h"

#include "base/NumberText.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "cli/cell/PathReport.h"
#include "document/AtomicFile.h"
#include "document/cell/CellErrors.h"
#include "document/cell/PlansEdit.h"

#include <algorithm>

namespace handwheel {

namespace {

int writePath(const PlannedAndChecked& planned, const CellScene& scene, const CellFile& file,
              const std::filesystem::path& output) {
  if (!isContainerName(output)) {
    const std::string text = pathFile(scene, planned.path.path, planned.checked).dump(1) + "\n";
    const Status written = writeFileAtomically(output, text, {});
    return written ? kExitDone : fail(written.error());
  }
  RobotCellSnapshot cell = *file.cell;
  CellPlans plans = *cell.plans;
  std::erase_if(plans.paths, [&](const RobotPath& path) { return path.name == planned.path.path.name; });
  plans.paths.push_back(planned.path.path);
  if (const Status fits = checkCounts(plans); !fits) return fail(fits.error());
  cell.plans = std::make_shared<const CellPlans>(std::move(plans));
  return saveCell(file, cell, output);
}

}  // namespace

Result<PlannedAndChecked> checkedAs(PlannedPath path, const OperationValues& values, const CellScene& scene,
                                    const RobotCellSnapshot& cell, Progress progress) {
  path.path.name = values.isSet("name") ? values.text("name") : cell.plans->freePathName("path");
  Result<CheckedPath> checked =
      checkPath(scene, *cell.plans, path.path, checkSettingsOf(values, *cell.plans, path.path), progress);
  if (!checked) return checked.error();
  return PlannedAndChecked{std::move(path), std::move(checked).value()};
}

int outputPath(const PlannedAndChecked& planned, const CellScene& scene, const CellFile& file,
               const Arguments& arguments, const PathRemarks& remarks) {
  warnOfShapes(scene);
  if (arguments.has("output")) {
    if (const int code = writePath(planned, scene, file, arguments.valueOf("output")); code != kExitDone) return code;
  }
  nlohmann::ordered_json report = {{"solved", true}};
  report.update(toJson(scene, planned.path.path, planned.checked));
  report["seconds"] = planned.path.seconds;
  report["checks"] = planned.path.steps;
  report.update(remarks.json);
  const std::string text = arguments.has("json") ? textOf(report)
                                                 : textOf(scene, planned.path.path, planned.checked) + "planned in " +
                                                       roundedText(planned.path.seconds, 3) + " s\n" + remarks.text;
  const int code = print(text);
  return code == kExitDone && !planned.checked.isCertified() ? kExitSomethingLeft : code;
}

int outputUnsolved(const Error& error, const Arguments& arguments) {
  const auto answers = {&CellError::RouteNotFound, &CellError::WaypointCollides,     &CellError::WaypointTooNear,
                        &CellError::LineTooNear,   &CellError::WaypointBeyondLimits, &CellError::LineUnreachable,
                        &CellError::LineCollides,  &CellError::TrackOutOfReach,      &CellError::TrackBlocked,
                        &CellError::TrackBroken};
  if (std::none_of(answers.begin(), answers.end(), [&](const auto* answer) { return error.code == *answer; }))
    return fail(error);
  complain(fullSentenceFor(error));
  if (arguments.has("json")) {
    const int code = print(textOf({{"solved", false}, {"certified", false}, {"reason", sentenceFor(error)}}));
    if (code != kExitDone) return code;
  }
  return kExitSomethingLeft;
}

std::vector<OptionSpec> pathOptions(const Operation& operation) {
  std::vector<OptionSpec> options = optionsOf(operation);
  options.push_back(armOption());
  options.push_back({"output", 'o', "OUT", "The path as JSON, or the cell with the path as .handwheel"});
  options.push_back({"json", 0, "", "Report as JSON"});
  options.push_back({"help", 'h', "", "Show this help"});
  return options;
}

}  // namespace handwheel
