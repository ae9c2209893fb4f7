// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramWriter.h"

namespace handwheel::test {

// The bar of a bush, 40 mm thick and 100 mm long.
inline constexpr StockCylinder kBushBar{40.0, 100.0, 0.0};

// Returns the passes of the bush as a manual lathe records them. Heights count from the lower end of the bar. The bar
// is drilled with 20 mm down to 45 mm, bored to 23 mm and then to 28 mm, turned to 36 mm outside, and bored to 31 mm at
// the end with a round nose.
inline std::vector<TurningPass> bushPasses() {
  const LatheTools shipped = shippedLatheTools();
  const auto pass = [&](const char* tool, std::vector<ProfilePoint> path) {
    TurningPass made;
    if (tool) made.tool = toolNamed(shipped, tool);
    made.side = made.tool ? made.tool->side : TurningSide::Bore;
    made.path = std::move(path);
    for (std::size_t i = 0; i < made.path.size(); ++i) made.times.push_back(10.0 * static_cast<double>(i));
    return made;
  };
  return {pass("drill-20", {{0, 101}, {0, 45}, {0, 80}}), pass("boring-12", {{11.5, 101}, {11.5, 60}, {11, 60}}),
          pass("right-roughing", {{18, 101}, {18, 50}, {20.5, 50}}),
          pass("boring-12", {{14, 101}, {14, 80}, {13, 80}, {13, 95}}), pass(nullptr, {{14.5, 102}, {14.5, 92}})};
}

}  // namespace handwheel::test
