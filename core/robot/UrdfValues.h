// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"
#include "xml/Xml.h"

#include <span>

namespace handwheel {

// Reads a numeric attribute of a URDF element. Returns the fallback if the attribute is missing. The functions in this
// header have the errors NumberMalformed, NumberNotFinite, CountMismatch and ValueOutOfRange, with the line.

Result<double> readNumber(const XmlElement& element, std::string_view attribute, double fallback);
// Reads an attribute of several numbers. The numbers stay unchanged if the attribute is missing.
Status readNumbers(const XmlElement& element, std::string_view attribute, std::span<double> numbers);
Result<Vec3> readVector(const XmlElement& element, std::string_view attribute, const Vec3& fallback);

// Reads the child "origin" of an element as a pose, in mm. Returns the identity if there is no such child. Roll, pitch
// and yaw are rotations about the fixed axes x, y and z.
Result<Pose> readOrigin(const XmlElement& element);

// Limit of the lengths in a description, m. It keeps sums and products of lengths finite.
inline constexpr double kLargestLength = 1e6;
inline constexpr double kMillimetresPerMetre = 1000.0;

}  // namespace handwheel
