// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The codes of errors of meshes.
namespace handwheel::MeshError {

extern const ErrorDescription NoTriangles;  // only points or curves, or nothing at all

}  // namespace handwheel::MeshError
