// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageFuzz.h"
#include "volume/image/DicomReader.h"

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is what the process that
// reads DICOM answers: a hostile file may have taken it over. What hostile files do to that process itself, where no
// coverage guides, is in DicomFileFuzz.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handwheel;
  fuzz::checkImage(data, size, [](std::string_view bytes, const SiblingFile&) { return imageInAnswer(bytes); });
  return 0;
}
