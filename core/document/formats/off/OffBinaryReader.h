// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"
#include "document/formats/off/OffHeader.h"

namespace handwheel {

// Reads a binary OFF file. The body begins after the line end that follows headerEnd. Geomview writes big-endian
// numbers with a colour count after each face; other programs write little-endian numbers or omit the colour counts.
// The variant is recognised by the counts.
Result<MeshFile> readBinaryOff(std::string_view bytes, std::size_t headerEnd, OffKeyword keyword,
                               const ReadOptions& options, Progress progress);

}  // namespace handwheel
