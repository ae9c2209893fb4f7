// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Returns true if bytes begin as STEP files do (ISO 10303-21, 5.1).
bool looksLikeStep(std::string_view bytes);

// Reads the surfaces of a STEP file as triangles. They are within options.stepChord of the surfaces, in millimetres.
// Open CASCADE runs in a process of its own, which a hostile file may crash or block. Errors: those of readIsolated()
// and of meshIn().
Result<MeshFile> readStep(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
