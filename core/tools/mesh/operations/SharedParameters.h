// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Parameters that several operations on meshes have. Also the simple operations that need no more than a sentence.

// A flag that is off unless it is given.
Parameter flagParameter(const char* id, std::string meaning, const char* label = "");
// A number of faces, edges or levels; the default is 0.
Parameter countParameter(const char* id, const char* word, std::string meaning, const char* label = "");
// A text without a default, such as a list of triangles.
Parameter textParameter(const char* id, const char* word, std::string meaning);
// Three coordinates in mm, without a default.
Parameter pointParameter(const char* id, std::string meaning);
// Thickness of thickened sheets in mm; without it a thousandth of the diagonal.
Parameter thicknessParameter();
// Share of the diagonal below which vertices are one.
Parameter nearWeldParameter(double standard);

}  // namespace handwheel
