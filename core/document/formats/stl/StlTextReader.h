// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads a text STL file. Any number of solids in one file; keywords in any case; a name is the text after "solid".
Result<MeshFile> readTextStl(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
