// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/TurningPass.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace handwheel {

// The passes that the description of an exercise lists under "passes", at this speed (r/min), to be cut from this bar.
// Error: ElementMalformed, also where cutting them would visit more than kMostCutAgain samples.
Result<std::vector<TurningPass>> describedPasses(const nlohmann::json& description, double spindleSpeed,
                                                 const TurnedProfile& bar);

}  // namespace handwheel
