// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// The threads of a part as text, by pitch and place. Such as "pitch 2.5 mm, Z 10 to 40; …".
std::string threadsText(const PartThreads& threads);

// An array of objects with "from", "to" (mm above the lower end), "pitch", "starts", "hand", "inner", and what gauges
// find: "measured_pitch", "major_diameter", "pitch_diameter", "minor_diameter" (null where they find none).
nlohmann::json threadsJson(const TurnedPart& part);

}  // namespace handwheel
