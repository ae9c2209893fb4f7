// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image in ITK's MetaImage format (itk.org/Wiki/MetaIO/Documentation). A .mha file contains the samples after
// its header; the header of a .mhd file names another file that contains them. The samples may be compressed with zlib.
// Offset, TransformMatrix and ElementSpacing are in the coordinates of ITK, which are those of ImageGrid. Errors:
// HeaderMalformed, ElementMalformed {field, what is wrong}, Unsupported, those of imageOfBytes(), inflated(), and of
// the sibling.
Result<ImageFile> readMetaImage(std::string_view bytes, const SiblingFile& sibling);

// Returns true if the first bytes are those of such a file.
bool looksLikeMetaImage(std::string_view bytes);

}  // namespace handwheel
