// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "haply/Frames.h"
#include "io/ByteStream.h"
#include "io/Clock.h"

#include <memory>
#include <random>

namespace handwheel::haply {

// A WebSocket client for a server on the same machine (RFC 6455).
class WebSocket {
 public:
  // Opens the connection by a handshake. Errors: NotResponding, Unreachable.
  static Result<std::unique_ptr<WebSocket>> open(std::unique_ptr<ByteStream> stream, std::shared_ptr<Clock> clock,
                                                 const std::string& host);

  bool send(std::string_view text);
  // Returns the newest text received, or waits up to `timeout` (s) for one. Answers pings. Returns nothing if no text
  // was received.
  std::optional<std::string> receive(double timeout);
  bool isGone() const { return m_gone; }
  void sendClose();

 private:
  WebSocket(std::unique_ptr<ByteStream> stream, std::shared_ptr<Clock> clock)
      : m_stream(std::move(stream)), m_clock(std::move(clock)), m_random(std::random_device()()) {}
  Status shakeHands(const std::string& host);
  bool sendFrame(Opcode opcode, std::string_view payload);
  void heed(const Message& message, std::optional<std::string>& text);

  std::unique_ptr<ByteStream> m_stream;
  std::shared_ptr<Clock> m_clock;
  std::mt19937 m_random;
  FrameReader m_frames;
  bool m_gone = false;
};

}  // namespace handwheel::haply
