// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

#include <span>

namespace handwheel {

// Returns the descriptions of all changes of a mesh, in the order of help pages. Each change is also a script step
// (MeshScript.h).
std::span<const Operation> meshOperations();

// Returns the operation with this present or former verb, or null if there is none.
const Operation* findMeshOperation(std::string_view verb);
// Returns the operation with this verb, which must exist.
const Operation& meshOperation(std::string_view verb);

}  // namespace handwheel
