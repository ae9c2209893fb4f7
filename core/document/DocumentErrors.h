// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of opening and saving documents of any kind.
namespace handwheel::DocumentError {

extern const ErrorDescription
    FormatUnknown;  // {ending...} content and name match no format; the endings are those that are read
extern const ErrorDescription
    ExtensionUnknown;  // {extension, ending...} no writer for the extension; the endings are those that are written
extern const ErrorDescription KindUnknown;     // {kind} a kind of document that this program does not know
extern const ErrorDescription ChangedOnDisk;   // another program wrote the file since it was read
extern const ErrorDescription OpenElsewhere;   // another open document has the target file
extern const ErrorDescription ReplacesLinked;  // the document is linked to the target file
extern const ErrorDescription CheckFailed;     // {difference} the written file does not read back as the document

}  // namespace handwheel::DocumentError
