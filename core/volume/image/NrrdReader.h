// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image in NRRD, attached or detached. The format is defined at teem.sourceforge.net/nrrd/format.html,
// versions 1 to 5; encodings raw, gzip and text (hex and bzip2 are refused). Axes may have space directions or
// spacings; with a space that is named, places are turned to those of ImageGrid. Further axes than three, and one of a
// vector's parts first, give the first image. Lines of a header to a megabyte.
// Errors: HeaderMalformed, ElementMalformed {field, what is wrong}, Unsupported, those of imageOfBytes(), inflated(),
// and of the sibling.
Result<ImageFile> readNrrd(std::string_view bytes, const SiblingFile& sibling);

// Whether the first bytes are those of such a file.
bool looksLikeNrrd(std::string_view bytes);

}  // namespace handwheel
