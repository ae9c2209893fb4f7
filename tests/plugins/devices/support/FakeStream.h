// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FakeClock.h"
#include "io/ByteStream.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace handwheel {

// The other end of a FakeStream: a model of a device. Its mutex is held during each call of its functions; tests must
// also hold it while they read or change the model.
class Peer {
 public:
  virtual ~Peer() = default;
  // Receives bytes from the host. Answers are appended to toHost.
  virtual void receive(std::span<const std::uint8_t> bytes) = 0;

  std::mutex mutex;
  std::deque<std::uint8_t> toHost;
  std::size_t longestRead = 4096;  // largest number of bytes per read
  bool gone = false;
};

class FakeStream final : public ByteStream {
 public:
  FakeStream(std::shared_ptr<Peer> peer, std::shared_ptr<FakeClock> clock)
      : m_peer(std::move(peer)), m_clock(std::move(clock)) {}

  std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept override {
    m_clock->pace();
    const std::lock_guard lock(m_peer->mutex);
    if (m_peer->gone) return kGone;
    std::deque<std::uint8_t>& waiting = m_peer->toHost;
    if (waiting.empty()) m_clock->sleep(timeout);
    const auto count = static_cast<std::ptrdiff_t>(std::min({waiting.size(), into.size(), m_peer->longestRead}));
    std::copy_n(waiting.begin(), count, into.begin());
    waiting.erase(waiting.begin(), waiting.begin() + count);
    return count;
  }

  bool write(std::span<const std::uint8_t> bytes) noexcept override {
    const std::lock_guard lock(m_peer->mutex);
    if (m_peer->gone) return false;
    m_peer->receive(bytes);
    return true;
  }

 private:
  std::shared_ptr<Peer> m_peer;
  std::shared_ptr<FakeClock> m_clock;
};

}  // namespace handwheel
