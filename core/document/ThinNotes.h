// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Note.h"
#include "volume/repair/ThinParts.h"

#include <vector>

namespace handwheel {

// Returns notes on walls and gaps that the voxels do not resolve, if any.
std::vector<Note> notesOnThinParts(const ThinFigures& walls, const ThinFigures& gaps);

}  // namespace handwheel
