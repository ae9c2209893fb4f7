// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ContractSubject.h"
#include "FakeStream.h"
#include "io/ThreadedDevice.h"
#include "polhem/Session.h"

#include <cstdio>
#include <sstream>
#include <string>

namespace handwheel {

// An emulator of the board of a Polhem. It receives and sends lines of 64 bytes, in the format that its firmware uses.
struct PolhemEmulator final : Peer {
  double position[3] = {-59.276, 13.383, -148.002};
  double angles[4] = {0.0919, -1.8483, 1.0370, -1.9512};
  int booting = 0;  // number of following lines that are lost while it boots
  bool stalled = false;
  bool lateOnce = false;  // the next answer is kept in `late`
  std::size_t loses = 0;  // bytes lost from the middle of each line
  std::optional<Vec3> force;
  std::string late;

  void receive(std::span<const std::uint8_t> bytes) override {
    m_in.append(bytes.begin(), bytes.end());
    for (std::size_t end = m_in.find('\n'); end != std::string::npos; end = m_in.find('\n')) {
      heed(m_in.substr(0, end));
      m_in.erase(0, end + 1);
    }
  }

  std::string line() const {
    char text[128];
    const int length =
        std::snprintf(text, sizeof(text), "% 8.3f % 8.3f % 8.3f % 7.4f % 7.4f % 7.4f % 7.4f %d\n", position[0],
                      position[1], position[2], angles[0], angles[1], angles[2], angles[3], 0);
    std::string padded(text, static_cast<std::size_t>(length));
    padded.resize(63, ' ');
    return padded + '\n';
  }

 private:
  void heed(const std::string& text) {
    if (text.size() != 63) return;
    std::istringstream words(text);
    int numbers[7] = {};
    for (int& number : numbers) words >> number;
    if (!words || numbers[3] != 2) return;
    if (booting-- > 0) return;
    force = 1e-3 * Vec3(numbers[0], numbers[1], numbers[2]);
    std::string answer = line();
    answer.erase(20, loses);
    if (stalled) return;
    if (lateOnce) {
      late = answer;
    } else {
      toHost.insert(toHost.end(), answer.begin(), answer.end());
    }
    lateOnce = false;
  }

  std::string m_in;
};

inline std::unique_ptr<polhem::Session> polhemSession(const std::shared_ptr<PolhemEmulator>& peer,
                                                      const std::shared_ptr<FakeClock>& clock) {
  const auto connect = [=]() -> Result<std::unique_ptr<ByteStream>> {
    return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(peer, clock));
  };
  return std::make_unique<polhem::Session>(connect, clock);
}

inline ContractSubject polhemSubject(
    const std::shared_ptr<PolhemEmulator>& peer = std::make_shared<PolhemEmulator>(),
    const std::shared_ptr<FakeClock>& clock = std::make_shared<FakeClock>(FakeClock::Pace::Real)) {
  return {
      [=] { return std::make_unique<ThreadedDevice>(polhemSession(peer, clock)); },
      [=] {
        const std::lock_guard lock(peer->mutex);
        peer->gone = true;
      },
      [=] {
        const std::lock_guard lock(peer->mutex);
        for (const char c : std::string("nan inf 1e999 1e5 0 0 0 0                                        1\n\xff\n")) {
          peer->toHost.push_back(static_cast<std::uint8_t>(c));
        }
      },
      [=]() -> std::optional<Vec3> {
        const std::lock_guard lock(peer->mutex);
        if (!peer->force) return {};
        return Vec3(peer->force->y(), peer->force->z(), peer->force->x());
      }};
}

}  // namespace handwheel
