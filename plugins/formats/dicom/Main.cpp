// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ByteOrder.h"
#include "base/NumberText.h"
#include "dicom/DicomKind.h"
#include "dicom/Segmentation.h"
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
// the distance of pixels is unknown; samples in several segments; largest gap between slices, if some are missing, in
// mm (0: none). Then follows the image as an NRRD file, with the names of segments.

using namespace handwheel;

namespace {

constexpr std::size_t kMostSlices = 1 << 17;

// The figures of the answer.
struct Figures {
  double tilt = 0.0, least = 0.0, largest = 0.0, step = 0.0;
  std::size_t missing = 0, others = 0, samePosition = 0, unreadable = 0;
  double assumed = 0.0;
  bool hasNoSpacing = false;
  std::size_t overlaps = 0;
  double gap = 0.0;

  std::string line() const {
    std::string text;
    const auto put = [&](auto figure) { text += shortestText(static_cast<double>(figure)) + " "; };
    for (const double figure : {tilt, least, largest, step}) put(figure);
    for (const std::size_t count : {missing, others, samePosition, unreadable}) put(count);
    put(assumed);
    put(hasNoSpacing ? 1.0 : 0.0);
    put(overlaps);
    put(gap);
    text.back() = '\n';
    return text;
  }
};

Result<ImageFile> seriesImage(const std::vector<DicomSlice>& slices, Figures& figures, Progress progress) {
  const Result<Series> series = seriesOf(slices);
  if (!series) return series.error();
  Result<ImageFile> image = imageOf(*series, progress);
  if (!image) return image.error();
  figures.tilt = series->tilt;
  if (series->isUneven) {
    figures.least = series->least;
    figures.largest = series->largest;
    figures.step = image->image.grid().spacing().z();
  }
  figures.missing = series->missing;
  if (series->missing > 0) figures.gap = series->largest;
  figures.samePosition = series->samePosition;
  figures.assumed = series->assumed;
  figures.hasNoSpacing = !series->slices.front().hasSpacing;
  return image;
}

Result<ImageFile> segmentationOf(const std::vector<DicomSlice>& frames, Figures& figures, Progress progress) {
  Result<SegmentationImage> made = imageOfSegmentation(frames, progress);
  if (!made) return made.error();
  figures.samePosition = made->samePosition;
  figures.overlaps = made->overlaps;
  figures.hasNoSpacing = !frames.front().hasSpacing;
  made->file.image.setLabels(made->file.labels);
  return std::move(made->file);
}

Result<std::string> answerOf(std::string_view bytes, bool ofFirst, Progress progress) {
  std::vector<DicomSlice> slices;
  std::size_t unreadable = 0;
  const std::size_t all = bytes.size();
  std::string_view first;
  while (bytes.size() >= 8) {
    const auto length = loadNumber<std::uint64_t>(bytes.data(), std::endian::little);
    bytes.remove_prefix(8);
    const std::string_view file = bytes.substr(0, length);
    bytes.remove_prefix(file.size());
    if (first.empty()) first = file;
    std::vector<DicomSlice> own = slicesOf(file);
    if (own.empty()) ++unreadable;
    if (slices.size() + own.size() > kMostSlices)
      return Error{ErrorCode::LibraryFailed, {"it has too many slices"}, {}, {}};
    slices.insert(slices.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
    progress.set(0.3 * (1.0 - static_cast<double>(bytes.size()) / static_cast<double>(all)));
  }
  if (slices.empty()) return Error{ErrorCode::LibraryFailed, {reasonWithoutSlices(first)}, {}, {}};
  const std::vector<DicomSlice> own = chosenSeries(slices, ofFirst);
  Figures figures;
  figures.others = slices.size() - own.size();
  figures.unreadable = unreadable;
  const Result<ImageFile> image = own.front().labels ? segmentationOf(own, figures, progress.part(0.3, 1.0))
                                                     : seriesImage(own, figures, progress.part(0.3, 1.0));
  if (!image) return image.error();
  std::string answer = figures.line();
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
