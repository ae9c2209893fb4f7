// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// The format of a file, by its content; by its name where the content does not tell.
// Errors: FileEmpty, TextEncoding, FormatUnknown.
Result<MeshFormat> detectFormat(std::string_view bytes, std::string_view name);

}  // namespace handwheel
