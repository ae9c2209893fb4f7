// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// The image data in the header of a DICOM file. Data about the patient are not read.
struct DicomSlice {
  std::string_view bytes;  // content of the file
  std::string series;      // unique identifier of the series
  std::array<int, 3> size{0, 0, 0};
  Vec3 spacing = Vec3::Ones();  // mm; the third is the distance of frames, or the thickness of the slice
  Vec3 origin = Vec3::Zero();   // centre of the first pixel, mm
  Vec3 across = Vec3::UnitX(), down = Vec3::UnitY();  // unit vectors along rows and columns

  Vec3 normal() const { return across.cross(down); }
  // Returns the position of the slice along its normal, mm.
  double height() const { return normal().dot(origin); }
  // Returns true if the two slices can be slices of one image.
  bool belongsWith(const DicomSlice& other) const;
};

// Returns the slice in a file, or nothing if the file is not a grey image of a supported size.
std::optional<DicomSlice> sliceOf(std::string_view file);

// Returns the values of all frames of a slice, rescaled by slope · number + intercept. Returns nothing if the pixels
// cannot be unpacked.
std::optional<std::vector<float>> valuesOf(const DicomSlice& slice);

}  // namespace handwheel
