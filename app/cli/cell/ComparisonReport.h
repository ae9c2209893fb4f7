// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PlanComparison.h"

#include <nlohmann/json.hpp>

namespace handwheel {

// Returns compared paths as a report. names: of the critical configurations. Keys of a path: critical, optimised,
// solved, and if solved those of a planned path.
nlohmann::ordered_json toJson(const CellScene& scene, std::span<const ComparedPath> paths,
                              std::span<const std::string> names);
// Returns the same as a table.
std::string comparisonText(std::span<const ComparedPath> paths, std::span<const std::string> names);

}  // namespace handwheel
