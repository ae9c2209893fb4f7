// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/sculpt/SchemeSubdivision.h"

namespace handwheel {

// Return the reason why OpenMesh changed nothing, as in MeshChange::reason; null if it changed something.
const char* reasonOf(OpenMeshRefusal refusal);
const char* reasonOf(const SchemeOutcome& outcome);

}  // namespace handwheel
