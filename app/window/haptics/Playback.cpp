// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/Playback.h"

namespace handwheel {

namespace {
constexpr int kPlaybackFrameMs = 16;  // 60 a second
}

Playback::Playback(ServoClock& clock, QObject* parent) : QObject(parent), m_clock(clock) {
  m_timer.setInterval(kPlaybackFrameMs);
  m_timer.setTimerType(Qt::PreciseTimer);
  connect(&m_timer, &QTimer::timeout, this, &Playback::follow);
}

void Playback::takeUp(const StoredRecording& recording) {
  m_player.emplace(recording.ticks, m_clock);
  m_key = recording.key;
  m_limit = recording.forceLimit > 0.0 ? recording.forceLimit : 1.0;
  follow();
}

void Playback::leave() {
  if (!m_player) return;
  m_player.reset();
  m_key.clear();
  follow();
}

void Playback::play() {
  if (!m_player) return;
  m_player->play();
  m_timer.start();
  follow();
}

void Playback::pause() {
  if (!m_player) return;
  m_player->pause();
  follow();
}

void Playback::seek(double seconds) {
  if (!m_player) return;
  m_player->seek(seconds);
  follow();
}

std::optional<DeviceCursor> Playback::cursor() const {
  const RecordedTick* const tick = m_player ? m_player->tick() : nullptr;
  if (!tick || tick->status != DeviceStatus::Ready) return std::nullopt;
  DeviceCursor cursor;
  cursor.tip = tick->tip.position;
  cursor.proxy = tick->felt.proxy.allFinite() ? tick->felt.proxy : tick->tip.position;
  if (tick->felt.force.allFinite()) cursor.force = tick->felt.force;
  cursor.limit = m_limit;
  return cursor;
}

void Playback::follow() {
  if (!isPlaying()) m_timer.stop();
  emit moved();
}

}  // namespace handwheel
