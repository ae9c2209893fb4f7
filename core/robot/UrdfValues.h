// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"
#include "robot/Xml.h"

#include <span>

namespace handwheel {

// Attributes of URDF elements. Missing ones have the fallback; what is there must be right. Errors carry the line:
// NumberMalformed, NumberNotFinite, CountMismatch, ValueOutOfRange.

Result<double> readNumber(const XmlElement& element, std::string_view attribute, double fallback);
// Leaves the numbers as they are when the attribute is missing.
Status readNumbers(const XmlElement& element, std::string_view attribute, std::span<double> numbers);
Result<Vec3> readVector(const XmlElement& element, std::string_view attribute, const Vec3& fallback);

// The element's child "origin", in mm; the identity where there is none. Roll, pitch and yaw turn about fixed x, y, z.
Result<Pose> readOrigin(const XmlElement& element);

// Lengths in a description stay below this; m. It keeps sums and products of them finite.
inline constexpr double kLargestLength = 1e6;
inline constexpr double kMillimetresPerMetre = 1000.0;

}  // namespace handwheel
