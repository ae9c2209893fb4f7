// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PlanComparison.h"

#include <nlohmann/json.hpp>

namespace handwheel {

// Returns compared paths as a report. names: the names of the critical configurations. The keys of a path are critical,
// optimised and solved. A solved path also has the keys of PathReport.h, seconds and checks; an unsolved path also has
// the key reason.
nlohmann::ordered_json toJson(const CellScene& scene, std::span<const ComparedPath> paths,
                              std::span<const std::string> names);
// Returns compared paths as a table. names: the names of the critical configurations.
std::string comparisonText(std::span<const ComparedPath> paths, std::span<const std::string> names);

}  // namespace handwheel
