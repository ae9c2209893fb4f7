// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/DeviceHostMessages.h"

#include "haptics/device/DeviceErrors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace handwheel::guard {

namespace {

constexpr std::size_t kHead = 2 * sizeof(std::uint32_t);
constexpr std::size_t kLongestText = 200;  // bytes
constexpr std::size_t kMostArguments = 3;
constexpr auto kLastStatus = static_cast<std::uint32_t>(DeviceStatus::Failed);

// The codes that a session may refuse with, by their numbers in a message. Any other arrives as the first.
constexpr ErrorCode kCodes[] = {DeviceError::Unreachable,    DeviceError::NotResponding, DeviceError::PluginVersion,
                                ErrorCode::Cancelled,        ErrorCode::OutOfMemory,     ErrorCode::FileMissing,
                                ErrorCode::FileUnreadable,   ErrorCode::FileEmpty,       ErrorCode::FileTooLarge,
                                ErrorCode::ReferenceMissing, ErrorCode::Unsupported,     ErrorCode::LibraryFailed};

std::uint32_t numberOf(ErrorCode code) {
  const auto* found = std::find(std::begin(kCodes), std::end(kCodes), code);
  return found == std::end(kCodes) ? 0 : static_cast<std::uint32_t>(found - std::begin(kCodes));
}

// Writes the parts of a message one after the other.
class Out {
 public:
  explicit Out(Buffer& buffer) : m_buffer(buffer) {}
  template <class Number>
  void operator()(const Number& value) {
    std::memcpy(m_buffer.data() + m_size, &value, sizeof(Number));
    m_size += sizeof(Number);
  }
  void operator()(const std::string& text) {
    const auto length = static_cast<std::uint32_t>(std::min(text.size(), kLongestText));
    (*this)(length);
    std::memcpy(m_buffer.data() + m_size, text.data(), length);
    m_size += length;
  }
  std::size_t size() const { return m_size; }

 private:
  Buffer& m_buffer;
  std::size_t m_size = kHead;
};

// Reads the parts of a message. Missing parts, and those that are too long, are zero, and isWhole() is false.
class In {
 public:
  explicit In(std::span<const std::uint8_t> bytes) : m_rest(bytes) {}
  template <class Number>
  void operator()(Number& value) {
    if (!has(sizeof(Number))) return;
    std::memcpy(&value, m_rest.data(), sizeof(Number));
    m_rest = m_rest.subspan(sizeof(Number));
  }
  void operator()(std::string& text) {
    std::uint32_t length = 0;
    (*this)(length);
    if (length > kLongestText || !has(length)) return fail();
    text.assign(reinterpret_cast<const char*>(m_rest.data()), length);
    m_rest = m_rest.subspan(length);
  }
  void fail() { m_isWhole = false; }
  bool isWhole() const { return m_isWhole && m_rest.empty(); }

