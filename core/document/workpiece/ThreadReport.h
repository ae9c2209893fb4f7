// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// Returns the threads of a part as text, by pitch and Z range. Example: "pitch 2.5 mm, Z 10 to 40; …".
// The range is that of the groove in the material, without the approach and the runout of the tool.
std::string threadsText(const TurnedPart& part);

// Returns the threads as an array of objects with "from", "to" (mm above the lower end, as in threadsText()), "pitch",
// "starts", "hand", "inner", and the values that gauges would measure: "measured_pitch", "major_diameter",
// "pitch_diameter", "minor_diameter" (null if not found).
nlohmann::json threadsJson(const TurnedPart& part);

}  // namespace handwheel
