// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom/DicomSlice.h"

#include "dicom/DicomTags.h"

#include <gdcmImageHelper.h>
#include <gdcmImageReader.h>
#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
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

// Returns true if the pixels are values, not colours. Labels may have colours beside.
bool isGrey(const gdcm::PixelFormat& format, const gdcm::PhotometricInterpretation& meaning,
            const DicomLabels* labels) {
  const int bits = format.GetBitsAllocated();
  constexpr int kPacked = 12;  // two pixels in three bytes; GDCM unpacks them to 16 bits
  if (format.GetSamplesPerPixel() != 1) return false;
  if (labels && labels->kind == DicomLabels::Kind::Bits) return bits == 1 || bits == 8;
  return (bits == 8 || bits == kPacked || bits == 16 || bits == 32) &&
         (labels || meaning == gdcm::PhotometricInterpretation::MONOCHROME1 ||
          meaning == gdcm::PhotometricInterpretation::MONOCHROME2);
}

std::optional<Vec3> vectorOf(const std::vector<double>& numbers, std::size_t first, std::size_t count) {
  if (numbers.size() != count) return {};
  return Vec3(numbers[first], numbers[first + 1], numbers[first + 2]);
}

// Reads the values that are the same for all frames.
DicomSlice sliceOfFile(const gdcm::DataSet& data) {
  DicomSlice slice;
  slice.series = textAt(data, {0x0020, 0x000e});
  slice.location = numberAt(data, {0x0020, 0x1041});
  slice.number = numberAt(data, {0x0020, 0x0013}).value_or(0.0);
  slice.moment = {numberAt(data, {0x0020, 0x0100}).value_or(0.0), numberAt(data, {0x0020, 0x0012}).value_or(0.0),
                  slice.number};
  return slice;
}

// Returns the numbers of pixels without a value (PS3.3, C.7.5.1.1.2), such as those outside of the circle of a CT.
std::optional<std::array<double, 2>> paddingOf(const gdcm::DataSet& data, bool isSigned) {
  const auto numberOf = [&](const gdcm::Tag& tag) -> std::optional<double> {
    const auto bits = countAt(data, tag);
    if (!bits) return {};
    constexpr std::uint32_t kMost = 0xffff;
    return isSigned && *bits <= kMost ? static_cast<double>(static_cast<std::int16_t>(*bits))
                                      : static_cast<double>(*bits);
  };
  const auto one = numberOf({0x0028, 0x0120}), limit = numberOf({0x0028, 0x0121});
  if (!one) return {};
  return std::array{std::min(*one, limit.value_or(*one)), std::max(*one, limit.value_or(*one))};
}

// Distances of pixels: in the patient, on the detector, or on the film.
void setSpacing(const FrameTags& tags, std::size_t frame, DicomSlice& slice) {
  const auto spacing = tags.find(frame, {0x0028, 0x9110}, [](const gdcm::DataSet& data, bool) {
    std::optional<std::vector<double>> found;
    for (const gdcm::Tag& tag : {gdcm::Tag(0x0028, 0x0030), gdcm::Tag(0x0018, 0x1164), gdcm::Tag(0x0018, 0x2010)})
      if (std::vector<double> numbers = numbersAt(data, tag); !found && numbers.size() == 2) found = std::move(numbers);
    return found;
  });
  const auto isDistance = [](double mm) { return mm > 0.0; };
  slice.hasSpacing = spacing && std::all_of(spacing->begin(), spacing->end(), isDistance);
  // The first number is the distance of rows, so it is along the columns.
  if (slice.hasSpacing) slice.spacing = {(*spacing)[1], (*spacing)[0]};
  const auto distance = [&](const gdcm::Tag& tag) {
    return tags.find(frame, {0x0028, 0x9110}, [&](const gdcm::DataSet& data, bool) {
      const std::optional<double> mm = numberAt(data, tag);
      return mm && *mm != 0.0 ? mm : std::nullopt;
    });
  };
  slice.stated = std::abs(distance({0x0018, 0x0088}).value_or(0.0));
  slice.apart = distance({0x0018, 0x0088}).value_or(std::abs(distance({0x0018, 0x0050}).value_or(0.0)));
}

void setScale(const FrameTags& tags, std::size_t frame, DicomSlice& slice) {
  const auto scale = tags.find(frame, {0x0028, 0x9145}, [](const gdcm::DataSet& data, bool) {
    const auto slope = numberAt(data, {0x0028, 0x1053}), intercept = numberAt(data, {0x0028, 0x1052}),
               dose = numberAt(data, {0x3004, 0x000e});
    std::optional<std::array<double, 2>> found;
    if (slope && *slope != 0.0) found = {*slope, intercept.value_or(0.0)};
    if (!found && intercept) found = {1.0, *intercept};
    if (!found && dose && *dose != 0.0) found = {*dose, 0.0};
    return found;
  });
  if (!scale) return;
  slice.slope = (*scale)[0];
  slice.intercept = (*scale)[1];
}

