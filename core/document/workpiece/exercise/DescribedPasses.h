// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/TurningPasses.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace handwheel {

// Reads the passes that the description of an exercise lists under "passes". spindleSpeed: the spindle speed of the
// passes, r/min; bar: the bar from which they are to be cut. Error: ElementMalformed, also if cutting them would visit
// more than kMostCutAgain samples.
Result<std::vector<TurningPass>> describedPasses(const nlohmann::json& description, double spindleSpeed,
                                                 const TurnedProfile& bar);

// Returns the description that describedPasses() reads as these passes, except for rounding of their times. Returns
// null if a pass cannot be described, because a tool of the manual lathe cut it or its feed changed during the pass.
nlohmann::json passesDescription(const TurningPasses& passes, double spindleSpeed);

}  // namespace handwheel
