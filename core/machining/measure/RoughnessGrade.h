// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// The roughness Ra (µm) of a grade number of ISO 1302:1992, "N1" to "N12"; none for other texts.
std::optional<double> roughnessOf(std::string_view grade);

// The finest grade that a surface of this roughness Ra (µm) meets: "N7" for 1.3. Empty when it meets none.
std::string roughnessGrade(double ra);

// The roughness Ra (µm) that a nose of this radius (mm) leaves at a feed (mm per revolution), by the geometry alone:
// f²/(32 R) as handbooks have it, of cusps that are f²/(8 R) high; exactly that of parabolas is f²/(18 √3 R), 3 % more.
// 0 where there is no feed; infinite where the feed is wider than the nose.
double idealRoughness(double feed, double noseRadius);

}  // namespace handwheel
