// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

#include <string>

namespace handwheel {

// An image as a file in NRRD: raw, little-endian, with places as ImageGrid has them. content: what the
// values are, one line; may be empty.
std::string nrrdOf(const ImageVolume& image, const std::string& content = {});
// The same at the end of a text.
void appendNrrd(const ImageVolume& image, const std::string& content, std::string& file);

}  // namespace handwheel
