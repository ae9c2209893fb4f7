// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DrawingFuzz.h"
#include "machining/target/files/DrawingWriter.h"
#include "machining/target/files/SvgReader.h"

#include <cstddef>
#include <cstdint>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handwheel;
  fuzz::checkDrawing(readSvg({reinterpret_cast<const char*>(data), size}),
                     [](const TargetProfile& target) { return svgOf(target); });
  return 0;
}
