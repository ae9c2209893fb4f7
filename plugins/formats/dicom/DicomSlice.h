// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"
#include "volume/image/ImageVolume.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// The meaning of the pixels in a segmentation.
struct DicomLabels {
  // Bits and Fractions: pixels belong to the segment of their frame, or by a part. Values: they are numbers of
  // segments.
  enum class Kind { Bits, Fractions, Values };
  Kind kind = Kind::Bits;
  double least = 1.0;              // least value of a pixel in the segment of its frame
  double background = 0.0;         // number without a segment, among values
  std::vector<ImageLabel> labels;  // numbers and names of the segments
};

// A slice: the image of a DICOM file, or one of its frames. Data about the patient are not read.
struct DicomSlice {
  std::string_view bytes;               // content of the file
  std::size_t frame = 0, frames = 1;    // index of the frame, and number of frames in the file
  std::string series;                   // unique identifier of the series
  std::array<int, 2> size{0, 0};        // pixels along rows and columns
  std::array<double, 2> spacing{1, 1};  // distance of pixels along rows and columns, mm
  bool hasSpacing = true;               // false: the file does not state the distance of pixels
  bool hasPosition = true;              // false: the position is not known, or is that of the first frame of the file
  double stated = 0.0;                  // stated distance of slices, mm; 0: not stated
  double apart = 0.0;  // stated distance to the next slice along the normal, or thickness, mm; below 0: against it
  std::optional<double> location;                     // position along the normal from an unknown point, mm
  double number = 0.0;                                // order of slices without positions
  std::shared_ptr<const DicomLabels> labels;          // labels of a segmentation; null: an image
  double segment = 0.0;                               // number of the segment of a frame
  bool isOfBits = false;                              // true: each pixel is one bit
  std::array<double, 3> moment{0, 0, 0};              // order of slices at one position
  std::optional<std::array<double, 2>> padding;       // least and largest number of pixels without a value
  double slope = 1.0, intercept = 0.0;                // value = slope · number + intercept
  Vec3 origin = Vec3::Zero();                         // centre of the first pixel, mm
  Vec3 across = Vec3::UnitX(), down = Vec3::UnitY();  // unit vectors along rows and columns

  Vec3 normal() const { return across.cross(down); }
  // Returns the position of the slice along its normal, mm.
  double height() const { return normal().dot(origin); }
  // Returns true if the two slices can be slices of one image.
  bool belongsWith(const DicomSlice& other) const;
};

// Returns the slices in a file: one for each frame with a usable position. Returns nothing if the file is not a grey
// image of a supported size.
std::vector<DicomSlice> slicesOf(std::string_view file);

// Unpacks the pixels of slices. Keeps those of the last file, so slices of one file should follow each other.
class SlicePixels {
 public:
  // Returns the values of a slice, rescaled by its slope and intercept. Pixels without a value get the least value of
  // the others. Returns nothing if the pixels cannot be unpacked.
  std::optional<std::vector<float>> valuesOf(const DicomSlice& slice);

 private:
  bool unpack(const DicomSlice& slice);
  bool unpackBits(const DicomSlice& slice);

  const char* m_file = nullptr;
  std::vector<char> m_pixels;
  int m_bytes = 0, m_stored = 0, m_shift = 0;  // bytes of a pixel, and its used bits
  bool m_isSigned = false;
};

}  // namespace handwheel
