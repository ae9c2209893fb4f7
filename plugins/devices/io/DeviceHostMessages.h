// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "haptics/device/Device.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace handwheel::guard {

// Messages between the program and the process that holds a device for it. Each message is its kind and the length of
// the rest (u32 each), then the rest, numbers in the machine's byte order: both run on it.
inline constexpr std::uint32_t kVersion = 3;

// From the program: open the device.
struct Open {
  std::uint32_t version = kVersion;
};
// From the program: the force to send to the device.
struct Force {
  std::uint32_t number = 0;
  DeviceForce force;
};
// From the program: close the device.
struct Close {};

// From the other process: progress of opening the device.
struct Opening {
  double fraction = 0.0;  // 0…1
};
// From the other process: the device is open.
struct Opened {
  DeviceCapabilities capabilities;
};
// From the other process: the device could not be opened.
struct Refused {
  Error error;
};
// From the other process: the latest reading of the device.
struct State {
  std::uint32_t number = 0;  // number of the force that it answers
  DeviceState state;
};

using Message = std::variant<Open, Force, Close, Opening, Opened, Refused, State>;

inline constexpr std::size_t kLargestMessage = 1024;  // bytes
using Buffer = std::array<std::uint8_t, kLargestMessage>;

// Serialises a message to a buffer. Texts that are too long are truncated. Does not allocate.
std::span<const std::uint8_t> bytesOf(const Message& message, Buffer& buffer);

// Parses messages from a byte stream, in pieces of any size. Invalid bytes, also a force or a position that is not a
// number, break it permanently: it ignores everything after them. Does not allocate but the texts of a refusal.
class Reader {
 public:
  // Passes the bytes to next(), which uses up all of them before it returns nothing.
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
