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
  std::string state;  // state of the surface in words
  std::size_t triangles = 0;
  // Largest distances of the original from the result, mm: over 99 % of its area, and over its points.
  double near99 = 0.0, farthest = 0.0;
  double seconds = 0.0;
};

// A row of the table that compares the repair methods (He 2008, table 4-2).
struct MethodRow {
  // method: "triangles" or "volume"; empty: the file was not repaired at all.
  std::string file, method;
  std::optional<MethodFigures> figures;  // none: the method has no result
  std::string reason;                    // the reason for no result, or a reason against this result; a sentence
  bool isWritten = false;
};

// Returns the table with aligned columns, for a terminal.
std::string alignedText(const std::vector<MethodRow>& rows);
// Return the table as comma-separated values with a header, and as an HTML page.
std::string csvText(const std::vector<MethodRow>& rows);
std::string htmlText(const std::vector<MethodRow>& rows);

}  // namespace handwheel
