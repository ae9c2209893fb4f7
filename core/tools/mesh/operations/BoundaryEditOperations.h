// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/boundary/BoundarySmoothing.h"

namespace handwheel {

// Returns the descriptions of manual changes at open edges (ManualMeshChanges.h).
std::vector<Operation> boundaryEditOperations();

// Convert values to the options of smoothing an open edge, and back.
SmoothingOptions smoothingOptionsOf(const OperationValues& values);
OperationValues valuesOf(const SmoothingOptions& options);

}  // namespace handwheel
