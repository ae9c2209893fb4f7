// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Returns the syntax of "handwheel split", which writes each shell to its own file.
CommandSpec splitSpec();
int runSplit(const Arguments& arguments, const DocumentKinds& kinds);
// Returns the syntax of "handwheel merge", which writes several meshes to one file.
CommandSpec mergeSpec();
int runMerge(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
