// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

#include <bit>
#include <string_view>

namespace handwheel {

// Returns the labels that the extensions of a NIfTI header name. Programs for segmentation write them as a table in XML
// ("LabelTable" of Caret). extensions: the bytes from the end of the header to the samples. Extensions
// that are malformed name no labels.
std::vector<ImageLabel> labelsInExtensions(std::string_view extensions, std::endian order);

}  // namespace handwheel
