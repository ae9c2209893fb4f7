// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image in NRRD, attached or detached. The format is defined at teem.sourceforge.net/nrrd/format.html,
// versions 1 to 5; encodings raw, gzip and text (hex and bzip2 are refused). Axes may have space directions or
// spacings; with a named space, coordinates are converted to those of ImageGrid. With more than three axes, or a first
// axis of vector components, the first image is read. A header has at most a megabyte. Errors: HeaderMalformed,
// ElementMalformed {field, what is wrong}, Unsupported, those of imageOfBytes(), inflated(), and of the sibling.
Result<ImageFile> readNrrd(std::string_view bytes, const SiblingFile& sibling);

// Returns true if the first bytes are those of such a file.
bool looksLikeNrrd(std::string_view bytes);

}  // namespace handwheel
