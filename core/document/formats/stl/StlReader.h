// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Returns true if the size exactly matches the count of a binary STL. Then it can be nothing else.
bool isWholeBinaryStl(std::string_view bytes);

// Returns true if this is text STL: binary files may begin with "solid" too.
bool isTextStl(std::string_view bytes);

// Reads an STL file, as binary unless isTextStl(). Every facet has three points of its own.
Result<MeshFile> readStl(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
