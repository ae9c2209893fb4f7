// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of edits of bodies.
namespace handwheel::BodyError {

extern const ErrorDescription BodyMissing;       // {name or number}: the document has no such body
extern const ErrorDescription Ambiguous;         // {text, number}: the name of that body, and the number of another
extern const ErrorDescription NotLinked;         // {name}: the body has no file to be read again
extern const ErrorDescription LinkedFileGone;    // {path}
extern const ErrorDescription TooManyBodies;     // {most}
extern const ErrorDescription TooManyTriangles;  // {count, most}: of all bodies together
extern const ErrorDescription NameTaken;         // {name}: another body of the document has it
extern const ErrorDescription NameUnusable;      // {name, most bytes}: empty, too long, or of more than one line

}  // namespace handwheel::BodyError
