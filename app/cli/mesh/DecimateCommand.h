// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Returns the syntax of "handwheel decimate", which reduces the number of triangles of a mesh.
CommandSpec decimateSpec();
int runDecimate(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
