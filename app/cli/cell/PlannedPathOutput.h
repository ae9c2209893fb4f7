// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"
#include "cli/cell/CellFile.h"
#include "tools/cell/path/PathCheck.h"
#include "tools/cell/path/PlanOperation.h"

#include <nlohmann/json.hpp>

namespace handwheel {

// The output of the commands that plan paths.

// A path under its name, verified and measured.
struct PlannedAndChecked {
  PlannedPath path;
  CheckedPath checked;
};

// Names the path as the values say, then verifies it with their clearance, or that of the path. Errors: those of
// checkPath().
Result<PlannedAndChecked> checkedAs(PlannedPath path, const OperationValues& values, const CellScene& scene,
                                    const RobotCellSnapshot& cell, Progress progress);

// What a command says of a path beside its report.
struct PathRemarks {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::string text = {};
};

// Writes the path where the arguments say, as JSON or into the cell, and prints its report. Returns the exit code.
int outputPath(const PlannedAndChecked& planned, const CellScene& scene, const CellFile& file,
               const Arguments& arguments, const PathRemarks& remarks = {});

// Reports why no path was planned: as JSON, too, so that a script reads it. Returns the exit code.
int outputUnsolved(const Error& error, const Arguments& arguments);

// The options that these commands share, after those of their operation.
std::vector<OptionSpec> pathOptions(const Operation& operation);

}  // namespace handwheel
