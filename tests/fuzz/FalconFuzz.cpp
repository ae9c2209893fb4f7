// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Packet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is what a Falcon sends, in
// pieces whose length its own first byte chooses.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "FalconFuzz: %s\n", what);
  std::abort();
}

void judge(const falcon::Reading& reading) {
  require(reading.buttons < 16 && reading.homed < 8, "bits that there are not");
  for (const int count : reading.encoders) require(count >= -32768 && count <= 32767, "no 16 bits");
  const auto point = falcon::forward(falcon::anglesOf(reading.encoders), falcon::kHome);
  if (!point) return;
  require(point->allFinite(), "a point that is not finite");
  const auto angles = falcon::inverse(*point);
  require(angles.has_value(), "a point out of reach");
  for (std::size_t i = 0; i < 3; ++i) {
    require(std::abs((*angles)[i] - falcon::anglesOf(reading.encoders)[i]) < 1e-9, "another point");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  const std::size_t piece = size > 0 ? 1 + bytes[0] % 64 : 1;
  falcon::AnswerReader reader;
  for (std::size_t at = 0; at < size; at += piece) {
    if (reader.take(bytes.subspan(at, std::min(piece, size - at))) > 0) judge(reader.reading());
  }
  return 0;
}
