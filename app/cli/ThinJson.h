// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/repair/ThinParts.h"

#include <nlohmann/json_fwd.hpp>

namespace handwheel {

// Adds the fields thin_walls and thin_gaps to a report. Each is null if there are none.
void addThinParts(nlohmann::ordered_json& report, const ThinFigures& walls, const ThinFigures& gaps);

}  // namespace handwheel
