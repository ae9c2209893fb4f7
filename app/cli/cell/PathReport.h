// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathCheck.h"

#include "cli/Arguments.h"

#include <nlohmann/json.hpp>

namespace handwheel {

// Returns the measurements of a path for reports. Keys: certified, length_rad, waypoints, min_clearance_mm,
// manipulability, security_mm, limit_margin, cycle_s, robots_moved, outdated, collisions, not_checked (pairs of names).
nlohmann::ordered_json toJson(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);
std::string textOf(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);
// Returns the reasons why a path is out of date, as phrases.
std::vector<std::string> reasonsOf(const OutdatedReasons& outdated);
// Warns on stderr about the limits of a proof: links without meshes, simplified shapes.
void warnOfShapes(const CellScene& scene);

// Reads the options of the verification: "resolution" and "step". Returns the error, or nothing.
std::string readProof(const Arguments& arguments, PathCheckSettings& settings);
OptionSpec resolutionOption();

// Returns the path as a file: joints, waypoints in their order, certified, and the waypoints in full.
nlohmann::json pathFile(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);

// Returns a path of a cell by its name, or read from a file: as JSON, or a program of a controller. Errors:
// PathMissing, those of pathFromFile(). remarks: receives those of programRemarks().
Result<RobotPath> pathCalled(const CellScene& scene, const RobotCellSnapshot& cell, const std::string& name,
                             std::vector<std::string>& remarks);

// Prints these remarks as warnings.
void warnOfProgram(const std::vector<std::string>& remarks);

}  // namespace handwheel
