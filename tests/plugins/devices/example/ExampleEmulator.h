// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ContractSubject.h"
#include "FakeStream.h"
#include "example/Session.h"
#include "io/ThreadedDevice.h"

#include <optional>

namespace handwheel {

// An emulator of the example device. It answers each force with its position.
struct ExampleEmulator final : Peer {
  void receive(std::span<const std::uint8_t> bytes) override {
    m_partial.insert(m_partial.end(), bytes.begin(), bytes.end());
    for (; m_partial.size() >= 6; m_partial.erase(m_partial.begin(), m_partial.begin() + 6)) {
      Vec3 sent;
      for (int axis = 0; axis < 3; ++axis) {
        sent[axis] = static_cast<std::int16_t>(m_partial[2 * axis] | m_partial[2 * axis + 1] << 8) * 1e-3;
      }
      force = sent;
      for (const std::int16_t number : position) {
        toHost.push_back(static_cast<std::uint8_t>(number & 0xff));
        toHost.push_back(static_cast<std::uint8_t>(number >> 8 & 0xff));
      }
    }
  }

  std::int16_t position[3] = {100, -200, 32767};  // hundredths of a mm
  std::optional<Vec3> force;

 private:
  std::vector<std::uint8_t> m_partial;
};

inline ContractSubject exampleSubject() {
  const auto peer = std::make_shared<ExampleEmulator>();
  const auto clock = std::make_shared<FakeClock>(FakeClock::Pace::Real);
  const auto connect = [=]() -> Result<std::unique_ptr<ByteStream>> {
    return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(peer, clock));
  };
  const auto change = [=](auto act) {
    return [=] {
      const std::lock_guard lock(peer->mutex);
      return act(*peer);
    };
  };
  return {[=] { return std::make_unique<ThreadedDevice>(std::make_unique<ExampleSession>(connect)); },
          change([](ExampleEmulator& e) { e.gone = true; }), change([](ExampleEmulator& e) { e.toHost.push_back(7); }),
          change([](ExampleEmulator& e) { return e.force; })};
}

}  // namespace handwheel
