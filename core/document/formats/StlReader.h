// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Whether the size is exactly what the count of a binary STL says; then nothing else can be meant.
bool isWholeBinaryStl(std::string_view bytes);

// Whether this is STL as text: binary files may begin with "solid" too.
bool isTextStl(std::string_view bytes);

// Every facet brings three points of its own. Binary unless isTextStl().
Result<MeshFile> readStl(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
