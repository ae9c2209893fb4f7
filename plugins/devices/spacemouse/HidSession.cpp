// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/HidSession.h"

#include <array>

namespace handwheel::spacemouse {

namespace {

constexpr double kReportTime = 0.016;  // s from one report to the next
constexpr int kMostAtOnce = 16;        // reports that are read before the state is reported
constexpr std::uint8_t kLamp = 4;

}  // namespace

Status HidSession::open(Progress) {
  auto transport = m_connect();
  if (!transport) return transport.error();
  m_transport = std::move(transport.value());
  m_reports = {};
  light(true);
  return Done{};
}

DeviceState HidSession::exchange(const DeviceForce&) noexcept {
  if (m_transport) readReports();
  if (!m_transport) return {};
  if (m_clock->now() - m_lastMotion > kHeld) m_reports.rest();
  DeviceState state;
  state.status = DeviceStatus::Ready;
  state.buttons = m_reports.buttons();
  setPose(m_reports.counts(), state);
  return state;
}

void HidSession::close() noexcept {
  if (m_transport) light(false);
  m_transport.reset();
}

void HidSession::readReports() noexcept {
  std::array<std::uint8_t, 64> report{};
  for (int i = 0; i < kMostAtOnce; ++i) {
    const std::ptrdiff_t length = m_transport->read(report, i == 0 ? kReportTime : 0.0);
    if (length == kGone) m_transport.reset();
    if (length <= 0) return;
    if (m_reports.take(std::span(report).first(static_cast<std::size_t>(length)))) m_lastMotion = m_clock->now();
  }
}

void HidSession::light(bool on) noexcept {
  const std::array<std::uint8_t, 2> report = {kLamp, static_cast<std::uint8_t>(on)};
  (void)m_transport->write(report);  // those without a lamp refuse it
}

}  // namespace handwheel::spacemouse
