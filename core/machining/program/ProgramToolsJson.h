// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "machining/program/ProgramSetup.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace handwheel {

// Converts a tool table to the JSON of documents. The JSON is [{"number", "tool": id of the body, "nose_radius" (mm),
// "orientation", "offset": [r, z] (mm)}, …], with orientations in the numbers of LinuxCNC.
nlohmann::json toJson(const ProgramTools& tools);
// Reads a tool table from any JSON. A tool that is impossible, or whose body is not one of `bodies`, is left out and
// reported in the damage.
ProgramTools programToolsFrom(const nlohmann::json& json, const LatheTools& bodies, std::vector<Error>& damage);

// Converts a tool post: {"post": "front", "insert": "up"}.
nlohmann::json toJson(const ProgramPost& post);
// Reads a tool post. Words that are not known are added to the damage, and the usual post is returned. Null: the usual
// post.
ProgramPost programPostFrom(const nlohmann::json& json, std::vector<Error>& damage);

}  // namespace handwheel
