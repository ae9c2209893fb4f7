// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "machining/TurnedSurface.h"

namespace handwheel {

// The group of the parts that show a stock, cut or not: a change of the whole is never shown half done.
inline constexpr const char* kStockGroup = "stock";

// A turned part as displayed parts, one for each block of triangles: what did not change is not built anew. base: mm, z
// of the lower end.
DisplayModel displayOf(const TurnedSurface& surface, double base);

}  // namespace handwheel
