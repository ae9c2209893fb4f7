// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace handwheel::haply {

// Frames of a WebSocket (RFC 6455, section 5), as a client sends and reads them.
enum class Opcode : std::uint8_t { Continuation = 0, Text = 1, Binary = 2, Close = 8, Ping = 9, Pong = 10 };

// One frame, masked as a client must.
std::string maskedFrame(Opcode opcode, std::string_view payload, std::uint32_t mask);

struct Message {
  Opcode opcode = Opcode::Text;  // never Continuation
  std::string payload;
};

// Puts messages together from what a server sends, in pieces of any size.
class FrameReader {
 public:
  void take(std::span<const std::uint8_t> bytes);
  // The next whole message; nothing when more bytes are needed, or when the stream is broken.
  std::optional<Message> next();
  // The server does not speak the protocol, or a message is larger than any that is expected. Nothing more will come.
  bool isBroken() const { return m_broken; }

 private:
  struct Header {
    bool isLast = false;
    std::uint8_t opcode = 0;
    std::size_t start = 0;  // of the payload, from the frame's first byte
    std::uint64_t length = 0;
  };
  std::optional<Header> header() const;
  bool isAllowed(const Header& header) const;
  std::optional<Message> finish(const Header& header, std::string payload);

  std::string m_bytes;
  std::optional<Message> m_fragments;  // a message of which more frames are to come
  bool m_broken = false;
};

}  // namespace handwheel::haply
