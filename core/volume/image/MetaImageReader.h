// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image of ITK's MetaImage (itk.org/Wiki/MetaIO/Documentation). A file is .mha with the samples behind the
// header, .mhd with them in another file; plain or packed by zlib. Offset, TransformMatrix and ElementSpacing are in
// the coordinates of ITK, which are those of ImageGrid. Errors: HeaderMalformed, ElementMalformed {field, what is
// wrong}, Unsupported, those of imageOfBytes(), inflated(), and of the sibling.
Result<ImageFile> readMetaImage(std::string_view bytes, const SiblingFile& sibling);

// Returns true if the first bytes are those of such a file.
bool looksLikeMetaImage(std::string_view bytes);

}  // namespace handwheel
