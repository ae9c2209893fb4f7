// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// The shells of a mesh, each to a file of its own; and several meshes to one file.
CommandSpec splitSpec();
int runSplit(const Arguments& arguments, const DocumentKinds& kinds);
CommandSpec mergeSpec();
int runMerge(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
