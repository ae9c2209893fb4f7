// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of edits of bodies.
namespace handwheel::BodyError {

extern const ErrorDescription BodyMissing;       // {name or number}: the document has no such body
extern const ErrorDescription Ambiguous;         // {text, number}: the name of one body is the number of another
extern const ErrorDescription NotLinked;         // {name}: the body has no file that could be read again
extern const ErrorDescription LinkedFileGone;    // {path}: the file of the link is missing
extern const ErrorDescription TooManyBodies;     // {most}: the document cannot contain more bodies
extern const ErrorDescription TooManyTriangles;  // {count, most}: number of triangles of all bodies
extern const ErrorDescription NameTaken;         // {name}: another body of the document has this name
extern const ErrorDescription NameUnusable;      // {name, most bytes}: empty, too long, or several lines

}  // namespace handwheel::BodyError
