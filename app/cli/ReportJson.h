// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/MeshReport.h"

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace handwheel {

// Returns the report as JSON, in the form that "handwheel inspect --json" prints. The keys are in that order;
// volume_mm3 is null for an open mesh.
nlohmann::ordered_json toJson(const MeshReport& report);

// Repeats values under their former keys. renamed: {present key, former key} of an object; it has the present ones.
void addFormerKeys(nlohmann::ordered_json& object, std::initializer_list<std::pair<const char*, const char*>> renamed);

// Formats JSON with an indent of two, ending in a line feed. Names that are not UTF-8 get replacement characters.
std::string textOf(const nlohmann::ordered_json& json);

}  // namespace handwheel
