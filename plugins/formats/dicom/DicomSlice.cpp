// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom/DicomSlice.h"

#include <gdcmImageHelper.h>
#include <gdcmImageReader.h>
#include <algorithm>
#include <cmath>
#include <istream>
#include <streambuf>

namespace handwheel {

namespace {

constexpr double kAlike = 1e-4;  // tolerance of directions, and of spacings in mm, for rounding

// Reads from memory without a copy, with random access.
class SliceBuffer : public std::streambuf {
 public:
  explicit SliceBuffer(std::string_view bytes) {
    char* const begin = const_cast<char*>(bytes.data());  // never written to
    setg(begin, begin, begin + bytes.size());
  }

 protected:
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
    const off_type base = from == std::ios_base::beg   ? 0
                          : from == std::ios_base::cur ? gptr() - eback()
                                                       : egptr() - eback();
    const off_type to = base + offset;
    if (to < 0 || to > egptr() - eback()) return pos_type(off_type(-1));
    setg(eback(), eback() + to, egptr());
    return pos_type(to);
  }
  pos_type seekpos(pos_type to, std::ios_base::openmode mode) override {
    return seekoff(off_type(to), std::ios_base::beg, mode);
  }
};

std::string seriesOf(const gdcm::DataSet& data) {
  const gdcm::Tag tag(0x0020, 0x000e);
  if (!data.FindDataElement(tag)) return {};
  const gdcm::ByteValue* const value = data.GetDataElement(tag).GetByteValue();
  if (!value || value->GetLength() > 64) return {};
  std::string text(value->GetPointer(), value->GetLength());
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
  return text;
}

bool isGrey(const gdcm::PixelFormat& format, const gdcm::PhotometricInterpretation& meaning) {
  return format.GetSamplesPerPixel() == 1 &&
         (format.GetBitsAllocated() == 8 || format.GetBitsAllocated() == 16 || format.GetBitsAllocated() == 32) &&
         (meaning == gdcm::PhotometricInterpretation::MONOCHROME1 ||
          meaning == gdcm::PhotometricInterpretation::MONOCHROME2);
}

// Converts the used bits of the samples to signed or unsigned numbers, and rescales them.
template <class Word>
void putValues(const std::vector<char>& buffer, const gdcm::PixelFormat& format, double slope, double intercept,
               std::vector<float>& values) {
  const int stored = std::clamp<int>(format.GetBitsStored(), 1, 8 * sizeof(Word));
  const int shift = std::clamp<int>(format.GetHighBit() + 1 - stored, 0, 8 * static_cast<int>(sizeof(Word)) - stored);
  const std::uint64_t mask = (std::uint64_t{1} << stored) - 1, sign = std::uint64_t{1} << (stored - 1);
  const bool isSigned = format.GetPixelRepresentation() != 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Word word;
    std::copy_n(buffer.data() + i * sizeof(Word), sizeof(Word), reinterpret_cast<char*>(&word));
    const std::uint64_t bits = word >> shift & mask;
    const double number = isSigned && (bits & sign) != 0 ? static_cast<double>(bits) - std::ldexp(1.0, stored)
                                                         : static_cast<double>(bits);
    values[i] = static_cast<float>(slope * number + intercept);
  }
}

}  // namespace

bool DicomSlice::belongsWith(const DicomSlice& other) const {
  return series == other.series && size == other.size && (across - other.across).norm() < 10 * kAlike &&
         (down - other.down).norm() < 10 * kAlike && std::abs(spacing.x() - other.spacing.x()) < kAlike &&
         std::abs(spacing.y() - other.spacing.y()) < kAlike;
}

std::optional<DicomSlice> sliceOf(std::string_view file) {
  SliceBuffer buffer(file);
  std::istream stream(&buffer);
  gdcm::Reader reader;
  reader.SetStream(stream);
  if (!reader.ReadUpToTag(gdcm::Tag(0x7fe0, 0x0010))) return {};
  const gdcm::File& header = reader.GetFile();
  const gdcm::PixelFormat format = gdcm::ImageHelper::GetPixelFormatValue(header);
  if (!isGrey(format, gdcm::ImageHelper::GetPhotometricInterpretationValue(header))) return {};
  const std::vector<unsigned int> size = gdcm::ImageHelper::GetDimensionsValue(header);
  const std::vector<double> spacing = gdcm::ImageHelper::GetSpacingValue(header),
                            origin = gdcm::ImageHelper::GetOriginValue(header),
                            turn = gdcm::ImageHelper::GetDirectionCosinesValue(header);
  if (size.size() < 2 || spacing.size() < 2 || origin.size() < 3 || turn.size() < 6) return {};
  DicomSlice slice;
  slice.bytes = file;
  slice.series = seriesOf(header.GetDataSet());
  constexpr unsigned int kMost = 1 << 16;
  for (std::size_t k = 0; k < 3; ++k) {
    const unsigned int n = k < size.size() ? size[k] : 1;
    if (n < 1 || n > kMost) return {};
    slice.size[k] = static_cast<int>(n);
    if (k < spacing.size() && spacing[k] > 0.0) slice.spacing[static_cast<Eigen::Index>(k)] = spacing[k];
  }
  slice.origin = Vec3(origin[0], origin[1], origin[2]);
  slice.across = Vec3(turn[0], turn[1], turn[2]);
  slice.down = Vec3(turn[3], turn[4], turn[5]);
  const bool isSquare = std::abs(slice.across.norm() - 1.0) < 0.01 && std::abs(slice.down.norm() - 1.0) < 0.01 &&
                        std::abs(slice.across.dot(slice.down)) < 0.01;
  if (!isSquare || !slice.origin.allFinite() || !slice.spacing.allFinite()) return {};
  return slice;
}

std::optional<std::vector<float>> valuesOf(const DicomSlice& slice) {
  SliceBuffer buffer(slice.bytes);
  std::istream stream(&buffer);
  gdcm::ImageReader reader;
  reader.SetStream(stream);
  if (!reader.Read()) return {};
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  if (!isGrey(format, image.GetPhotometricInterpretation())) return {};
  std::size_t count = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const unsigned int n = k < image.GetNumberOfDimensions() ? image.GetDimension(static_cast<unsigned int>(k)) : 1;
    if (n != static_cast<unsigned int>(slice.size[k])) return {};
    count *= n;
  }
  const std::size_t bytes = format.GetBitsAllocated() / 8u;
  if (image.GetBufferLength() < count * bytes) return {};
  std::vector<char> pixels(image.GetBufferLength());
  if (!image.GetBuffer(pixels.data())) return {};
  std::vector<float> values(count);
  if (bytes == 1) putValues<std::uint8_t>(pixels, format, image.GetSlope(), image.GetIntercept(), values);
  if (bytes == 2) putValues<std::uint16_t>(pixels, format, image.GetSlope(), image.GetIntercept(), values);
  if (bytes == 4) putValues<std::uint32_t>(pixels, format, image.GetSlope(), image.GetIntercept(), values);
  return values;
}

}  // namespace handwheel
