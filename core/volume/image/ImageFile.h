// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "volume/image/ImageVolume.h"

#include <bit>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A remark about the reading of an image. Braces below enclose the figures of a remark.
struct ImageRemark {
  enum class Kind {
    NoSpacing,       // the file does not state the spacing, which is set to 1 mm
    NotNumbers,      // {samples}: they are not numbers, and are set to the least value
    FirstOfSeveral,  // {values per sample, or images}: only the first is read
    Tilted,          // {degrees}: the slices are sheared against their normal
    Uneven,          // {mm, mm, mm}: least and largest distance of slices, and that of the slices made of them
    SpacingAssumed,  // {mm}: distance of slices whose positions are not stated; their order may be the reverse
    SlicesMissing,   // {slices, mm}: they are missing where a distance is a multiple of the usual one; interpolated.
                     // The largest distance
    OtherSeries,     // {slices}: they belong to other series in the folder, and are not read
    SamePosition,    // {slices}: they are not read, as other slices are at the same positions
    Overlap,         // {samples}: they belong to several labels, and get the last of these
    Contradiction,   // the file states two different positions or orientations; the sform is used
    NotReadable,     // {files}: they begin like those of the series, but cannot be read
  };
  Kind kind;
  std::vector<double> figures = {};
};

// An image that was read from a file.
struct ImageFile {
  ImageVolume image;
  std::vector<ImageRemark> remarks;
  std::string content = {};             // meaning of the values; empty: the file does not state it
  bool hasLabels = false;               // true: the file states that its values are labels
  std::vector<ImageLabel> labels = {};  // labels that the file names
};

// Function that reads at most `most` bytes of the file with this name, in the folder of the file that refers to it.
// Returns the errors of reading files.
using SiblingFile = std::function<Result<std::string>(const std::string& name, std::size_t most)>;

// The type of samples in a file.
enum class SampleType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };
std::size_t bytesOf(SampleType type);

// The layout of samples in a file.
struct SampleLayout {
  SampleType type = SampleType::Int16;
  std::endian order = std::endian::little;
  double slope = 1.0;  // value = slope · number + intercept
  double intercept = 0.0;
  std::size_t perSample = 1;  // number of interleaved numbers per sample; only the first is used
};

// Makes an image of the samples in these bytes; excess bytes are ignored. The image has 16 bits per sample if they can
// hold all values, or else single precision. Values that are not finite are set to the least one, with a remark.
// Errors: DataTruncated, ElementMalformed (if the slope is not finite), and the errors of checkGrid().
Result<ImageFile> imageOfBytes(const ImageGrid& grid, const SampleLayout& layout, std::string_view bytes);
// Makes an image of numbers as text, separated by blanks. Errors: NumberMalformed, and the errors of imageOfBytes().
Result<ImageFile> imageOfText(const ImageGrid& grid, const SampleLayout& layout, std::string_view text);

// Returns true if 16-bit integers can represent all values.
bool areShort(const std::vector<float>& values);
// Makes an image of values. checkGrid() must accept the grid, and there must be one value for each sample. No errors
// occur.
ImageFile imageOfValues(const ImageGrid& grid, std::vector<float> values);

// Returns the number of bytes that the samples of an image take in a file.
std::size_t bytesOf(const ImageGrid& grid, const SampleLayout& layout);

}  // namespace handwheel
