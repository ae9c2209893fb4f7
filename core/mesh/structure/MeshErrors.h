// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of meshes.
namespace handwheel::MeshError {

extern const ErrorDescription NoTriangles;  // the data contain only points or curves, or nothing at all

}  // namespace handwheel::MeshError