// Sets the directions of rows and columns. Returns false if they are not perpendicular unit vectors.
bool setDirections(const FrameTags& tags, std::size_t frame, const gdcm::DataSet* detector, DicomSlice& slice) {
  constexpr std::size_t kCount = 6;
  const gdcm::Tag tag(0x0020, 0x0037);
  std::optional<std::vector<double>> turn =
      tags.find(frame, {0x0020, 0x9116}, [&](const gdcm::DataSet& data, bool) -> std::optional<std::vector<double>> {
        std::vector<double> numbers = numbersAt(data, tag);
        return numbers.size() == kCount ? std::optional(std::move(numbers)) : std::nullopt;
      });
  if (!turn && detector) turn = numbersAt(*detector, tag);
  if (!turn || turn->size() != kCount) return true;
  slice.across = *vectorOf(*turn, 0, kCount);
  slice.down = *vectorOf(*turn, 3, kCount);
  constexpr double kTolerance = 0.01;
  const bool isSquare = std::abs(slice.across.norm() - 1.0) < kTolerance &&
                        std::abs(slice.down.norm() - 1.0) < kTolerance &&
                        std::abs(slice.across.dot(slice.down)) < kTolerance;
  // Written digits are rounded, and the tilt is measured against the normal.
  slice.across.normalize();
  slice.down.normalize();
  return isSquare;
}

// Sets the position: that of the frame, or that of a file with a single frame.
void setPosition(const FrameTags& tags, std::size_t frame, const gdcm::DataSet* detector, DicomSlice& slice) {
  const gdcm::Tag tag(0x0020, 0x0032);
  std::optional<Vec3> position =
      tags.find(frame, {0x0020, 0x9113}, [&](const gdcm::DataSet& data, bool isOwn) -> std::optional<Vec3> {
        const auto found = vectorOf(numbersAt(data, tag), 0, 3);
        if (found) slice.hasPosition = isOwn || slice.frames == 1;
        return found;
      });
  if (!position && detector) {
    position = vectorOf(numbersAt(*detector, tag), 0, 3);
    slice.hasPosition = position && slice.frames == 1;
  }
  if (!position) slice.hasPosition = false;
  slice.origin = position.value_or(Vec3::Zero());
}

// The positions of the frames of a dose: its distances from the first one, along the normal.
void setOffsets(const gdcm::DataSet& data, std::vector<DicomSlice>& slices) {
  const std::vector<double> offsets = numbersAt(data, {0x3004, 0x000c});
  if (slices.size() < 2 || offsets.size() != slices.size() || numbersAt(data, {0x0020, 0x0032}).size() != 3) return;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    slices[i].origin += (offsets[i] - offsets.front()) * slices[i].normal();
    slices[i].hasPosition = true;
  }
}

// Returns the labels of a segmentation (PS3.3, C.8.20); null if the file is none.
std::shared_ptr<const DicomLabels> labelsOf(const gdcm::DataSet& data) {
  const std::string kind = textAt(data, {0x0062, 0x0001});
  auto labels = std::make_shared<DicomLabels>();
  if (kind == "FRACTIONAL")
    labels->kind = DicomLabels::Kind::Fractions;
  else if (kind == "LABELMAP")
    labels->kind = DicomLabels::Kind::Values;
  else if (kind != "BINARY")
    return nullptr;
  constexpr double kWhole = 255.0;
  if (labels->kind == DicomLabels::Kind::Fractions)
    labels->least = 0.5 * countAt(data, {0x0062, 0x000e}).value_or(static_cast<std::uint32_t>(kWhole));
  labels->background = countAt(data, {0x0028, 0x0120}).value_or(0);
  if (const auto segments = itemsAt(data, {0x0062, 0x0002}))
    for (std::size_t i = 1; i <= segments->GetNumberOfItems(); ++i) {
      const gdcm::DataSet& segment = segments->GetItem(i).GetNestedDataSet();
      if (const auto number = countAt(segment, {0x0062, 0x0004}))
        labels->labels.push_back({static_cast<double>(*number), textAt(segment, {0x0062, 0x0005})});
    }
  return labels;
}

