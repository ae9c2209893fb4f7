// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/mesh/RepairJob.h"

#include <nlohmann/json.hpp>
#include <string>

namespace handwheel {

// The report of a repair as JSON, which --report writes. The unit is the user's word for the file's lengths; nothing is
// scaled by it.
nlohmann::ordered_json toJson(const RepairRun& run, const RepairRequest& request, const std::string& unit);

// The outcome of a repair as one line of JSON, for programs. "state" is "closed" (and manifold, and oriented) or
// "left-open"; "left" counts the defects that keep the file from being closed, and "reason" describes the first.
std::string outcomeLine(const RepairRun& run, const RepairRequest& request);

// The holes of the input, and how many of them were closed, be it by a patch or by thickening their sheet. The outer
// edges of its sheets are counted apart.
struct HoleCounts {
  std::size_t holes = 0;
  std::size_t filled = 0;
  std::size_t sheetEdges = 0;
  std::size_t closedSheetEdges = 0;
};
HoleCounts countHoles(const RepairReport& repair);

}  // namespace handwheel
