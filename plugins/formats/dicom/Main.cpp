// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ByteOrder.h"
#include "base/NumberText.h"
#include "dicom/Series.h"
#include "dicom/SeriesImage.h"
#include "process/ReaderProgram.h"
#include "volume/image/NrrdWriter.h"

#include <iterator>
#include <new>

// Reads a series of DICOM for core/volume/image/DicomReader.cpp. Its input are files one after the other, each after
// its length (8 bytes, little-endian). The option is "first", for the series of the first file, or "largest". The
// answer is one line: tilt in degrees; least, largest and resulting distance of uneven slices in mm; slices that are
// missing, of other series, and at the same position; files that cannot be read; assumed distance of slices in mm; 1 if
// the distance of pixels is unknown (0: none). Then follows the image as an NRRD file.

using namespace handwheel;

namespace {

constexpr std::size_t kMostSlices = 1 << 17;

Result<std::string> answerOf(std::string_view bytes, bool ofFirst, Progress progress) {
  std::vector<DicomSlice> slices;
  std::size_t unreadable = 0;
  const std::size_t all = bytes.size();
  while (bytes.size() >= 8) {
    const auto length = loadNumber<std::uint64_t>(bytes.data(), std::endian::little);
    bytes.remove_prefix(8);
    const std::string_view file = bytes.substr(0, length);
    bytes.remove_prefix(file.size());
    std::vector<DicomSlice> own = slicesOf(file);
    if (own.empty()) ++unreadable;
    if (slices.size() + own.size() > kMostSlices)
      return Error{ErrorCode::LibraryFailed, {"it has too many slices"}, {}, {}};
    slices.insert(slices.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
    progress.set(0.3 * (1.0 - static_cast<double>(bytes.size()) / static_cast<double>(all)));
  }
  const Result<Series> series = seriesOf(std::move(slices), ofFirst);
  if (!series) return series.error();
  const Result<ImageFile> image = imageOf(*series, progress.part(0.3, 1.0));
  if (!image) return image.error();
  std::string answer;
  const double uneven = series->isUneven ? 1.0 : 0.0;
  for (const double figure :
       {series->tilt, uneven * series->least, uneven * series->largest, uneven * image->image.grid().spacing().z(),
        static_cast<double>(series->missing), static_cast<double>(series->others),
        static_cast<double>(series->samePosition), static_cast<double>(unreadable), series->assumed,
        series->slices.front().hasSpacing ? 0.0 : 1.0})
    answer += shortestText(figure) + " ";
  answer.back() = '\n';
  appendNrrd(image->image, {}, answer);
  return answer;
}

// Converts exceptions of the library to errors; their messages may contain data about the patient.
Result<std::string> readDicomFiles(std::string_view bytes, std::span<char* const> options, Progress progress) {
  try {
    return answerOf(bytes, !options.empty() && std::string_view(options[0]) == "first", progress);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return Error{ErrorCode::LibraryFailed, {"it is inconsistent"}, {}, {}};
  }
}

}  // namespace

int main(int argc, char** argv) {
  runReaderProgram(argc, argv, readDicomFiles);
}
