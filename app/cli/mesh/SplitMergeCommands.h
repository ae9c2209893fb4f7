// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Syntax of "handwheel split", which writes each shell of a mesh to its own file.
CommandSpec splitSpec();
int runSplit(const Arguments& arguments, const DocumentKinds& kinds);
// Syntax of "handwheel merge", which writes several meshes to one file.
CommandSpec mergeSpec();
int runMerge(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
