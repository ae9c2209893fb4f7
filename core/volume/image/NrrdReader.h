// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image in NRRD, attached or detached. The format is defined at teem.sourceforge.net/nrrd/format.html.
// Versions 1 to 5 and the encodings raw, gzip and text are supported (hex and bzip2 are refused). Axes may have space
// directions or spacings; with a named space, coordinates are converted to those of ImageGrid. If there are more than
// three axes, or the first axis is of vector components, only the first image is read. A header has at most a megabyte.
// Labels are named by the keys of 3D Slicer (.seg.nrrd); all of their layers are read (LabelLayers.h).
// Errors: HeaderMalformed, ElementMalformed {field, problem}, Unsupported, and the errors of imageOfBytes(), inflated()
// and the sibling function.
Result<ImageFile> readNrrd(std::string_view bytes, const SiblingFile& sibling);

// Returns true if a file that begins with these bytes is in NRRD.
bool looksLikeNrrd(std::string_view bytes);

}  // namespace handwheel
