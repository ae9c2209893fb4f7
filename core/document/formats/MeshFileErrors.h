// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The codes of errors of mesh files.
namespace handwheel::MeshFileError {

extern const ErrorDescription NothingReadable;   // damage, and no undamaged triangle
extern const ErrorDescription TextEncoding;      // {encoding} not readable as text
extern const ErrorDescription TokenUnexpected;   // {expected, found}; found is empty at the end of the line or the file
extern const ErrorDescription TypeUnknown;       // {type}
extern const ErrorDescription IndexOutOfRange;   // {index in the file, number of vertices}
extern const ErrorDescription VertexUnreadable;  // {index in the file} a face needs an unreadable vertex
extern const ErrorDescription PolygonTooSmall;   // {corners}
extern const ErrorDescription PolygonTooComplex;  // {corners} cut into triangles as if it were convex

}  // namespace handwheel::MeshFileError
