// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/SessionHost.h"

#include "haptics/device/DeviceErrors.h"

#include <chrono>
#include <future>

namespace handwheel::guard {

namespace {

constexpr double kOpenWait = 10.0;         // s, for the program's first word
constexpr double kOpeningWordTime = 0.02;  // s between words while the device is being opened
constexpr double kSilentTime = 0.005;      // s between zero forces in a silence

}  // namespace

void SessionHost::serve() {
  if (waitForOpen() && open()) run();
  m_session.close();
}

bool SessionHost::waitForOpen() {
  const double end = m_clock.now() + kOpenWait;
  while (!m_open && !m_isLeft && !m_stop && m_clock.now() < end) listen(kOpeningWordTime);
  if (!m_open || m_isLeft) return false;
  if (m_open->version == kVersion) return true;
  const auto text = [](std::uint32_t version) { return std::to_string(version); };
  send(Refused{{DeviceError::PluginVersion, {text(m_open->version), text(kVersion)}, {}, {}}});
  return false;
}

// Opens the device, which may take its time. Meanwhile the program is told the progress, and may cancel.
bool SessionHost::open() {
  JobState job;
  auto opening = std::async(std::launch::async, [&] { return m_session.open(Progress(job)); });
  while (opening.wait_for(std::chrono::duration<double>(0.0)) != std::future_status::ready) {
    send(Opening{job.fraction});
    listen(kOpeningWordTime);
    if (m_isLeft || m_stop) job.cancelled = true;
    if (m_isLeft) opening.wait();
  }
  const Status opened = opening.get();
  if (!opened) return send(Refused{opened.error()}) && false;
  return !m_isLeft && !m_stop && send(Opened{m_session.capabilities()});
}

void SessionHost::run() {
  double heard = m_clock.now();
  while (!m_isLeft && !m_stop) {
    const double since = m_clock.now() - heard;
    listen(m_hasBeenSilent ? kSilentTime : std::max(0.0, kSilence - since));
    if (m_isLeft) return;
    if (m_force) {
      heard = m_clock.now();
      if (!answer(*std::exchange(m_force, std::nullopt))) return;
    } else if (m_clock.now() - heard >= kSilence) {
      m_hasBeenSilent = true;
      m_restEnd.reset();
      (void)m_session.exchange({});
    }
  }
}

// Processes messages that come within the time; returns with the first.
bool SessionHost::listen(double timeout) {
  std::array<std::uint8_t, 2 * kLargestMessage> bytes{};
  const std::ptrdiff_t count = m_stream.read(bytes, timeout);
  if (count == kGone) m_isLeft = true;
  if (count <= 0) return false;
  m_reader.add(std::span(bytes).first(static_cast<std::size_t>(count)));
  while (const std::optional<Message> message = m_reader.next()) {
    if (const auto* wanted = std::get_if<Open>(&*message)) m_open = *wanted;
    if (const auto* force = std::get_if<Force>(&*message)) m_force = *force;
    if (std::holds_alternative<Close>(*message)) m_isLeft = true;
  }
  if (m_reader.isBroken()) m_isLeft = true;
  return true;
}

bool SessionHost::answer(const Force& asked) {
  if (!m_restEnd) m_restEnd = m_clock.now() + kRest;
  if (m_hasBeenSilent && asked.force.isZero() && m_clock.now() >= *m_restEnd) m_hasBeenSilent = false;
  State answer{asked.number, m_session.exchange(m_hasBeenSilent ? DeviceForce() : asked.force)};
  if (m_hasBeenSilent && answer.state.status == DeviceStatus::Ready) answer.state.status = DeviceStatus::Starting;
  return send(answer);
}

bool SessionHost::send(const Message& message) {
  if (!m_stream.write(bytesOf(message, m_out))) m_isLeft = true;
  return !m_isLeft;
}

}  // namespace handwheel::guard
