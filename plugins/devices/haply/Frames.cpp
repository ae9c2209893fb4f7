// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haply/Frames.h"

#include <array>

namespace handwheel::haply {

namespace {

constexpr std::uint8_t kFinal = 0x80, kReserved = 0x70, kOpcode = 0x0f, kMasked = 0x80, kShort = 0x7f;
constexpr std::uint8_t k16Bits = 126, k64Bits = 127;
constexpr std::size_t kLargest = 1 << 20;  // bytes of a message; an inventory has some thousands
constexpr std::uint64_t kLargestControl = 125;

bool isControl(std::uint8_t opcode) {
  return opcode >= 8;
}

std::uint8_t byteAt(const std::string& bytes, std::size_t i) {
  return static_cast<std::uint8_t>(bytes[i]);
}

void appendBigEndian(std::string& bytes, std::uint64_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
}

}  // namespace

std::string maskedFrame(Opcode opcode, std::string_view payload, std::uint32_t mask) {
  std::string frame(1, static_cast<char>(kFinal | static_cast<std::uint8_t>(opcode)));
  const std::size_t size = payload.size();
  if (size < k16Bits) {
    frame += static_cast<char>(kMasked | size);
  } else if (size <= 0xffff) {
    frame += static_cast<char>(kMasked | k16Bits);
    appendBigEndian(frame, size, 2);
  } else {
    frame += static_cast<char>(kMasked | k64Bits);
    appendBigEndian(frame, size, 8);
  }
  appendBigEndian(frame, mask, 4);
  for (std::size_t i = 0; i < size; ++i) {
    frame += static_cast<char>(static_cast<std::uint8_t>(payload[i]) ^ (mask >> (24 - 8 * (i % 4)) & 0xff));
  }
  return frame;
}

void FrameReader::take(std::span<const std::uint8_t> bytes) {
  if (!m_broken) m_bytes.append(bytes.begin(), bytes.end());
}

std::optional<Message> FrameReader::next() {
  while (!m_broken) {
    const std::optional<Header> head = header();
    if (!head) return {};
    m_broken = !isAllowed(*head);
    if (m_broken || m_bytes.size() - head->start < head->length) return {};
    const auto length = static_cast<std::size_t>(head->length);
    std::string payload = m_bytes.substr(head->start, length);
    m_bytes.erase(0, head->start + length);
    if (std::optional<Message> message = finish(*head, std::move(payload))) return message;
  }
  return {};
}

// Returns nothing if the header is not complete.
std::optional<FrameReader::Header> FrameReader::header() const {
  if (m_bytes.size() < 2) return {};
  Header head;
  head.isLast = byteAt(m_bytes, 0) & kFinal;
  head.opcode = byteAt(m_bytes, 0) & kOpcode;
  head.length = byteAt(m_bytes, 1) & kShort;
  const std::size_t more = head.length == k16Bits ? 2 : head.length == k64Bits ? 8 : 0;
  head.start = 2 + more;
  if (m_bytes.size() < head.start) return {};
  if (more > 0) head.length = 0;
  for (std::size_t i = 0; i < more; ++i) head.length = head.length << 8 | byteAt(m_bytes, 2 + i);
  return head;
}

// Returns true if the frame is valid: a server's frames are not masked; control frames are short and whole; a fragment
// continues one, and only one.
bool FrameReader::isAllowed(const Header& head) const {
  if ((byteAt(m_bytes, 0) & kReserved) != 0 || (byteAt(m_bytes, 1) & kMasked) != 0) return false;
  if (isControl(head.opcode)) return head.opcode <= 10 && head.isLast && head.length <= kLargestControl;
  const std::size_t before = m_fragments ? m_fragments->payload.size() : 0;
  return head.opcode <= 2 && (head.opcode == 0) == m_fragments.has_value() && head.length <= kLargest - before;
}

std::optional<Message> FrameReader::finish(const Header& head, std::string payload) {
  if (isControl(head.opcode)) return Message{static_cast<Opcode>(head.opcode), std::move(payload)};
  if (m_fragments) {
    m_fragments->payload += payload;
  } else {
    m_fragments = Message{static_cast<Opcode>(head.opcode), std::move(payload)};
  }
  if (!head.isLast) return {};
  std::optional<Message> whole = std::move(m_fragments);
  m_fragments.reset();
  return whole;
}

}  // namespace handwheel::haply
