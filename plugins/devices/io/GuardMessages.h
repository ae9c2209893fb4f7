// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "haptics/Device.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace handwheel::guard {

// What the program and a process that holds a device for it say to each other. Each message is its kind and the length
// of the rest (u32 each), then the rest, numbers as the machine has them: both run on it.
inline constexpr std::uint32_t kVersion = 2;

// From the program.
struct Open {
  std::uint32_t version = kVersion;
};
struct Force {
  std::uint32_t number = 0;
  DeviceForce force;
};
struct Close {};

// From the other process.
struct Opening {
  double fraction = 0.0;  // 0…1
};
struct Opened {
  DeviceCapabilities capabilities;
};
struct Refused {
  Error error;
};
struct State {
  std::uint32_t number = 0;  // of the force that it answers
  DeviceState state;
};

using Message = std::variant<Open, Force, Close, Opening, Opened, Refused, State>;

inline constexpr std::size_t kLargestMessage = 1024;  // bytes
using Buffer = std::array<std::uint8_t, kLargestMessage>;

// The message as bytes, in this buffer. Texts that are too long are cut. Allocates nothing.
std::span<const std::uint8_t> bytesOf(const Message& message, Buffer& buffer);

// Takes bytes in pieces of any size, and gives the messages in them. Bytes that are none, a force or a place that is no
// number among them, break it for good: who speaks like that is not listened to any more. Allocates nothing but the
// texts of a refusal.
class Reader {
 public:
  // Gives the bytes to next(), which uses up all of them before it returns nothing.
  void add(std::span<const std::uint8_t> bytes) { m_rest = bytes; }
  std::optional<Message> next();
  bool isBroken() const { return m_isBroken; }

 private:
  bool fill(std::size_t size);

  std::span<const std::uint8_t> m_rest;
  Buffer m_message{};
  std::size_t m_filled = 0;
  bool m_isBroken = false;
};

}  // namespace handwheel::guard
