// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ContractSubject.h"
#include "FakeClock.h"
#include "FakeStream.h"
#include "io/ThreadedDevice.h"
#include "spacemouse/HidSession.h"
#include "spacemouse/SocketSession.h"

#include <cstring>

namespace handwheel {

using Report = std::vector<std::uint8_t>;

// An emulator of a SpaceMouse. It consists of the reports that wait to be read, and the lamp. It may be used on any
// thread.
struct SpaceMouseEmulator {
  std::mutex mutex;
  std::deque<Report> reports;
  bool lamp = false;
  bool gone = false;
};

class FakeHid final : public HidTransport {
 public:
  FakeHid(std::shared_ptr<SpaceMouseEmulator> mouse, std::shared_ptr<FakeClock> clock)
      : m_mouse(std::move(mouse)), m_clock(std::move(clock)) {}

  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept override {
    m_clock->pace();
    const std::lock_guard lock(m_mouse->mutex);
    if (m_mouse->gone) return kGone;
    if (m_mouse->reports.empty()) {
      m_clock->sleep(timeout);
      return 0;
    }
    const Report report = std::move(m_mouse->reports.front());
    m_mouse->reports.pop_front();
    const std::size_t length = std::min(report.size(), into.size());
    std::copy_n(report.begin(), length, into.begin());
    return static_cast<std::ptrdiff_t>(length);
  }

  bool write(std::span<const std::uint8_t> report) noexcept override {
    const std::lock_guard lock(m_mouse->mutex);
    if (m_mouse->gone) return false;
    if (report.size() == 2 && report[0] == 4) m_mouse->lamp = report[1] & 1;
    return true;
  }

 private:
  std::shared_ptr<SpaceMouseEmulator> m_mouse;
  std::shared_ptr<FakeClock> m_clock;
};

inline std::unique_ptr<spacemouse::HidSession> hidSession(const std::shared_ptr<SpaceMouseEmulator>& mouse,
                                                          const std::shared_ptr<FakeClock>& clock) {
  const auto connect = [=]() -> Result<std::unique_ptr<HidTransport>> {
    return std::unique_ptr<HidTransport>(std::make_unique<FakeHid>(mouse, clock));
  };
  return std::make_unique<spacemouse::HidSession>(connect, clock, 2);
}

inline ContractSubject spaceMouseHidSubject() {
  const auto mouse = std::make_shared<SpaceMouseEmulator>();
  const auto clock = std::make_shared<FakeClock>(FakeClock::Pace::Real);
  return {[=] { return std::make_unique<ThreadedDevice>(hidSession(mouse, clock)); },
          [=] {
            const std::lock_guard lock(mouse->mutex);
            mouse->gone = true;
          },
          [=] {
            const std::lock_guard lock(mouse->mutex);
            mouse->reports.push_back({1, 0xff, 0x7f, 0x00, 0x80, 0xff});
            mouse->reports.push_back({1, 0xff, 0x7f, 0x00, 0x80, 0xff, 0x7f, 9});
            mouse->reports.push_back({2, 0xff, 0x7f, 0x00, 0x80, 0xff, 0x7f});
            mouse->reports.push_back({77});
          },
          nullptr};
}

// An emulator of the daemon spacenavd as its clients see it.
struct SpaceNavEmulator final : Peer {
  void receive(std::span<const std::uint8_t>) override {}
  void send(const std::array<std::int32_t, 8>& record) {
    std::uint8_t bytes[sizeof(record)];
    std::memcpy(bytes, record.data(), sizeof(record));
    toHost.insert(toHost.end(), std::begin(bytes), std::end(bytes));
  }
};

inline ContractSubject spaceNavSubject() {
  const auto peer = std::make_shared<SpaceNavEmulator>();
  const auto clock = std::make_shared<FakeClock>(FakeClock::Pace::Real);
  const auto connect = [=]() -> Result<std::unique_ptr<ByteStream>> {
    return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(peer, clock));
  };
  return {[=] { return std::make_unique<ThreadedDevice>(std::make_unique<spacemouse::SocketSession>(connect)); },
          [=] {
            const std::lock_guard lock(peer->mutex);
            peer->gone = true;
          },
          [=] {
            const std::lock_guard lock(peer->mutex);
            peer->send({0, INT32_MIN, INT32_MAX, INT32_MIN, INT32_MIN, INT32_MAX, 1, 0});
            peer->toHost.push_back(9);
          },
          nullptr};
}

}  // namespace handwheel
