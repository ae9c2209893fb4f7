// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ThinJson.h"

#include <nlohmann/json.hpp>

namespace handwheel {

void addThinParts(nlohmann::ordered_json& report, const ThinFigures& walls, const ThinFigures& gaps) {
  const auto figures = [](const ThinFigures& thin, const std::string& changed) -> nlohmann::ordered_json {
    if (!(thin.area > 0.0)) return nullptr;
    return {{"below_mm", thin.below},
            {"area_mm2", thin.area},
            {"share", thin.share},
            {"least_mm", thin.least},
            {"at_mm", {thin.at.x(), thin.at.y(), thin.at.z()}},
            {changed + "_area_mm2", thin.changedArea},
            {changed + "_share", thin.changedShare}};
  };
  report["thin_walls"] = figures(walls, "lost");
  report["thin_gaps"] = figures(gaps, "filled");
}

}  // namespace handwheel
