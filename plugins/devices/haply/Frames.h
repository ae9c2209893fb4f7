// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace handwheel::haply {

// Type of a WebSocket frame (RFC 6455, section 5).
enum class Opcode : std::uint8_t { Continuation = 0, Text = 1, Binary = 2, Close = 8, Ping = 9, Pong = 10 };

// Encodes one frame, masked as required for clients.
std::string maskedFrame(Opcode opcode, std::string_view payload, std::uint32_t mask);

// A complete WebSocket message.
struct Message {
  Opcode opcode = Opcode::Text;  // never Continuation
  std::string payload;
};

// Assembles messages from the byte stream of a server, which may arrive in pieces of any size.
class FrameReader {
 public:
  void take(std::span<const std::uint8_t> bytes);
  // Returns the next whole message. Returns nothing if more bytes are needed, or if the stream is broken.
  std::optional<Message> next();
  // Returns true if the server has violated the protocol, or a message is larger than any expected message. No more
  // messages will be returned.
  bool isBroken() const { return m_broken; }

 private:
  struct Header {
    bool isLast = false;
    std::uint8_t opcode = 0;
    std::size_t start = 0;  // start of the payload, in bytes from the first byte of the frame
    std::uint64_t length = 0;
  };
  std::optional<Header> header() const;
  bool isAllowed(const Header& header) const;
  std::optional<Message> finish(const Header& header, std::string payload);

  std::string m_bytes;
  std::optional<Message> m_fragments;  // message of which more frames are to come
  bool m_broken = false;
};

}  // namespace handwheel::haply
