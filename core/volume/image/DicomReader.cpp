// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/DicomReader.h"

#include "base/ByteOrder.h"
#include "process/IsolatedReader.h"
#include "volume/image/ImageHeader.h"
#include "volume/image/NrrdReader.h"

#include <algorithm>
#include <array>

namespace handwheel {
namespace {

IsolatedReader dicomReader(std::size_t bytes) {
  IsolatedReader reader{readerProgram("dicom"), kDicomLibrary, {}};
  // The library unpacks about ten megabytes per second; the limit allows for slow machines.
  reader.limits.cpu += std::chrono::seconds(bytes >> 20);
  reader.limits.wall = 2 * reader.limits.cpu;
  reader.limits.mostOutput = std::size_t{5} << 30;  // the largest image, and a little
  return reader;
}

// Returns true if a file without a preamble begins with a data set (PS3.5, 7.1): with three elements in ascending
// order, the first one of a group that is always the first.
bool beginsWithElements(std::string_view bytes, std::endian order) {
  constexpr std::string_view kShort = "AE AS AT CS DA DS DT FL FD IS LO LT PN SH SL SS ST TM UI UL US ",
                             kLong = "OB OW OF SQ UN UT OD OL OV UC UR SV UV ";
  constexpr std::size_t kWanted = 3, kLongest = 4096;
  std::uint32_t last = 0;
  for (std::size_t at = 0, found = 0; found < kWanted; ++found) {
    if (at + 12 > bytes.size()) return false;
    const auto group = loadNumber<std::uint16_t>(bytes.data() + at, order),
               element = loadNumber<std::uint16_t>(bytes.data() + at + 2, order);
    const std::uint32_t tag = std::uint32_t{group} << 16 | element;
    if (found == 0 ? group != 2 && group != 8 : tag <= last || group > 0x10) return false;
    last = tag;
    const std::string word = std::string(bytes.substr(at + 4, 2)) + ' ';
    std::size_t length = 0;
    if (kShort.find(word) != std::string_view::npos) {
      length = loadNumber<std::uint16_t>(bytes.data() + at + 6, order);
      at += 8;
    } else if (kLong.find(word) != std::string_view::npos) {
      length = loadNumber<std::uint32_t>(bytes.data() + at + 8, order);
      at += 12;
    } else {  // implicit types
      if (order != std::endian::little) return false;
      length = loadNumber<std::uint32_t>(bytes.data() + at + 4, order);
      at += 8;
    }
    if (length > kLongest || length % 2 != 0) return false;
    at += length;
  }
  return true;
}

}  // namespace

void appendDicomFile(std::string_view file, std::string& files) {
  appendNumber<std::uint64_t>(files, file.size(), std::endian::little);
  files += file;
}

bool looksLikeDicom(std::string_view bytes) {
  if (bytes.size() > 132 && bytes.substr(128, 4) == "DICM") return true;
  return beginsWithElements(bytes, std::endian::little) || beginsWithElements(bytes, std::endian::big);
}

Result<ImageFile> readDicom(std::string_view files, DicomChoice choice, Progress progress) {
  const Result<std::string> answer =
      readIsolated(dicomReader(files.size()), {choice == DicomChoice::OfFirst ? "first" : "largest"}, files, progress);
  if (!answer) return answer.error();
  return imageInAnswer(*answer);
}

Result<ImageFile> imageInAnswer(std::string_view answer) {
  const Error senseless{ErrorCode::LibraryFailed, {kDicomLibrary, "its answer is not valid"}, {}, {}};
  constexpr std::size_t kLongestLine = 256, kFigures = 12;
  const std::size_t end = answer.substr(0, kLongestLine).find('\n');
  if (end == std::string_view::npos) return senseless;
  const auto figures = imageHeader::numbersOf(answer.substr(0, end), kFigures);
  if (!figures || std::any_of(figures->begin(), figures->end(), [](double f) { return f < 0.0 || f > 1e9; }))
    return senseless;
  // The NRRD that the process writes never refers to another file.
  Result<ImageFile> read = readNrrd(answer.substr(end + 1),
                                    [&](const std::string&, std::size_t) -> Result<std::string> { return senseless; });
  if (!read) return senseless;
  using Kind = ImageRemark::Kind;
  const auto& f = *figures;
  if (f[0] > 0.0) read->remarks.push_back({Kind::Tilted, {f[0]}});
  if (f[2] > 0.0) read->remarks.push_back({Kind::Uneven, {f[1], f[2], f[3]}});
  if (f[4] > 0.0) read->remarks.push_back({Kind::SlicesMissing, {f[4], f[11]}});
  const std::array counts{Kind::OtherSeries, Kind::SamePosition, Kind::NotReadable};
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (f[5 + k] > 0.0) read->remarks.push_back({counts[k], {f[5 + k]}});
  if (f[8] > 0.0) read->remarks.push_back({Kind::SpacingAssumed, {f[8]}});
  if (f[9] > 0.0) read->remarks.push_back({Kind::NoSpacing, {}});
  if (f[10] > 0.0) read->remarks.push_back({Kind::Overlap, {f[10]}});
  return read;
}

}  // namespace handwheel
