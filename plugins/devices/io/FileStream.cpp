// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/FileStream.h"

#include "haptics/device/DeviceErrors.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace handwheel {

namespace {

constexpr int kWriteMilliseconds = 100;  // time that a full buffer may take to drain

// Returns true if the descriptor is ready, or reports an end or an error.
bool waitFor(int descriptor, short events, int milliseconds) {
  pollfd entry{descriptor, events, 0};
  return ::poll(&entry, 1, milliseconds) > 0;
}

Error unreachable(const std::string& subject) {
  return {DeviceError::Unreachable, {std::strerror(errno)}, {}, subject};
}

Result<std::unique_ptr<ByteStream>> connected(int family, const sockaddr* address, socklen_t size,
                                              const std::string& subject) {
  const int descriptor = ::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return unreachable(subject);
  auto stream = std::make_unique<FileStream>(descriptor);
  if (::connect(descriptor, address, size) != 0) return unreachable(subject);
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
  return std::unique_ptr<ByteStream>(std::move(stream));
}

}  // namespace

FileStream::~FileStream() {
  ::close(m_descriptor);
}

std::ptrdiff_t FileStream::read(std::span<std::uint8_t> into, double timeout) noexcept {
  if (!waitFor(m_descriptor, POLLIN, static_cast<int>(std::ceil(timeout * 1e3)))) return 0;
  const ssize_t count = ::read(m_descriptor, into.data(), into.size());
  if (count > 0) return count;
  return count < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : kGone;
}

bool FileStream::write(std::span<const std::uint8_t> bytes) noexcept {
  while (!bytes.empty()) {
    ssize_t count = ::send(m_descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == ENOTSOCK) count = ::write(m_descriptor, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (errno != EINTR && (errno != EAGAIN || !waitFor(m_descriptor, POLLOUT, kWriteMilliseconds))) {
      return false;
    }
  }
  return true;
}

Result<std::unique_ptr<ByteStream>> connectUnix(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof(address.sun_path)) {
    errno = ENAMETOOLONG;
    return unreachable(path);
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return connected(AF_UNIX, reinterpret_cast<const sockaddr*>(&address), sizeof(address), path);
}

Result<std::unique_ptr<ByteStream>> connectLoopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return connected(AF_INET, reinterpret_cast<const sockaddr*>(&address), sizeof(address),
                   "127.0.0.1:" + std::to_string(port));
}

Result<std::unique_ptr<ByteStream>> openSerial(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return unreachable(path);
  auto stream = std::make_unique<FileStream>(descriptor);
  termios settings{};
  if (::tcgetattr(descriptor, &settings) != 0) return unreachable(path);
  ::cfmakeraw(&settings);
  ::cfsetspeed(&settings, B115200);
  settings.c_cflag |= CLOCAL | CREAD;
  if (::tcsetattr(descriptor, TCSANOW, &settings) != 0) return unreachable(path);
  return std::unique_ptr<ByteStream>(std::move(stream));
}

}  // namespace handwheel
