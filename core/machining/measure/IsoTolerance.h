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

// Returns the width (mm) of a standard tolerance grade of ISO 286-1 for a nominal size, mm: IT5 to IT12, sizes above 0
// and up to kLargestToleratedSize; nothing for others.
std::optional<double> standardTolerance(double nominal, int grade);

// Returns the deviations of a tolerance class of ISO 286-2: "h10", "H7", "js9", "f7". A grade alone, "IT10", gives the
// width of the tolerance but not its position: half of it is taken on both sides, like js10. Shafts d, e, f, g, h, js,
// k, m, n, p; holes D, E, F, G, H, JS, which mirror the shafts without a correction. Returns nothing for other classes
// and sizes, which need explicit limits.
std::optional<SizeDeviations> isoDeviations(double nominal, std::string_view toleranceClass);

}  // namespace handwheel
