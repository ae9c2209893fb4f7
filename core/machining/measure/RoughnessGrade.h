// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// Returns the roughness Ra (µm) of a grade number of ISO 1302:1992. Numbers are "N1" to "N12"; other texts give
// nothing.
std::optional<double> roughnessOf(std::string_view grade);

// Returns the finest grade that a surface of this roughness Ra (µm) meets: "N7" for 1.3. Empty if it meets none.
std::string roughnessGrade(double ra);

// Returns the roughness Ra (µm) that a nose of this radius (mm) leaves at a feed (mm per revolution), by the geometry
// alone: f²/(32 R) as in handbooks, for cusps that are f²/(8 R) high; the exact value for parabolas is f²/(18 √3 R), 3
// % more. 0 if there is no feed; infinite if the feed is wider than the nose.
double idealRoughness(double feed, double noseRadius);

// Returns the roughness Ra (µm) of the wall that a twist drill leaves at a feed (mm per revolution). Its margins rub,
// so the geometry does not determine it: this is the usual range of drilling, 1.6 to 6.3 µm (table of roughness by
// production method, meadinfo.org/2009/06/surface-finish-roughness-ra.html; firstratemold.com/define-surface-roughness
// has 3.2 to 12.7 µm), mapped to feeds of twist drills of 0.05 to 0.38 mm, by a power of the feed, and clamped to its
// ends. 0 if there is no feed. Unverified: the feeds, quoted from memory of Machinery's Handbook, and the power that
// joins the two ranges.
double drilledRoughness(double feed);

}  // namespace handwheel
