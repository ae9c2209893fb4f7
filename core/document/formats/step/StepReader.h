// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Returns true if bytes begin with the signature of STEP files (ISO 10303-21, 5.1).
bool looksLikeStep(std::string_view bytes);

// Reads the surfaces of a STEP file as triangles, in millimetres. The triangles are within options.stepChord of the
// surfaces. Open CASCADE runs in a process of its own, because a hostile file may crash or block it. Errors: the errors
// of readIsolated() and meshIn().
Result<MeshFile> readStep(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
