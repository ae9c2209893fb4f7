// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/mesh/RepairJob.h"
#include "mesh/repair/OutcomeCounts.h"

#include <nlohmann/json.hpp>
#include <string>

namespace handwheel {

// Returns the report of a repair as JSON, which --report writes. unit is the user's word for the file's lengths;
// nothing is scaled by it.
nlohmann::ordered_json toJson(const RepairRun& run, const RepairRequest& request, const std::string& unit);

// Returns the outcome of a repair as one line of JSON, for programs. "state" is "closed" if the result is sound
// (MeshState::isSound()), otherwise "left-open"; "left" counts the defects that keep the file from being closed, and
// "reason" describes the first.
std::string outcomeLine(const RepairRun& run, const RepairRequest& request);

// Convert the counts of holes, outer boundaries and new openings to members of a JSON object, and back. Members that
// are missing or have another type count as 0.
nlohmann::ordered_json toJson(const LoopCounts& loops);
LoopCounts loopCountsFrom(const nlohmann::json& object);

}  // namespace handwheel
