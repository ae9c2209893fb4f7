// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of script steps, the lines of text that edit a mesh.
namespace handwheel::ScriptError {

extern const ErrorDescription Malformed;  // {what is wrong, as a clause in English}

}  // namespace handwheel::ScriptError
