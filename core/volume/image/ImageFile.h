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

// A remark about how an image was read.
struct ImageRemark {
  enum class Kind {
    NoSpacing,       // the file says no distances of samples: they are 1 mm
    NotNumbers,      // {samples} that are no numbers; they count as the least value
    FirstOfSeveral,  // {values} of each sample, or images: the first is read
    Tilted,          // {degrees} the slices are sheared against their normal
    Uneven,          // {mm, mm} least and largest distance of slices; there are new ones between them
    SlicesMissing,   // {slices} where the distance is a multiple; filled from those beside
    OtherSeries,     // {slices} of other series in the folder, which are left out
    SamePlace,       // {slices} left out, for there is one in the same place
    NotReadable,     // {files} that begin as those of the series and cannot be read
  };
  Kind kind;
  std::vector<double> figures = {};
};

// An image as it was read.
struct ImageFile {
  ImageVolume image;
  std::vector<ImageRemark> remarks;
  std::string content = {};  // what the values are, where a file says so
};

// Reads the file of this name, at most so many bytes of it, from beside the one that names it. Errors: those of reading
// files.
using SiblingFile = std::function<Result<std::string>(const std::string& name, std::size_t most)>;

// The type of samples in a file.
enum class SampleType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };
std::size_t bytesOf(SampleType type);

// How samples lie in a file.
struct SampleLayout {
  SampleType type = SampleType::Int16;
  std::endian order = std::endian::little;
  double slope = 1.0;  // value = slope times the number, and the intercept
  double intercept = 0.0;
  std::size_t perSample = 1;  // numbers of each sample side by side; the first counts
};

// An image of the samples in these bytes, which may be more than it takes. 16-bit where that holds all values, else
// single precision. Values that are not finite count as the least one, and are remarked on.
// Errors: DataTruncated, ElementMalformed (a slope that is not finite), those of checkGrid().
Result<ImageFile> imageOfBytes(const ImageGrid& grid, const SampleLayout& layout, std::string_view bytes);
// The same of numbers as text, separated by blanks. Errors: NumberMalformed, too.
Result<ImageFile> imageOfText(const ImageGrid& grid, const SampleLayout& layout, std::string_view text);

// Whether 16 bits hold all values.
bool areShort(const std::vector<float>& values);
// The same of values. Precondition: checkGrid(), and as many values as the grid has samples. Errors: none.
ImageFile imageOfValues(const ImageGrid& grid, std::vector<float> values);

// The bytes that the samples of an image take in a file.
std::size_t bytesOf(const ImageGrid& grid, const SampleLayout& layout);

}  // namespace handwheel
