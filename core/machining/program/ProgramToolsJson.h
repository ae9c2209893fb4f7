// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "machining/program/ProgramSetup.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace handwheel {

// Returns the table of tools as JSON for a document. [{"number", "tool": id of its body, "nose_radius" (mm),
// "orientation", "offset": [r, z] (mm)}, …], orientations in the numbers of LinuxCNC.
nlohmann::json toJson(const ProgramTools& tools);
// Reads any JSON; an impossible tool, or one whose body is none of these, is added to the damage and left out.
ProgramTools programToolsFrom(const nlohmann::json& json, const LatheTools& bodies, std::vector<Error>& damage);

}  // namespace handwheel