// Returns a file of a label map as one of a segmentation by bits. GDCM does not know the former, and reads several
// frames only of kinds that it knows.
std::string withKnownKind(std::string_view file) {
  constexpr std::string_view kMap = "1.2.840.10008.5.1.4.1.1.66.7";
  std::string known(file);
  for (std::size_t at = known.find(kMap); at != std::string::npos; at = known.find(kMap, at))
    known[at + kMap.size() - 1] = '4';
  return known;
}

// Gives pixels without a value the least value of the others.
void clearPadding(const std::vector<std::size_t>& without, std::vector<float>& values) {
  if (without.empty() || without.size() == values.size()) return;
  constexpr float kNone = std::numeric_limits<float>::max();
  for (const std::size_t i : without) values[i] = kNone;
  const float least = *std::min_element(values.begin(), values.end());
  for (const std::size_t i : without) values[i] = least;
}

// Sets the segment of a frame. Returns false if it is not stated.
bool setSegment(const FrameTags& tags, std::size_t frame, DicomSlice& slice) {
  if (!slice.labels || slice.labels->kind == DicomLabels::Kind::Values) return true;
  const auto number = tags.find(frame, {0x0062, 0x000a}, [](const gdcm::DataSet& data, bool) {
    return countAt(data, {0x0062, 0x000b});
  });
  slice.segment = number.value_or(0);
  return slice.segment > 0.0;
}

// Returns true if the frames follow each other in time.
bool isFilm(const gdcm::DataSet& data) {
  const gdcm::Tag pointer(0x0028, 0x0009);
  const std::string bytes = bytesAt(data, pointer);
  return bytes == std::string("\x18\x00\x63\x10", 4) || bytes == std::string("\x18\x00\x65\x10", 4);
}

}  // namespace

bool DicomSlice::belongsWith(const DicomSlice& other) const {
  return series == other.series && labels == other.labels && size == other.size && hasPosition == other.hasPosition &&
         (across - other.across).norm() < 10 * kAlike && (down - other.down).norm() < 10 * kAlike &&
         std::abs(spacing[0] - other.spacing[0]) < kAlike && std::abs(spacing[1] - other.spacing[1]) < kAlike;
}

std::vector<DicomSlice> slicesOf(std::string_view file) {
  SliceBuffer buffer(file);
  std::istream stream(&buffer);
  gdcm::Reader reader;
  reader.SetStream(stream);
  if (!reader.ReadUpToTag(gdcm::Tag(0x7fe0, 0x0010))) return {};
  const gdcm::File& header = reader.GetFile();
  const gdcm::DataSet& data = header.GetDataSet();
  const gdcm::PixelFormat format = gdcm::ImageHelper::GetPixelFormatValue(header);
  const std::shared_ptr<const DicomLabels> labels = labelsOf(data);
  if (!isGrey(format, gdcm::ImageHelper::GetPhotometricInterpretationValue(header), labels.get())) return {};
  constexpr double kMost = 1 << 16;
  const double frames = numberAt(data, {0x0028, 0x0008}).value_or(1.0);
  const std::uint32_t width = countAt(data, {0x0028, 0x0011}).value_or(0),
                      height = countAt(data, {0x0028, 0x0010}).value_or(0);
  if (!(frames >= 1.0 && frames <= kMost) || width < 1 || width > kMost || height < 1 || height > kMost) return {};
  DicomSlice common = sliceOfFile(data);
  common.bytes = file;
  common.labels = labels;
  if (!labels) common.padding = paddingOf(data, format.GetPixelRepresentation() != 0);
  common.isOfBits = format.GetBitsAllocated() == 1;
  common.frames = static_cast<std::size_t>(frames);
  common.size = {static_cast<int>(width), static_cast<int>(height)};
  const FrameTags tags(data);
  const auto detectors = itemsAt(data, {0x0054, 0x0022});  // nuclear medicine
  const gdcm::DataSet* const detector = detectors ? &detectors->GetItem(1).GetNestedDataSet() : nullptr;
  std::vector<DicomSlice> slices;
  for (std::size_t frame = 0; frame < common.frames; ++frame) {
    DicomSlice slice = common;
    if (tags.ownCount() == 0 && !slices.empty()) {
      slice = slices.front();
    } else {
      setSpacing(tags, frame, slice);
      setScale(tags, frame, slice);
      setPosition(tags, frame, detector, slice);
      if (!setDirections(tags, frame, detector, slice) || !setSegment(tags, frame, slice)) continue;
    }
    slice.frame = frame;
    if (common.frames > 1) {
      slice.location.reset();
      slice.number = tags.numberInStack(frame).value_or(static_cast<double>(frame));
      if (isFilm(data)) slice.apart = 0.0;
    }
    slices.push_back(std::move(slice));
  }
  setOffsets(data, slices);
  return slices;
}

