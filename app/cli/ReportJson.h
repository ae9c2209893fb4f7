// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/MeshReport.h"

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace handwheel {

// Returns the report as JSON. "handwheel inspect --json" prints it without changing the order of the keys. volume_mm3
// is null for an open mesh.
nlohmann::ordered_json toJson(const MeshReport& report);

// Repeats values of an object under their former keys. renamed: pairs {present key, former key}; the object has all
// present keys.
void addFormerKeys(nlohmann::ordered_json& object, std::initializer_list<std::pair<const char*, const char*>> renamed);

// Formats JSON with an indent of two spaces and a final line feed. Bytes that are not UTF-8 become replacement
// characters.
std::string textOf(const nlohmann::ordered_json& json);

}  // namespace handwheel
