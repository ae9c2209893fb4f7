// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/exercise/DrillingTask.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// The holes that the description of an exercise lists: {"holes": [{"points": [[time, depth, beside, across], …]}]}.
// Time in s, depth of the tip below the entry along the planned path, and how far it is from that path along two
// directions at right angles to it, mm; the last two may be left out. The drill goes straight from point to point, its
// shank along the path. Error: ElementMalformed.
Result<DrilledHoles> describedHoles(const nlohmann::json& description, const DrillingTask& task);

}  // namespace handwheel
