// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathCheck.h"
#include "tools/cell/path/ProgramChoices.h"

#include "cli/Arguments.h"

#include <nlohmann/json.hpp>

namespace handwheel {

inline constexpr std::size_t kMostListedPairs = 50;  // Pairs without a proof that are listed by their names

// Returns the measurements of a path for reports. Keys: certified, length_rad, waypoints, min_clearance_mm,
// manipulability, security_mm, limit_margin, cycle_s, robots_moved, collisions, outdated, not_checked (pairs of names).
nlohmann::ordered_json toJson(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);
std::string textOf(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);
// Returns the reasons why a path is out of date, as phrases.
std::vector<std::string> reasonsOf(const OutdatedReasons& outdated);
// Warns on stderr about the limitations of a proof: links without meshes, simplified shapes.
void warnOfShapes(const CellScene& scene);

// Reads the options of the verification: "resolution" and "step". Returns the error message; empty if there is none.
std::string readProof(const Arguments& arguments, PathCheckSettings& settings);
OptionSpec resolutionOption();

// Returns the content of a path file. It contains the names of the joints, their values at each waypoint, the waypoints
// in full, and "certified", which is true if the path was proven free of collisions.
nlohmann::json pathFile(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);

// Returns a path of a cell by its name, or a path that is read from a file: JSON, or the program of a controller.
// plans: those of the cell; they receive the tool centre point of a program that has another one. remarks: receives the
// remarks of programRemarks(). Errors: PathMissing, the errors of pathFromFile().
Result<RobotPath> pathCalled(const CellScene& scene, const RobotCellSnapshot& cell, const std::string& name,
                             CellPlans& plans, std::vector<std::string>& remarks);

// Reads the options of programChoiceOptions(). Returns the text of a usage error; empty: none.
std::string readChoices(const Arguments& arguments, ProgramChoices& choices);
// Returns the options by which a person decides about a path of a program. isExport: those of exports, too.
std::vector<OptionSpec> programChoiceOptions(bool isExport);
// Prints the remarks on a program as warnings.
void warnOfProgram(const std::vector<std::string>& remarks);

}  // namespace handwheel
