// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/RepairJob.h"

#include <nlohmann/json.hpp>
#include <string>

namespace handwheel {

// What --report writes. unit is the user's word for the file's lengths; nothing is scaled by it.
nlohmann::ordered_json toJson(const RepairRun& run, const RepairRequest& request, const std::string& unit);

// What came of it on one line, for programs: "state" is "closed" (and manifold, and oriented) or "left-open"; "left"
// counts the places that keep the file from being closed, and "reason" says what is wrong with the first.
std::string outcomeLine(const RepairRun& run, const RepairRequest& request);

std::size_t filledLoops(const RepairReport& repair);

}  // namespace handwheel
