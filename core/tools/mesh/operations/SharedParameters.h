// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Parameters that several operations on meshes have. Also used by the simple operations that need no file of their own.

// Returns a flag that is off by default.
Parameter flagParameter(const char* id, std::string meaning, const char* label = "");
// Returns a number of faces, edges or levels; the default is 0.
Parameter countParameter(const char* id, const char* word, std::string meaning, const char* label = "");
// Returns a text without a default, such as a list of triangles.
Parameter textParameter(const char* id, const char* word, std::string meaning);
// Returns three coordinates in mm, without a default.
Parameter pointParameter(const char* id, std::string meaning);
// Returns the thickness of thickened sheets in mm; the default is a thousandth of the diagonal.
Parameter thicknessParameter();
// Returns the share of the diagonal below which vertices count as one.
Parameter nearWeldParameter(double standard);

}  // namespace handwheel
