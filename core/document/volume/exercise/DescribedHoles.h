// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/exercise/DrillingTask.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Reads the holes in the description of an exercise. Its form is {"holes": [{"points": [[time, depth, beside, across],
// …]}]}. Time in s; depth of the tip below the entry along the planned path, and its distances from that path along two
// orthogonal directions, mm; the last two may be omitted. The drill moves straight between points, with its shank along
// the path. Error: ElementMalformed.
Result<DrilledHoles> describedHoles(const nlohmann::json& description, const DrillingTask& task);

}  // namespace handwheel
