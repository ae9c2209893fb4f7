// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/FtdiPort.h"

#include <algorithm>
#include <array>

namespace handwheel::falcon {

namespace {

// Vendor requests of the chip, with their parameters.
enum Request : std::uint8_t { kReset = 0, kModem = 1, kFlow = 2, kBaud = 3, kData = 4, kLatency = 9 };
constexpr std::uint16_t kPurgeIn = 1, kPurgeOut = 2;
constexpr std::uint16_t kDtrHigh = 0x0101, kDtrLow = 0x0100, kRtsLow = 0x0200;
constexpr std::uint16_t k9600Baud = 0x4138;    // 3 MHz / 312.5
constexpr std::uint16_t k142857Baud = 0x0015;  // 3 MHz / 21
constexpr std::uint16_t k1500kBaud = 0x0002;   // 3 MHz / 2
constexpr std::uint16_t k8N1 = 8;
constexpr std::size_t kUsbPacket = 64;
constexpr std::size_t kStatusBytes = 2;

}  // namespace

bool FtdiPort::purge() noexcept {
  return m_usb->control(kReset, kPurgeIn) && m_usb->control(kReset, kPurgeOut);
}

bool FtdiPort::toBootloader() noexcept {
  return purge() && m_usb->control(kLatency, 16) && m_usb->control(kBaud, k9600Baud) && m_usb->control(kData, k8N1) &&
         m_usb->control(kFlow, 0) && m_usb->control(kModem, kRtsLow) && m_usb->control(kModem, kDtrLow) &&
         m_usb->control(kModem, kDtrHigh);
}

bool FtdiPort::toFirmwareLoad() noexcept {
  return m_usb->control(kModem, kDtrLow) && m_usb->control(kBaud, k142857Baud);
}

bool FtdiPort::toRunning() noexcept {
  return m_usb->control(kLatency, 1) && m_usb->control(kBaud, k1500kBaud) && purge();
}

std::ptrdiff_t FtdiPort::read(std::span<std::uint8_t> into, double timeout) noexcept {
  std::array<std::uint8_t, 4 * kUsbPacket> raw{};
  const std::size_t packets = std::min(raw.size() / kUsbPacket, into.size() / (kUsbPacket - kStatusBytes));
  const std::ptrdiff_t count =
      m_usb->read(std::span(raw).first(std::max<std::size_t>(1, packets) * kUsbPacket), timeout);
  if (count <= 0) return count;
  std::size_t kept = 0;
  const auto length = static_cast<std::size_t>(count);
  for (std::size_t start = 0; start < length; start += kUsbPacket) {
    for (std::size_t i = start + kStatusBytes; i < std::min(start + kUsbPacket, length) && kept < into.size(); ++i) {
      into[kept++] = raw[i];
    }
  }
  return static_cast<std::ptrdiff_t>(kept);
}

}  // namespace handwheel::falcon
