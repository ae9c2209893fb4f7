// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads a 3MF file. Everything in its build section becomes one list of triangles, in millimetres; a transform that
// mirrors reverses their orientation. The names of objects, the boundaries between them, materials and colours are
// lost. Parts of the production extension are read. A ZIP archive that unpacks to too many bytes is refused
// (FileTooLarge).
Result<MeshFile> readThreeMf(std::string_view bytes, const ReadOptions& options, Progress progress);

// Returns true if bytes are a ZIP archive, but not a container of this program.
bool looksLikeThreeMf(std::string_view bytes);

}  // namespace handwheel
