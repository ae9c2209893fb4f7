// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Bootloader.h"

#include "falcon/Packet.h"
#include "haptics/device/DeviceErrors.h"

#include <algorithm>
#include <array>

namespace handwheel::falcon {

namespace {

constexpr int kLoads = 10;                // the whole load
constexpr int kGreetings = 100;           // within each
constexpr int kProbes = 10;               // greetings within each load
constexpr double kBootAnswerTime = 0.02;  // s
constexpr double kPause = 0.1;            // s between two loads
constexpr std::size_t kChunk = 62;        // bytes; more are not echoed
constexpr std::array<std::uint8_t, 3> kGreeting = {0x0a, 0x43, 0x0d};
constexpr std::array<std::uint8_t, 4> kGreeted = {0x0a, 0x44, 0x2c, 0x0d};
constexpr std::array<std::uint8_t, 1> kBegin = {0x41};

using Buffer = std::array<std::uint8_t, 256>;

// Reads so many bytes, or fewer if no more come in time.
std::span<const std::uint8_t> readUpTo(FtdiPort& port, Clock& clock, Buffer& buffer, std::size_t wanted) {
  std::size_t filled = 0;
  const double end = clock.now() + kBootAnswerTime;
  while (filled < wanted && clock.now() < end) {
    const std::ptrdiff_t count = port.read(std::span(buffer).subspan(filled), end - clock.now());
    if (count == kGone) break;
    filled += static_cast<std::size_t>(count);
  }
  return std::span(buffer).first(filled);
}

// Greets the device. Some hosts see a zero before the answer, so the answer may begin anywhere.
bool greet(FtdiPort& port, Clock& clock, const Progress& progress) {
  for (int i = 0; i < kGreetings && !port.isGone() && !progress.cancelled(); ++i) {
    Buffer buffer{};
    if (!port.write(kGreeting)) continue;
    const auto answer = readUpTo(port, clock, buffer, kGreeted.size());
    if (std::search(answer.begin(), answer.end(), kGreeted.begin(), kGreeted.end()) != answer.end()) return true;
  }
  return false;
}

// Sends bytes, each of which the device echoes.
bool sendEchoed(FtdiPort& port, Clock& clock, std::span<const std::uint8_t> bytes) {
  Buffer buffer{};
  if (!port.write(bytes)) return false;
  const auto echo = readUpTo(port, clock, buffer, bytes.size());
  return std::equal(echo.begin(), echo.end(), bytes.begin(), bytes.end());
}

// Makes one try. Returns the part that the device did not answer, or null when the firmware is loaded.
const char* tryLoad(FtdiPort& port, Clock& clock, const Firmware& firmware, Progress progress) {
  if (!port.toBootloader() || !greet(port, clock, progress)) return "the bootloader's greeting";
  if (!port.toFirmwareLoad() || !sendEchoed(port, clock, kBegin)) return "the echo of the first byte";
  const std::span<const std::uint8_t> image(firmware);
  for (std::size_t at = 0; at < image.size() && !progress.cancelled(); at += kChunk) {
    progress.set(static_cast<double>(at) / static_cast<double>(image.size()));
    if (!sendEchoed(port, clock, image.subspan(at, std::min(kChunk, image.size() - at)))) return "the firmware's echo";
  }
  if (progress.cancelled()) return "cancelled";
  return runs(port, clock) ? nullptr : "a packet of the firmware";
}

}  // namespace

bool runs(FtdiPort& port, Clock& clock) noexcept {
  if (!port.toRunning()) return false;
  AnswerReader reader;
  for (int i = 0; i < kProbes && !port.isGone(); ++i) {
    Buffer buffer{};
    if (port.write(encode({}, 0)) && reader.take(readUpTo(port, clock, buffer, kPacketSize)) > 0) return true;
  }
  return false;
}

Status loadFirmware(FtdiPort& port, Clock& clock, const Firmware& firmware, Progress progress) {
  const char* missed = nullptr;
  for (int i = 0; i < kLoads; ++i) {
    const double share = 1.0 / kLoads;
    missed = tryLoad(port, clock, firmware, progress.part(i * share, (i + 1) * share));
    if (!missed) return Done{};
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (port.isGone()) return Error{DeviceError::Unreachable, {"unplugged"}, {}, "Novint Falcon"};
    clock.sleep(kPause);
  }
  return Error{DeviceError::NotResponding, {missed}, {}, "Novint Falcon"};
}

}  // namespace handwheel::falcon