// Unpacks pixels of one bit each, the lowest bit first; frames follow each other without padding (PS3.5, 8.2).
bool SlicePixels::unpackBits(const DicomSlice& slice) {
  SliceBuffer buffer(slice.bytes);
  std::istream stream(&buffer);
  gdcm::Reader reader;
  reader.SetStream(stream);
  const gdcm::Tag tag(0x7fe0, 0x0010);
  if (!reader.Read() || !reader.GetFile().GetDataSet().FindDataElement(tag)) return false;
  const gdcm::ByteValue* const bits = reader.GetFile().GetDataSet().GetDataElement(tag).GetByteValue();
  const std::size_t count =
      static_cast<std::size_t>(slice.size[0]) * static_cast<std::size_t>(slice.size[1]) * slice.frames;
  if (!bits || (count + 7) / 8 > bits->GetLength()) return false;
  m_pixels.resize(count);
  const char* const bytes = bits->GetPointer();
  for (std::size_t i = 0; i < count; ++i)
    m_pixels[i] = static_cast<char>(static_cast<unsigned char>(bytes[i / 8]) >> i % 8 & 1);
  m_bytes = 1;
  m_stored = 8;
  m_shift = 0;
  m_isSigned = false;
  m_file = slice.bytes.data();
  return true;
}

bool SlicePixels::unpack(const DicomSlice& slice) {
  if (m_file == slice.bytes.data()) return true;
  m_file = nullptr;
  m_pixels = {};
  if (slice.isOfBits) return unpackBits(slice);
  const std::string known = slice.labels ? withKnownKind(slice.bytes) : std::string();
  SliceBuffer buffer(slice.labels ? std::string_view(known) : slice.bytes);
  std::istream stream(&buffer);
  gdcm::ImageReader reader;
  reader.SetStream(stream);
  if (!reader.Read()) return false;
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  if (!isGrey(format, image.GetPhotometricInterpretation(), slice.labels.get())) return false;
  const auto along = [&](unsigned int k) { return k < image.GetNumberOfDimensions() ? image.GetDimension(k) : 1u; };
  if (along(0) != static_cast<unsigned int>(slice.size[0]) || along(1) != static_cast<unsigned int>(slice.size[1]) ||
      along(2) != slice.frames)
    return false;
  m_bytes = (format.GetBitsAllocated() + 7) / 8;
  const std::size_t needed = std::size_t{along(0)} * along(1) * along(2) * static_cast<std::size_t>(m_bytes);
  if (image.GetBufferLength() < needed) return false;
  m_pixels.resize(image.GetBufferLength());
  if (!image.GetBuffer(m_pixels.data())) return false;
  const int bits = 8 * m_bytes;
  m_stored = std::clamp<int>(format.GetBitsStored(), 1, bits);
  m_shift = std::clamp<int>(format.GetHighBit() + 1 - m_stored, 0, bits - m_stored);
  m_isSigned = format.GetPixelRepresentation() != 0;
  m_file = slice.bytes.data();
  return true;
}

std::optional<std::vector<float>> SlicePixels::valuesOf(const DicomSlice& slice) {
  if (!unpack(slice)) return {};
  const std::uint64_t mask = (std::uint64_t{1} << m_stored) - 1, sign = std::uint64_t{1} << (m_stored - 1);
  std::vector<float> values(static_cast<std::size_t>(slice.size[0]) * static_cast<std::size_t>(slice.size[1]));
  std::vector<std::size_t> without;
  // Converts the used bits of the pixels to signed or unsigned numbers, and rescales them.
  const auto put = [&]<class Word>(Word word) {
    const char* at = m_pixels.data() + slice.frame * values.size() * sizeof(Word);
    for (float& value : values) {
      std::copy_n(at, sizeof(Word), reinterpret_cast<char*>(&word));
      at += sizeof(Word);
      const std::uint64_t bits = word >> m_shift & mask;
      const double number = m_isSigned && (bits & sign) != 0 ? static_cast<double>(bits) - std::ldexp(1.0, m_stored)
                                                             : static_cast<double>(bits);
      if (slice.padding && number >= (*slice.padding)[0] && number <= (*slice.padding)[1])
        without.push_back(static_cast<std::size_t>(&value - values.data()));
      value = static_cast<float>(slice.slope * number + slice.intercept);
    }
  };
  if (m_bytes == 1) put(std::uint8_t{});
  if (m_bytes == 2) put(std::uint16_t{});
  if (m_bytes == 4) put(std::uint32_t{});
  clearPadding(without, values);
  return values;
}

}  // namespace handwheel
