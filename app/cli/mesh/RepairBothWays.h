// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Repairs one file by triangles and by volume, compares the results and writes one. That is the one by triangles, which
// keeps what it need not change, unless only the other is sound, and has lost nothing. Of several files, or a folder,
// it prints one table, and writes it where --report says so. Returns the exit code.
int runRepairBothWays(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
