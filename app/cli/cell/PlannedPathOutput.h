// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"
#include "cli/cell/CellFile.h"
#include "tools/cell/path/PathCheck.h"
#include "tools/cell/path/PlanOperation.h"

#include <nlohmann/json.hpp>

namespace handwheel {

// Output of the commands that plan paths.

// A planned path with its name, verified and measured.
struct PlannedAndChecked {
  PlannedPath path;
  CheckedPath checked;
};

// Names a planned path and verifies it. values: the options of the command, which may contain the name and the
// clearance; the defaults are a free name and the clearance of the path. Errors: the errors of checkPath().
Result<PlannedAndChecked> checkedAs(PlannedPath path, const OperationValues& values, const CellScene& scene,
                                    const RobotCellSnapshot& cell, Progress progress);

// Additions of a command to the report on a path.
struct PathRemarks {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text = {};
};

// Writes the path to the output that the arguments name, as JSON or into the cell, and prints its report. Returns the
// exit code.
int outputPath(const PlannedAndChecked& planned, const CellScene& scene, const CellFile& file,
               const Arguments& arguments, const PathRemarks& remarks = {});

// Reports the reason why no path was planned, also as JSON for scripts if requested. Returns the exit code.
int outputUnsolved(const Error& error, const Arguments& arguments);

// Returns the options of a command that plans a path: those of its operation, and the common ones after these.
std::vector<OptionSpec> pathOptions(const Operation& operation);

}  // namespace handwheel
