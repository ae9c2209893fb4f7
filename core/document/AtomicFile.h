// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <filesystem>
#include <string_view>

namespace handwheel {

// Replaces a file's content atomically and durably: temporary file beside it, fsync, rename, fsync of the folder. A
// symbolic link stays and its target is replaced. Looks at the cancel flag between blocks of 1 MiB; a cancelled or
// failed write leaves nothing behind. Errors: WriteFailed {system's reason}, Cancelled.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes, Progress progress = {});

// Whether one is being written now: a program that ended itself here would leave a temporary file. Once its progress is
// cancelled none begins. Any thread.
bool isWritingFile();

}  // namespace handwheel
