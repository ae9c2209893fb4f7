// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

#include <span>

namespace handwheel {

// The descriptions of all changes of a mesh, in the order of help pages. Each is a step (MeshScript.h).
std::span<const Operation> meshOperations();

// The one with this verb or former verb; null when there is none.
const Operation* findMeshOperation(std::string_view verb);
// The same where it is known that there is one.
const Operation& meshOperation(std::string_view verb);

}  // namespace handwheel
