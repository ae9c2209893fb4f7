// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads a binary STL file. 80 bytes of header, a count, 50 bytes per facet, little-endian. A count that is too small
// hides no facet.
Result<MeshFile> readBinaryStl(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
