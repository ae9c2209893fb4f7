// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Functions that create the parameters that several operations on meshes share.

// Returns the parameter for a flag that is off by default.
Parameter flagParameter(const char* id, std::string meaning, const char* label = "");
// Returns the parameter for a number of faces, edges or levels; the default is 0.
Parameter countParameter(const char* id, const char* word, std::string meaning, const char* label = "");
// Returns the parameter for a text without a default, such as a list of triangles.
Parameter textParameter(const char* id, const char* word, std::string meaning);
// Returns the parameter for three coordinates in mm, without a default.
Parameter pointParameter(const char* id, std::string meaning);
// Returns the parameter for the thickness of thickened sheets in mm; the default is a thousandth of the diagonal.
Parameter thicknessParameter();
// Returns the parameter for the distance below which vertices count as one, as a fraction of the diagonal. standard:
// the default.
Parameter nearWeldParameter(double standard);

}  // namespace handwheel
