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

// The image data in the header of a DICOM file. No data about the patient are read.
struct DicomSlice {
  std::string_view bytes;  // content of the file
  std::string series;      // unique identifier of the series
  std::array<int, 3> size{0, 0, 0};
  Vec3 spacing = Vec3::Ones();                        // mm; the third: distance of frames, or the thickness
  Vec3 origin = Vec3::Zero();                         // centre of the first pixel, mm
  Vec3 across = Vec3::UnitX(), down = Vec3::UnitY();  // unit vectors along rows and columns

  Vec3 normal() const { return across.cross(down); }
  // Position along the normal, mm.
  double height() const { return normal().dot(origin); }
  // Returns true if both can be slices of one image.
  bool belongsWith(const DicomSlice& other) const;
};

// Returns the slice in a file; none if it is not a grey image of a supported size.
std::optional<DicomSlice> sliceOf(std::string_view file);

// Returns the values of a slice, all frames, rescaled: slope · number + intercept. None if they cannot be unpacked.
std::optional<std::vector<float>> valuesOf(const DicomSlice& slice);

}  // namespace handwheel
