// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ByteOrder.h"
#include "base/NumberText.h"
#include "dicom/Series.h"
#include "dicom/SeriesImage.h"
#include "process/ReaderProgram.h"
#include "volume/image/NrrdWriter.h"

#include <new>

// Reads a series of DICOM for core/volume/image/DicomReader.cpp. Its input are files one after the other, each after
// its length (8 bytes, little-endian). The option is "first", for the series of the first file, or "largest". The
// answer is one line: tilt in degrees, least and largest distance of uneven slices in mm, slices that are missing, of
// other series, and at the same position, files that cannot be read (0: none); and then the image as an NRRD file.

using namespace handwheel;

namespace {

Result<std::string> answerOf(std::string_view bytes, bool ofFirst, Progress progress) {
  std::vector<DicomSlice> slices;
  std::size_t unreadable = 0;
  const std::size_t all = bytes.size();
  while (bytes.size() >= 8) {
    const auto length = loadNumber<std::uint64_t>(bytes.data(), std::endian::little);
    bytes.remove_prefix(8);
    const std::string_view file = bytes.substr(0, length);
    bytes.remove_prefix(file.size());
    if (std::optional<DicomSlice> slice = sliceOf(file))
      slices.push_back(std::move(*slice));
    else
      ++unreadable;
    progress.set(0.3 * (1.0 - static_cast<double>(bytes.size()) / static_cast<double>(all)));
  }
  const Result<Series> series = seriesOf(std::move(slices), ofFirst);
  if (!series) return series.error();
  const Result<ImageFile> image = imageOf(*series, progress.part(0.3, 1.0));
  if (!image) return image.error();
  std::string answer;
  for (const double figure :
       {series->tilt, series->isUneven ? series->least : 0.0, series->isUneven ? series->largest : 0.0,
        static_cast<double>(series->missing), static_cast<double>(series->others),
        static_cast<double>(series->samePosition), static_cast<double>(unreadable)})
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
