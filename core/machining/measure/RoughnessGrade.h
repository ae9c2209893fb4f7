// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// Returns the roughness Ra (µm) of a grade number of ISO 1302:1992. The grade numbers are "N1" to "N12". Returns
// nothing for other texts.
std::optional<double> roughnessOf(std::string_view grade);

// Returns the finest grade that a surface of this roughness Ra (µm) meets, for example "N7" for 1.3. The result is
// empty if the surface meets no grade.
std::string roughnessGrade(double ra);

// Returns the roughness Ra (µm) that a nose of this radius (mm) leaves at a feed (mm per revolution), from the geometry
// alone. It is f²/(32 R), as in handbooks, for cusps that are f²/(8 R) high. The exact value for parabolas is f²/(18 √3
// R), 3 % more. The result is 0 if there is no feed, and infinite if the feed is wider than the nose.
double idealRoughness(double feed, double noseRadius);

// Returns the roughness Ra (µm) of the wall that a twist drill leaves at a feed (mm per revolution). The margins of the
// drill rub, so the geometry does not determine the roughness. A power of the feed maps the feeds of twist drills, 0.05
// to 0.38 mm, to the usual range of drilling, 1.6 to 6.3 µm, and the result is clamped to that range. The range is from
// the table of roughness by production method at meadinfo.org/2009/06/surface-finish-roughness-ra.html;
// firstratemold.com/define-surface-roughness gives 3.2 to 12.7 µm. The result is 0 if there is no feed. The feeds,
// quoted from memory of Machinery's Handbook, and the power are not verified.
double drilledRoughness(double feed);

}  // namespace handwheel
