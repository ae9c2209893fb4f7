// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/RepairJob.h"

#include <nlohmann/json.hpp>

namespace handwheel {

// What --report writes. unit is the user's word for the file's lengths; nothing is scaled by it.
nlohmann::ordered_json toJson(const RepairRun& run, const RepairRequest& request, const std::string& unit);

}  // namespace handwheel