 private:
  bool has(std::size_t size) {
    m_isWhole = m_isWhole && m_rest.size() >= size;
    return m_isWhole;
  }
  std::span<const std::uint8_t> m_rest;
  bool m_isWhole = true;
};

// Visits every number of a message, in the order of the format, for writing and reading alike.
template <class Each, class Vector>
void eachOf(Each& each, Vector& vector) {
  for (auto& x : vector) each(x);
}

template <class Each, class Number>
void eachAs(Each& each, Number& value) {  // flags and enumerations, as u32
  auto number = static_cast<std::uint32_t>(value);
  each(number);
  if constexpr (!std::is_const_v<Number>) value = static_cast<Number>(number);
}

template <class Each, class Force>
void eachNumber(Each& each, Force& f) {
  eachOf(each, f.force);
  eachOf(each, f.torque);
  each(f.gripper);
}

template <class Each, class State>
void eachNumberOf(Each& each, State& s) {
  eachOf(each, s.position);
  eachOf(each, s.orientation.coeffs());
  eachOf(each, s.velocity);
  each(s.gripper);
  each(s.buttons);
  each(s.reading);
  eachAs(each, s.hasVelocity);
}

template <class Each, class Capabilities>
void eachCapability(Each& each, Capabilities& c) {
  for (auto* whole : {&c.inputs, &c.outputs, &c.buttons}) each(*whole);
  for (auto* number : {&c.maxForce, &c.maxTorque, &c.maxGripperForce, &c.maxStiffness, &c.maxAngularStiffness,
                       &c.maxDamping, &c.workspaceRadius, &c.nominalRate, &c.inherentDamping, &c.latency}) {
    each(*number);
  }
  eachAs(each, c.isRateControl);
}

void write(Out& out, const Open& message) {
  out(message.version);
}
void write(Out& out, const Force& message) {
  out(message.number);
  eachNumber(out, message.force);
}
void write(Out&, const Close&) {}
void write(Out& out, const Opening& message) {
  out(message.fraction);
}
void write(Out& out, const Opened& message) {
  eachCapability(out, message.capabilities);
}
void write(Out& out, const Refused& message) {
  out(numberOf(message.error.code));
  const std::size_t count = std::min(message.error.arguments.size(), kMostArguments);
  out(static_cast<std::uint32_t>(count));
  for (std::size_t i = 0; i < count; ++i) out(message.error.arguments[i]);
  out(message.error.subject);
}
void write(Out& out, const State& message) {
  out(message.number);
  eachNumberOf(out, message.state);
  out(static_cast<std::uint32_t>(message.state.status));
}

void read(In& in, Open& message) {
  in(message.version);
}
void read(In& in, Force& message) {
  in(message.number);
  eachNumber(in, message.force);
  const DeviceForce& force = message.force;
  if (!force.force.allFinite() || !force.torque.allFinite() || !std::isfinite(force.gripper)) in.fail();
}
void read(In&, Close&) {}
void read(In& in, Opening& message) {
  in(message.fraction);
  if (!(message.fraction >= 0.0 && message.fraction <= 1.0)) in.fail();
}
void read(In& in, Opened& message) {
  DeviceCapabilities& c = message.capabilities;
  eachCapability(in, c);
  for (const double number : {c.maxForce, c.maxTorque, c.maxGripperForce, c.maxStiffness, c.maxAngularStiffness,
                              c.maxDamping, c.inherentDamping, c.latency}) {
    if (!(number >= 0.0) || !std::isfinite(number)) in.fail();
  }
  const bool isSane = c.inputs >= 2 && c.inputs <= 7 && c.outputs >= 0 && c.outputs <= 7 && c.buttons >= 0 &&
                      c.buttons <= 32 && c.workspaceRadius > 0.0 && c.workspaceRadius < 1e4 && c.nominalRate >= 1.0 &&
                      c.nominalRate <= 1e5;
  if (!isSane) in.fail();
}
void read(In& in, Refused& message) {
  std::uint32_t code = 0, count = 0;
  in(code);
  in(count);
  if (code >= std::size(kCodes) || count > kMostArguments) return in.fail();
  message.error.code = kCodes[code];
  message.error.arguments.resize(count);
  for (std::string& argument : message.error.arguments) in(argument);
  in(message.error.subject);
}
void read(In& in, State& message) {
  DeviceState& state = message.state;
  std::uint32_t status = 0;
  in(message.number);
  eachNumberOf(in, state);
  in(status);
  const bool isSomewhere = state.position.allFinite() && state.velocity.allFinite() && std::isfinite(state.gripper) &&
                           std::abs(state.orientation.norm() - 1.0) < 1e-6;
  if (status > kLastStatus || !isSomewhere) return in.fail();
  state.orientation.normalize();
  state.status = static_cast<DeviceStatus>(status);
}

template <std::size_t kKind = 0>
std::optional<Message> messageOf(std::size_t kind, std::span<const std::uint8_t> bytes) {
  if constexpr (kKind < std::variant_size_v<Message>) {
    if (kind != kKind) return messageOf<kKind + 1>(kind, bytes);
    std::variant_alternative_t<kKind, Message> message;
    In in(bytes);
    read(in, message);
    if (in.isWhole()) return message;
  }
  return std::nullopt;
}

}  // namespace

std::span<const std::uint8_t> bytesOf(const Message& message, Buffer& buffer) {
  Out out(buffer);
  std::visit([&](const auto& each) { write(out, each); }, message);
  const std::uint32_t head[2] = {static_cast<std::uint32_t>(message.index()),
                                 static_cast<std::uint32_t>(out.size() - kHead)};
  std::memcpy(buffer.data(), head, kHead);
  return std::span(buffer).first(out.size());
}

// Returns true if the message has so many bytes by now.
bool Reader::fill(std::size_t size) {
  const std::size_t count = std::min(size - std::min(size, m_filled), m_rest.size());
  std::copy_n(m_rest.begin(), count, m_message.begin() + static_cast<std::ptrdiff_t>(m_filled));
  m_filled += count;
  m_rest = m_rest.subspan(count);
  return m_filled >= size;
}

std::optional<Message> Reader::next() {
  if (m_isBroken || !fill(kHead)) return std::nullopt;
  std::uint32_t head[2];
  std::memcpy(head, m_message.data(), kHead);
  m_isBroken = head[0] >= std::variant_size_v<Message> || head[1] > kLargestMessage - kHead;
  if (m_isBroken || !fill(kHead + head[1])) return std::nullopt;
  m_filled = 0;
  std::optional<Message> message = messageOf(head[0], std::span(m_message).subspan(kHead, head[1]));
  m_isBroken = !message;
  return message;
}

}  // namespace handwheel::guard
