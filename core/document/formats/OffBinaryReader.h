// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"
#include "document/formats/OffHeader.h"

namespace handwheel {

// The body begins behind the line end that follows headerEnd. Geomview writes it big-endian with a colour count behind
// each face; others write little-endian, or leave the colour counts out: the counts tell which it is.
Result<MeshFile> readBinaryOff(std::string_view bytes, std::size_t headerEnd, OffKeyword keyword,
                               const ReadOptions& options, Progress progress);

}  // namespace handwheel
