// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

#include <string>

namespace handwheel {

// Returns an image as an NRRD file. It is raw, little-endian, in the coordinates of ImageGrid, with its labels.
// content: the meaning of the values in one line, which may be empty.
std::string nrrdOf(const ImageVolume& image, const std::string& content = {});
// Appends an image as an NRRD file to the text `file`.
void appendNrrd(const ImageVolume& image, const std::string& content, std::string& file);

}  // namespace handwheel
