// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Repairs a file by triangles and by volume, and compares the results. Writes the result by triangles, which keeps
// everything that need not change, unless only the result by volume is sound and has lost nothing. For several files,
// or a folder, prints one table and writes it to the file of --report. Returns the exit code.
int runRepairComparison(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
