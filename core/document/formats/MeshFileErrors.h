// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of mesh files.
namespace handwheel::MeshFileError {

extern const ErrorDescription NothingReadable;   // the file is damaged and has no undamaged triangle
extern const ErrorDescription TextEncoding;      // {encoding} a text in an encoding that is not read
extern const ErrorDescription TokenUnexpected;   // {expected, found}; found is empty at the end of the line or the file
extern const ErrorDescription TypeUnknown;       // {type}
extern const ErrorDescription IndexOutOfRange;   // {index in the file, number of vertices}
extern const ErrorDescription VertexUnreadable;  // {index in the file} a face needs an unreadable vertex
extern const ErrorDescription PolygonTooSmall;   // {corners}
extern const ErrorDescription PolygonTooComplex;  // {corners} triangulated as if it were convex

}  // namespace handwheel::MeshFileError
