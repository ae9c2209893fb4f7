// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "io/ByteStream.h"

#include <memory>
#include <string>

namespace handwheel {

// A stream on a file descriptor. Allocates nothing after it was made.
class FileStream final : public ByteStream {
 public:
  explicit FileStream(int descriptor) : m_descriptor(descriptor) {}  // which it owns from here
  ~FileStream() override;
  FileStream(const FileStream&) = delete;
  FileStream& operator=(const FileStream&) = delete;

  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept override;
  bool write(std::span<const std::uint8_t> bytes) noexcept override;

 private:
  int m_descriptor;
};

// Error: DeviceUnreachable with the system's reason.
Result<std::unique_ptr<ByteStream>> connectUnix(const std::string& path);
Result<std::unique_ptr<ByteStream>> connectLoopback(std::uint16_t port);  // TCP to 127.0.0.1
// Raw: no echo, no line editing, at 115,200 baud where that means anything.
Result<std::unique_ptr<ByteStream>> openSerial(const std::string& path);

}  // namespace handwheel
