// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/ArchiveErrors.h"

namespace handwheel {

const ErrorDescription ArchiveError::Malformed{
    .id = "ArchiveMalformed",
    .sentences = {translatable("ErrorText", "the archive cannot be read (%1)")},
    .advice = {translatable("ErrorText", "Copy the file again, or go back to an earlier copy of it.")}};

const ErrorDescription ArchiveError::EntryMissing{
    .id = "EntryMissing",
    .sentences = {translatable("ErrorText", "the part '%1' is missing")},
    .advice = {translatable("ErrorText", "Copy the file again, or go back to an earlier copy of it.")}};

const ErrorDescription ArchiveError::EntryDamaged{
    .id = "EntryDamaged",
    .sentences = {translatable("ErrorText", "the part '%1' is damaged")},
    .advice = {translatable("ErrorText", "Copy the file again, or go back to an earlier copy of it.")}};

}  // namespace handwheel
