// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads a 3MF file. Everything in its build section becomes one list of triangles, in millimetres; a transform that
// mirrors reverses their orientation. Objects lose their names and bounds, materials and colours are lost. Parts of the
// production extension are read. A ZIP archive that unpacks to too much is refused (FileTooLarge).
Result<MeshFile> readThreeMf(std::string_view bytes, const ReadOptions& options, Progress progress);

// Returns true if this is a ZIP archive, but not one of our own documents.
bool looksLikeThreeMf(std::string_view bytes);

}  // namespace handwheel
