// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "machining/TurnedSurface.h"

namespace handwheel {

// A turned part as displayed parts, one for each block of triangles: what did not change is not built anew. base: mm, z
// of the lower end.
DisplayModel displayOf(const TurnedSurface& surface, double base);

}  // namespace handwheel
