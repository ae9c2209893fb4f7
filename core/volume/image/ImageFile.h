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

// A remark about the reading of an image.
struct ImageRemark {
  enum class Kind {
    NoSpacing,       // the file does not state the spacing: it is 1 mm
    NotNumbers,      // {samples} that are not numbers; they are set to the least value
    FirstOfSeveral,  // {values per sample, or images} the first is read
    Tilted,          // {degrees} the slices are sheared against their normal
    Uneven,          // {mm, mm} least and largest distance of slices; they are resampled
    SlicesMissing,   // {slices} missing, as a distance is a multiple; interpolated from their neighbours
    OtherSeries,     // {slices} of other series in the folder, left out
    SamePosition,    // {slices} left out, as there is another one at the same position
    NotReadable,     // {files} that begin like those of the series and cannot be read
  };
  Kind kind;
  std::vector<double> figures = {};
};

// An image as it was read.
struct ImageFile {
  ImageVolume image;
  std::vector<ImageRemark> remarks;
  std::string content = {};  // meaning of the values, if the file states it
};

// Reads at most `most` bytes of the file with this name, from the folder of the file that refers to it. Errors: those
// of reading files.
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
  std::size_t perSample = 1;  // interleaved numbers per sample; the first is used
};

// Makes an image of the samples in these bytes; excess bytes are ignored. 16-bit if that holds all values, else single
// precision. Values that are not finite are set to the least one, with a remark. Errors: DataTruncated,
// ElementMalformed (for a slope that is not finite), those of checkGrid().
Result<ImageFile> imageOfBytes(const ImageGrid& grid, const SampleLayout& layout, std::string_view bytes);
// Makes an image of numbers as text, separated by blanks. Errors: NumberMalformed, too.
Result<ImageFile> imageOfText(const ImageGrid& grid, const SampleLayout& layout, std::string_view text);

// Returns true if 16 bits hold all values.
bool areShort(const std::vector<float>& values);
// Makes an image of values. Precondition: checkGrid(), and as many values as the grid has samples. Errors: none.
ImageFile imageOfValues(const ImageGrid& grid, std::vector<float> values);

// Returns the number of bytes that the samples of an image take in a file.
std::size_t bytesOf(const ImageGrid& grid, const SampleLayout& layout);

}  // namespace handwheel
