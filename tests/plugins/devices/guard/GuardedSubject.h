// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ContractSubject.h"
#include "io/FileStream.h"
#include "io/OutOfProcessSession.h"
#include "io/SessionHost.h"
#include "io/ThreadedDevice.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <thread>

namespace handwheel {

// A host for a session on its own thread, connected by a real socket. It is a complete guard except for the process.
class HostedSession {
 public:
  using Make = std::function<std::unique_ptr<Session>()>;
  explicit HostedSession(Make make) : m_make(std::move(make)) {}
  ~HostedSession() { end(); }

  // Starts a new host, like a new process. The previous host must have ended.
  std::unique_ptr<ByteStream> start() {
    end();
    int ends[2] = {};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends) != 0) return nullptr;
    m_stop = false;
    m_thread = std::thread([this, descriptor = ends[1]] {
      FileStream stream(descriptor);
      SteadyClock clock;
      const std::unique_ptr<Session> session = m_make();
      guard::SessionHost(*session, stream, clock, m_stop).serve();
    });
    return std::make_unique<FileStream>(ends[0]);
  }
  void end() {
    m_stop = true;
    if (m_thread.joinable()) m_thread.join();
  }
  // Ends the host in the same manner as a request to end the process.
  void stop() { m_stop = true; }

 private:
  Make m_make;
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

// Returns a contract subject whose device is held by a host.
inline ContractSubject guardedSubject(const std::shared_ptr<HostedSession>& host, const DeviceCapabilities& kind,
                                      const ContractSubject& of) {
  ContractSubject subject = of;
  subject.make = [=] {
    const auto connect = [host]() -> Result<std::unique_ptr<ByteStream>> { return host->start(); };
    return std::make_unique<ThreadedDevice>(
        std::make_unique<OutOfProcessSession>(connect, std::make_shared<SteadyClock>(), kind, "guarded"));
  };
  return subject;
}

}  // namespace handwheel
