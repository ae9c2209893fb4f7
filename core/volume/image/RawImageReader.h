// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image of plain samples by its description, an object of JSON:
//
//   {"raw": "ct.raw", "size": [512, 512, 300], "spacing": [0.5, 0.5, 1], "type": "int16"}
//
// and, where they are needed: "endian": "little" or "big", "skip": bytes before the first sample, "origin": the
// position of the first sample and "directions": three unit vectors, one for each axis (mm, as ImageGrid), "slope",
// "intercept". Types: int8 to int64, uint8 to uint64, float32, float64. Errors: ElementMalformed {key, what is wrong},
// those of imageOfBytes() and of the sibling.
Result<ImageFile> readRawImage(std::string_view description, const SiblingFile& sibling);

// Returns true if the first bytes are those of such a description: an object with "raw", "size" and "type" in its first
// kilobyte.
bool looksLikeRawImage(std::string_view bytes);

}  // namespace handwheel
