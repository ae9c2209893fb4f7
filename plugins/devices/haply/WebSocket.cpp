// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haply/WebSocket.h"

#include "haply/Handshake.h"
#include "haptics/device/DeviceErrors.h"

#include <algorithm>
#include <array>

namespace handwheel::haply {

namespace {

constexpr double kHandshakeTime = 2.0;      // s
constexpr std::size_t kLargestHead = 8192;  // bytes of the server's answer
constexpr std::string_view kEndOfHead = "\r\n\r\n";

std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

Result<std::unique_ptr<WebSocket>> WebSocket::open(std::unique_ptr<ByteStream> stream, std::shared_ptr<Clock> clock,
                                                   const std::string& host) {
  std::unique_ptr<WebSocket> socket(new WebSocket(std::move(stream), std::move(clock)));
  const Status shaken = socket->shakeHands(host);
  if (!shaken) return shaken.error();
  return socket;
}

Status WebSocket::shakeHands(const std::string& host) {
  const Error mute{DeviceError::NotResponding, {"the handshake of a WebSocket"}, {}, host};
  const std::string key = handshakeKey();
  if (!m_stream->write(bytesOf(upgradeRequest(host, key)))) return mute;
  std::string head;
  std::array<std::uint8_t, 1024> bytes{};
  const double end = m_clock->now() + kHandshakeTime;
  while (head.find(kEndOfHead) == std::string::npos) {
    const std::ptrdiff_t count = m_stream->read(bytes, std::max(0.0, end - m_clock->now()));
    if (count == kGone || head.size() > kLargestHead || (count == 0 && m_clock->now() >= end)) return mute;
    head.append(bytes.begin(), bytes.begin() + count);
  }
  const std::size_t length = head.find(kEndOfHead);
  if (!isUpgradeAccepted(std::string_view(head).substr(0, length), key)) return mute;
  m_frames.take(bytesOf(std::string_view(head).substr(length + kEndOfHead.size())));
  return Done{};
}

bool WebSocket::send(std::string_view text) {
  return sendFrame(Opcode::Text, text);
}

bool WebSocket::sendFrame(Opcode opcode, std::string_view payload) {
  if (m_gone) return false;
  m_gone = !m_stream->write(bytesOf(maskedFrame(opcode, payload, static_cast<std::uint32_t>(m_random()))));
  return !m_gone;
}

std::optional<std::string> WebSocket::receive(double timeout) {
  std::optional<std::string> text;
  std::array<std::uint8_t, 4096> bytes{};
  const double end = m_clock->now() + timeout;
  while (!m_gone) {
    while (const std::optional<Message> message = m_frames.next()) heed(*message, text);
    if (m_gone || m_frames.isBroken()) break;
    const double left = text ? 0.0 : std::max(0.0, end - m_clock->now());
    const std::ptrdiff_t count = m_stream->read(bytes, left);
    if (count == kGone) break;
    if (count == 0 && (text || m_clock->now() >= end)) return text;
    m_frames.take(std::span(bytes).first(static_cast<std::size_t>(count)));
  }
  m_gone = true;
  return text;
}

void WebSocket::heed(const Message& message, std::optional<std::string>& text) {
  if (message.opcode == Opcode::Text) text = message.payload;
  if (message.opcode == Opcode::Ping) (void)sendFrame(Opcode::Pong, message.payload);
  if (message.opcode == Opcode::Close) m_gone = true;
}

void WebSocket::sendClose() {
  (void)sendFrame(Opcode::Close, {});
}

}  // namespace handwheel::haply
