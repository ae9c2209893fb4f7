// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordingBytes.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the recording.

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "RecordingFuzz: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handwheel;
  const auto read = recordingFromBytes({reinterpret_cast<const char*>(data), size});
  if (!read) return 0;
  for (std::size_t i = 0; i < read->size(); ++i) require((*read)[i].tip.position.allFinite(), "a tip that is nowhere");
  // The recording is written and read again as the same.
  const std::string bytes = recordingBytes(*read);
  require(bytes.size() == size, "another length");
  const auto again = recordingFromBytes(bytes);
  require(again && recordingBytes(*again) == bytes, "not what was written");
  return 0;
}
