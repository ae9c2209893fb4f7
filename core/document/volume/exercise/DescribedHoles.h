// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/exercise/DrillingTask.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Reads the holes in the description of an exercise. Its form is {"holes": [{"points": [[time, depth, beside, across],
// …]}]}. The time is in s, all lengths are in mm. The depth of the tip is measured from the entry along the planned
// path; `beside` and `across` are the distances of the tip from that path along two orthogonal directions, and may be
// omitted. The drill moves straight between points, with its shank along the path. Error: ElementMalformed.
Result<DrilledHoles> describedHoles(const nlohmann::json& description, const DrillingTask& task);

}  // namespace handwheel
