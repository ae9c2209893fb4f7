// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathCheck.h"

#include "cli/Arguments.h"

#include <nlohmann/json.hpp>

namespace handwheel {

// The measurements of a path for reports. Keys: certified, length_rad, waypoints, min_clearance_mm, manipulability,
// security_mm, limit_margin, cycle_s, robots_moved, outdated, collisions, not_checked (pairs of names).
nlohmann::ordered_json toJson(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);
std::string textOf(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);
// Why a path does not lead to what it was planned for any more: phrases.
std::vector<std::string> reasonsOf(const OutdatedReasons& outdated);
// Says on stderr what a proof rests on: links without meshes, simplified shapes.
void warnOfShapes(const CellScene& scene);

// Reads how a path is verified: "resolution" and "step". Returns what is wrong, or nothing.
std::string readProof(const Arguments& arguments, PathCheckSettings& settings);
OptionSpec resolutionOption();

// The path as a file: joints, waypoints in their order, certified, and the places in full.
nlohmann::json pathFile(const CellScene& scene, const RobotPath& path, const CheckedPath& checked);

// A path of a cell by its name, or read from a file: as JSON, or a program of a controller. Errors: PathMissing, those
// of pathFromFile(). remarks: gets what programRemarks() has to say.
Result<RobotPath> pathCalled(const CellScene& scene, const RobotCellSnapshot& cell, const std::string& name,
                             std::vector<std::string>& remarks);

// Says these as warnings.
void warnOfProgram(const std::vector<std::string>& remarks);

}  // namespace handwheel
