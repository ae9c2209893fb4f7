// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageFuzz.h"
#include "volume/image/RawImageReader.h"

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handwheel;
  fuzz::checkImage(data, size,
                   [](std::string_view bytes, const SiblingFile& sibling) { return readRawImage(bytes, sibling); });
  return 0;
}
