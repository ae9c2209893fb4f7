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

// Messages between the program and the process that holds a device for it. Each message consists of its kind and the
// length of the rest (u32 each), followed by the rest. Numbers are in the byte order of the machine, on which both
// processes run.
inline constexpr std::uint32_t kVersion = 3;

// A request of the program to open the device.
struct Open {
  std::uint32_t version = kVersion;
};
// A message of the program with the force to send to the device.
struct Force {
  std::uint32_t number = 0;
  DeviceForce force;
};
// A request of the program to close the device.
struct Close {};

// A message of the other process with the progress of opening the device.
struct Opening {
  double fraction = 0.0;  // 0…1
};
// A message of the other process that the device is open.
struct Opened {
  DeviceCapabilities capabilities;
};
// A message of the other process that the device could not be opened.
struct Refused {
  Error error;
};
// A message of the other process with the latest reading of the device.
struct State {
  std::uint32_t number = 0;  // number of the force that the reading answers
  DeviceState state;
};

using Message = std::variant<Open, Force, Close, Opening, Opened, Refused, State>;

inline constexpr std::size_t kLargestMessage = 1024;  // bytes
using Buffer = std::array<std::uint8_t, kLargestMessage>;

// Serialises a message to a buffer. Texts that are too long are truncated. The function does not allocate.
std::span<const std::uint8_t> bytesOf(const Message& message, Buffer& buffer);

// Parses messages from a byte stream, which may arrive in pieces of any size. Invalid bytes, including a force or
// position that is not a number, break the reader permanently: it ignores all further bytes. It allocates only the
// texts of a refusal.
class Reader {
 public:
  // Sets the bytes that next() parses. next() returns nothing once it has used all of them.
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
