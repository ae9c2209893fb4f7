// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haply/Frames.h"
#include "haply/Messages.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is what the service sends
// after the handshake, and, once more, the text of one message.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "HaplyFuzz: %s\n", what);
  std::abort();
}

void judge(std::string_view text) {
  const auto frame = haply::readFrame(text);
  if (!frame) return;
  require(!frame->deviceId.empty(), "a device without a name");
  require(!frame->position || frame->position->cwiseAbs().maxCoeff() <= 1e4, "a position out of the world");
  require(!frame->velocity || frame->velocity->allFinite(), "a velocity that is not finite");
  require(!frame->orientation || std::abs(frame->orientation->norm() - 1.0) < 1e-9, "no rotation");
  require(haply::readFrame(haply::forceCommand(frame->deviceId, Vec3::UnitX())).has_value(), "a command that is none");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  haply::FrameReader reader;
  reader.take({data, size});
  while (const auto message = reader.next()) judge(message->payload);
  judge({reinterpret_cast<const char*>(data), size});
  return 0;
}
