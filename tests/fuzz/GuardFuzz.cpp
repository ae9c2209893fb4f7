// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/DeviceHostMessages.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it if that is not available. The input is the message of one process
// to the other: for any message, only finite forces and positions result.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "GuardFuzz: %s\n", what);
  std::abort();
}

void check(const guard::Message& message) {
  if (const auto* asked = std::get_if<guard::Force>(&message)) {
    require(asked->force.force.allFinite() && asked->force.torque.allFinite(), "a force that is no number");
  }
  if (const auto* answer = std::get_if<guard::State>(&message)) {
    require(answer->state.position.allFinite() && answer->state.velocity.allFinite(), "a place that is no number");
    require(std::abs(answer->state.orientation.norm() - 1.0) < 1e-9, "no rotation");
    require(answer->state.status <= DeviceStatus::Failed, "no status");
  }
  guard::Buffer buffer;
  guard::Reader again;
  again.add(guard::bytesOf(message, buffer));
  require(again.next().has_value(), "a message that does not come back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  guard::Reader reader;
  const std::size_t half = size / 2;
  for (const auto& piece : {std::span(data, half), std::span(data + half, size - half)}) {
    reader.add(piece);
    while (const std::optional<guard::Message> message = reader.next()) check(*message);
  }
  return 0;
}
