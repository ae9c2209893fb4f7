// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/MeshReport.h"

#include <nlohmann/json.hpp>
#include <string>

namespace handwheel {

// The report as JSON, as "handwheel inspect --json" prints it. The keys are in that order; volume_mm3 is null for an
// open mesh.
nlohmann::ordered_json toJson(const MeshReport& report);

// Formats JSON with an indent of two, ending in a line feed. Names that are not UTF-8 get replacement characters.
std::string textOf(const nlohmann::ordered_json& json);

}  // namespace handwheel
