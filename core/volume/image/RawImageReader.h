// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

namespace handwheel {

// Reads an image of plain samples by its description, a JSON object:
//
//   {"raw": "ct.raw", "size": [512, 512, 300], "spacing": [0.5, 0.5, 1], "type": "int16"}
//
// Where necessary, it also contains "endian": "little" or "big"; "skip": the number of bytes before the first sample;
// "origin": the position of the first sample; "directions": three unit vectors, one for each axis; "slope" and
// "intercept". Lengths are in mm, in the coordinates of ImageGrid. The types are int8 to int64, uint8 to uint64,
// float32 and float64. Errors: ElementMalformed {key, problem}, and the errors of imageOfBytes() and the sibling
// function.
Result<ImageFile> readRawImage(std::string_view description, const SiblingFile& sibling);

// Returns true if a file that begins with these bytes is a description of plain samples: an object with "raw", "size"
// and "type" in its first kilobyte.
bool looksLikeRawImage(std::string_view bytes);

}  // namespace handwheel
