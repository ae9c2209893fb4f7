// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

#include <nlohmann/json.hpp>

namespace handwheel {

// Returns the values of an operation as JSON for a report. Defaults are included; a parameter without a value is null.
// The keys are the ids with underscores, followed by the unit: "near_weld", "error_mm", "keep_creases_deg".
nlohmann::ordered_json toJson(const OperationValues& values);

}  // namespace handwheel
