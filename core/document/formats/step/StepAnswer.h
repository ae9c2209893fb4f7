// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

inline constexpr const char* kStepLibrary = "Open CASCADE";

// Reads the mesh in the output of plugins/formats/step. It is as little trusted as any file. Errors: LibraryFailed
// where it makes no sense; CountMismatch where parts or faces are missing, which are damage where options.partial is
// set; OutOfMemory, Cancelled.
Result<MeshFile> meshIn(std::string_view answer, const ReadOptions& options, Progress progress);

}  // namespace handwheel
