// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// What one way of repair made of one file.
struct RepairWayFigures {
  bool isSound = false;
  std::string state;  // in words
  std::size_t triangles = 0;
  double near99 = 0.0, farthest = 0.0;  // mm; of the file from the result: of 99 % of its area, and of its points
  double seconds = 0.0;
};

// A row of the table of both ways of repair (He 2008, table 4-2).
struct RepairWayRow {
  std::string file, way;                    // "triangles", "volume"; empty where the file was not repaired at all
  std::optional<RepairWayFigures> figures;  // none: it has no result
  std::string reason;                       // why not, or what speaks against it; a sentence
  bool isWritten = false;
};

// The table with aligned columns, for a terminal.
std::string alignedText(const std::vector<RepairWayRow>& rows);
// The same as comma-separated values, with a header, and as a page.
std::string csvText(const std::vector<RepairWayRow>& rows);
std::string htmlText(const std::vector<RepairWayRow>& rows);

}  // namespace handwheel
