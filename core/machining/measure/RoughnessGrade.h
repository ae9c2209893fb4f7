// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// The roughness Ra (µm) of a grade number of ISO 1302:1992, "N1" to "N12". None for other texts.
std::optional<double> roughnessOf(std::string_view grade);

// The finest grade that a surface of this roughness Ra (µm) meets: "N7" for 1.3. Empty when it meets none.
std::string roughnessGrade(double ra);

// The roughness Ra (µm) that a nose of this radius (mm) leaves at a feed (mm per revolution), by the geometry alone:
// f²/(32 R) as handbooks have it, of cusps that are f²/(8 R) high; exactly that of parabolas is f²/(18 √3 R), 3 % more.
// 0 where there is no feed; infinite where the feed is wider than the nose.
double idealRoughness(double feed, double noseRadius);

// The roughness Ra (µm) of the wall that a twist drill leaves at a feed (mm per revolution). Its margins rub, so no
// geometry tells it: this is the usual range of drilling, 1.6 to 6.3 µm (table of roughness by production method,
// meadinfo.org/2009/06/surface-finish-roughness-ra.html; firstratemold.com/define-surface-roughness has 3.2 to 12.7
// µm), laid over feeds of twist drills of 0.05 to 0.38 mm, by a power of the feed, and never beyond its ends. 0 where
// there is no feed. Unverified: the feeds, remembered of Machinery's Handbook, and the power that joins the two ranges.
double drilledRoughness(double feed);

}  // namespace handwheel
