// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FileChanges.h"
#include "ImageFuzz.h"
#include "MadeFrames.h"
#include "volume/image/DicomReader.h"

#include <array>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The first byte chooses how the slices
// of a made-up CT are packed, or frames, the others change the first of three: whatever GDCM makes of it in its
// process, it ends in an image or an error.

namespace {

using namespace handwheel;

// Three slices, one above the other.
std::array<std::string, 3> madeSeries(gdcm::TransferSyntax::TSType syntax) {
  std::array<std::string, 3> files;
  test::MadeSlice slice;
  slice.syntax = syntax;
  slice.width = 32;
  slice.height = 24;
  for (std::string& file : files) {
    file = test::dicomOf(slice);
    slice.origin.z() += 2.0;
  }
  return files;
}

// Three files of three frames each.
std::array<std::string, 3> madeFrames() {
  std::array<std::string, 3> files;
  test::MadeSlice slice;
  for (std::string& file : files) {
    test::MadeFrames made;
    for (int i = 0; i < 3; ++i, slice.origin.z() += 2.0) made.frames.push_back(slice);
    made.isScaleShared = made.isOrientationShared = false;
    file = test::dicomOf(made);
  }
  return files;
}

const std::array<std::string, 3>& seriesFor(std::uint8_t choice) {
  using Syntax = gdcm::TransferSyntax;
  static const std::array<std::array<std::string, 3>, 7> all = {madeSeries(Syntax::ExplicitVRLittleEndian),
                                                                madeSeries(Syntax::ImplicitVRLittleEndian),
                                                                madeSeries(Syntax::JPEGLosslessProcess14_1),
                                                                madeSeries(Syntax::JPEGLSLossless),
                                                                madeSeries(Syntax::JPEG2000Lossless),
                                                                madeSeries(Syntax::RLELossless),
                                                                madeFrames()};
  return all[choice % all.size()];
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::array<std::string, 3>& good = seriesFor(data[0]);
  std::string files;
  appendDicomFile(fuzz::changedFile(good[0], data + 1, size - 1), files);
  appendDicomFile(good[1], files);
  appendDicomFile(good[2], files);
  fuzz::ReadingTime time;
  fuzz::checkImage(reinterpret_cast<const std::uint8_t*>(files.data()), files.size(),
                   [&](std::string_view bytes, const SiblingFile&) {
                     Result<ImageFile> read = readDicom(bytes, DicomChoice::OfFirst, time.progress());
                     if (!read) fuzz::requireReaderError(read.error().code, "DicomFileFuzz");
                     return read;
                   });
  return 0;
}
