// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace handwheel {

// The limits of a size as deviations from its nominal value, mm.
struct SizeDeviations {
  double lower = 0.0, upper = 0.0;
  double width() const { return upper - lower; }
  bool operator==(const SizeDeviations&) const = default;
};

// Largest nominal size of the tables, mm.
inline constexpr double kLargestToleratedSize = 120.0;

// Returns the width (mm) of a standard tolerance grade of ISO 286-1 for a nominal size (mm). The grades are IT5 to
// IT12; the sizes are above 0 and up to kLargestToleratedSize. Returns nothing for other grades and sizes.
std::optional<double> standardTolerance(double nominal, int grade);

// Returns the deviations of a tolerance class of ISO 286-2, for example "h10", "H7", "js9" or "f7". A grade alone, such
// as "IT10", gives the width of the tolerance but not its position; half of the width is taken on each side, like js10.
// The classes are d, e, f, g, h, js, k, m, n and p for shafts, and D, E, F, G, H and JS, which mirror the shafts
// without a correction, for holes. Returns nothing for other classes and sizes, which need explicit limits.
std::optional<SizeDeviations> isoDeviations(double nominal, std::string_view toleranceClass);

}  // namespace handwheel
