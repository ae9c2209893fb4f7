// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of ZIP archives.
namespace handwheel::ArchiveError {

extern const ErrorDescription Malformed;     // {library's reason} not a ZIP archive, or one that cannot be read at all
extern const ErrorDescription EntryMissing;  // {name} an entry that the archive should contain
extern const ErrorDescription EntryDamaged;  // {name} an entry that cannot be unpacked, or differs from its checksum

}  // namespace handwheel::ArchiveError
