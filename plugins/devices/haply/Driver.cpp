// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haply/Driver.h"

#include "haply/Session.h"
#include "io/FileStream.h"
#include "io/ThreadedDevice.h"

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace handwheel::haply {

namespace {

constexpr std::uint16_t kPort = 10001;

std::uint16_t port() {
  const char* const text = std::getenv("HANDWHEEL_HAPLY_PORT");
  if (!text) return kPort;
  std::uint16_t number = 0;
  const std::string_view word(text);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() && number > 0 ? number : kPort;
}

std::string contentOf(const char* path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();  // an iterator of the buffer would throw where reading fails
  return text.str();
}

std::string addressOf(std::uint16_t number) {
  return "localhost:" + std::to_string(number);
}

}  // namespace

// Parses lines like "0: 0100007F:2711 00000000:0000 0A …": number, local address and port, remote ones, state (0A:
// listens).
bool listens(std::string_view table, std::uint16_t port) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string wanted = ":";
  for (int shift = 12; shift >= 0; shift -= 4) wanted += kHex[port >> shift & 15];
  while (!table.empty()) {
    const std::string_view line = table.substr(0, table.find('\n'));
    table.remove_prefix(std::min(table.size(), line.size() + 1));
    const std::size_t at = line.find(wanted + ' ');
    if (at == std::string_view::npos) continue;
    const std::string_view rest = line.substr(at + wanted.size() + 1);
    const std::size_t blank = rest.find(' ');
    if (blank != std::string_view::npos && rest.substr(blank).starts_with(" 0A")) return true;
  }
  return false;
}

std::vector<DeviceInfo> Driver::find() {
  const std::uint16_t number = port();
  for (const char* const table : {"/proc/net/tcp", "/proc/net/tcp6"}) {
    if (listens(contentOf(table), number)) return {{id(), addressOf(number), "Haply Inverse3"}};
  }
  return {};
}

std::unique_ptr<Device> Driver::make(const std::string& address) {
  const std::uint16_t number = port();
  if (address != addressOf(number)) return nullptr;
  const auto connect = [number] { return connectLoopback(number); };
  return std::make_unique<ThreadedDevice>(std::make_unique<Session>(connect, std::make_shared<SteadyClock>()));
}

}  // namespace handwheel::haply
