// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads an OBJ file. Vertices and polygons are read; the content of all other statements is listed as lost. A face may
// use vertices that follow later.
Result<MeshFile> readObj(std::string_view bytes, const ReadOptions& options, Progress progress);

// Returns true if bytes begin with a statement of OBJ files.
bool looksLikeObj(std::string_view bytes);

}  // namespace handwheel
