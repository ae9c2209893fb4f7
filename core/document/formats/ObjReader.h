// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads an OBJ file. Polygons are read; the content of all other statements is listed as lost. A face may use vertices
// that come later.
Result<MeshFile> readObj(std::string_view bytes, const ReadOptions& options, Progress progress);

// Returns true if the first statement is one that OBJ files begin with.
bool looksLikeObj(std::string_view bytes);

}  // namespace handwheel
