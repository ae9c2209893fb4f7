// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// Measured values of one method of repair on one file.
struct MethodFigures {
  bool isSound = false;
  std::string state;  // in words
  std::size_t triangles = 0;
  double near99 = 0.0,
         farthest = 0.0;  // mm; distances of the file from the result: of 99 % of its area, and of its points
  double seconds = 0.0;
};

// A row of the table that compares the repair methods (He 2008, table 4-2).
struct MethodRow {
  std::string file, method;              // "triangles", "volume"; empty if the file was not repaired at all
  std::optional<MethodFigures> figures;  // none: it has no result
  std::string reason;                    // the reason for no result, or a reason against this result; a sentence
  bool isWritten = false;
};

// Returns the table with aligned columns, for a terminal.
std::string alignedText(const std::vector<MethodRow>& rows);
// Return the table as comma-separated values with a header, and as a page.
std::string csvText(const std::vector<MethodRow>& rows);
std::string htmlText(const std::vector<MethodRow>& rows);

}  // namespace handwheel
