// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

inline constexpr const char* kStepLibrary = "Open CASCADE";

// Reads the mesh in the output of plugins/formats/step, which is untrusted. Errors: LibraryFailed if the output is
// inconsistent; CountMismatch if parts or faces are missing (listed as damage instead if options.partial is set);
// OutOfMemory, Cancelled.
Result<MeshFile> meshIn(std::string_view answer, const ReadOptions& options, Progress progress);

}  // namespace handwheel
