// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads a binary STL file. The file consists of a header of 80 bytes, a count, and 50 bytes per facet, little-endian.
// All facets are read even if the count is too small.
Result<MeshFile> readBinaryStl(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
