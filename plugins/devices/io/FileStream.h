// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "io/ByteStream.h"

#include <memory>
#include <string>

namespace handwheel {

// A byte stream on a file descriptor. It does not allocate memory after its construction.
class FileStream final : public ByteStream {
 public:
  explicit FileStream(int descriptor) : m_descriptor(descriptor) {}  // takes ownership
  ~FileStream() override;
  FileStream(const FileStream&) = delete;
  FileStream& operator=(const FileStream&) = delete;

  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept override;
  bool write(std::span<const std::uint8_t> bytes) noexcept override;

 private:
  int m_descriptor;
};

// Connects to a Unix socket. Like the functions below, it returns the error Unreachable with the system's reason.
Result<std::unique_ptr<ByteStream>> connectUnix(const std::string& path);
Result<std::unique_ptr<ByteStream>> connectLoopback(std::uint16_t port);  // connects to a TCP port of 127.0.0.1
// Opens a serial port in raw mode, without echo and line editing. Ports with a selectable rate are set to 115,200 baud.
Result<std::unique_ptr<ByteStream>> openSerial(const std::string& path);

}  // namespace handwheel
