// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "tools/mesh/MeshScript.h"

namespace handwheel {

class DocumentKinds;

// Returns the syntax of "handwheel edit", which applies editing steps to a mesh (tools/mesh/MeshScript.h).
CommandSpec editSpec();
// Returns a reader for the meshes that steps name.
MeshFileReader meshFileReader(const DocumentKinds& kinds);
int runEdit(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
