// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polhem/Lines.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is what a Polhem sends.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "PolhemFuzz: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  polhem::LineReader reader;
  (void)reader.take({data, size});
  require(reader.reading().position.cwiseAbs().maxCoeff() <= 1e3, "a position out of the world");
  require(std::abs(reader.reading().orientation().norm() - 1.0) < 1e-9, "no rotation");
  return 0;
}
