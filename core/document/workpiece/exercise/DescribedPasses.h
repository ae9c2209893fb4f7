// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/TurningPasses.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace handwheel {

// The passes that the description of an exercise lists under "passes". They are at this speed (r/min), to be cut from
// this bar. Error: ElementMalformed, also where cutting them would visit more than kMostCutAgain samples.
Result<std::vector<TurningPass>> describedPasses(const nlohmann::json& description, double spindleSpeed,
                                                 const TurnedProfile& bar);

// The description that describedPasses() reads as these passes, but for the rounding of their times. Null: it cannot
// hold one of them, which a tool of the lathe cut, or whose feed changed on the way.
nlohmann::json passesDescription(const TurningPasses& passes, double spindleSpeed);

}  // namespace handwheel
