// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "falcon/UsbTransport.h"

#include <memory>

namespace handwheel::falcon {

// The serial port of the Falcon's FTDI chip.
class FtdiPort {
 public:
  explicit FtdiPort(std::unique_ptr<UsbTransport> usb) : m_usb(std::move(usb)) {}

  // Switches to bootloader mode: 9600 baud, 8N1, no flow control, RTS low, DTR pulsed.
  bool toBootloader() noexcept;
  bool toFirmwareLoad() noexcept;  // switches to 142,857 baud, DTR low
  bool toRunning() noexcept;       // switches to 1.5 Mbaud, with answers within 1 ms

  bool write(std::span<const std::uint8_t> bytes) noexcept { return m_usb->write(bytes); }
  // Reads received bytes, without the chip's two status bytes at the start of each 64-byte packet. Returns the number
  // of bytes, 0 if no bytes came within the timeout (s), or kGone.
  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept;
  bool isGone() const noexcept { return m_usb->isGone(); }

 private:
  bool purge() noexcept;

  std::unique_ptr<UsbTransport> m_usb;
};

}  // namespace handwheel::falcon
