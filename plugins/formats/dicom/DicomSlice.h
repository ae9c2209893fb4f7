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

// What the header of a DICOM file says of its image. Nothing of the patient is read.
struct DicomSlice {
  std::string_view bytes;  // of the file
  std::string series;      // its number
  std::array<int, 3> size{0, 0, 0};
  Vec3 spacing = Vec3::Ones();                        // mm; the third: of frames, or the thickness
  Vec3 origin = Vec3::Zero();                         // of the first pixel, mm
  Vec3 across = Vec3::UnitX(), down = Vec3::UnitY();  // of length 1, along rows and columns

  Vec3 normal() const { return across.cross(down); }
  // The place along the normal, mm.
  double height() const { return normal().dot(origin); }
  // Whether both can be slices of one image.
  bool belongsWith(const DicomSlice& other) const;
};

// None where it is no image in grey of a size that can be read.
std::optional<DicomSlice> sliceOf(std::string_view file);

// The values of a slice, all frames, rescaled: slope times the number, and the intercept. None where they cannot be
// unpacked.
std::optional<std::vector<float>> valuesOf(const DicomSlice& slice);

}  // namespace handwheel
