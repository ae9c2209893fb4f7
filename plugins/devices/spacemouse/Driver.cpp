// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/Driver.h"

#include "io/FileStream.h"
#include "io/ThreadedDevice.h"
#include "spacemouse/SocketSession.h"

#include <sys/stat.h>
#include <algorithm>

namespace handwheel::spacemouse {

namespace {

constexpr double kAskAgain = 30.0;  // s

// Returns a text that changes when the socket is created anew; empty when there is none.
std::string identityOf(const std::string& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0 || !S_ISSOCK(found.st_mode)) return {};
  return std::to_string(found.st_dev) + ' ' + std::to_string(found.st_ino) + ' ' +
         std::to_string(found.st_ctim.tv_sec) + ' ' + std::to_string(found.st_ctim.tv_nsec);
}

}  // namespace

std::vector<DeviceInfo> Driver::find() {
  if (const auto path = daemon()) return {{id(), *path, "SpaceMouse (spacenavd)"}};
  std::vector<DeviceInfo> all;
  for (const Hid::Entry& entry : m_hid.find()) all.push_back({id(), entry.path, entry.name});
  return all;
}

std::unique_ptr<Device> Driver::make(const std::string& address) {
  std::unique_ptr<Session> session;
  if (const auto path = daemon()) {
    if (address == *path) session = std::make_unique<SocketSession>([address] { return connectUnix(address); });
  } else {
    for (const Hid::Entry& entry : m_hid.find()) {
      if (entry.path != address) continue;
      const auto connect = [open = m_hid.open, address] { return open(address); };
      session = std::make_unique<HidSession>(connect, m_clock, entry.buttons);
    }
  }
  return session ? std::make_unique<ThreadedDevice>(std::move(session)) : nullptr;
}

std::optional<std::string> Driver::daemon() {
  const auto found =
      std::find_if(m_sockets.begin(), m_sockets.end(), [this](const auto& path) { return answers(path); });
  return found == m_sockets.end() ? std::nullopt : std::optional(*found);
}

bool Driver::answers(const std::string& path) {
  const std::string identity = identityOf(path);
  if (identity.empty()) return false;
  Asked& asked = m_asked[path];
  const double now = m_clock->now();
  if (asked.identity != identity || now - asked.at > kAskAgain) {
    asked = {identity, now, connectUnix(path).hasValue()};
  }
  return asked.listening;
}

}  // namespace handwheel::spacemouse
