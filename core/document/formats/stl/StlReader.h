// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Returns true if the size exactly matches the count of a binary STL file. The file can then have no other format.
bool isWholeBinaryStl(std::string_view bytes);

// Returns true if bytes are a text STL file. The word "solid" is not sufficient, because binary files may begin with
// it, too.
bool isTextStl(std::string_view bytes);

// Reads an STL file, as binary unless isTextStl(). Every facet gets three points of its own.
Result<MeshFile> readStl(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
