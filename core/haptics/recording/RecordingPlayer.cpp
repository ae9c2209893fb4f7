// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordingPlayer.h"

#include <algorithm>

namespace handwheel {

RecordingPlayer::RecordingPlayer(Recording recording, ServoClock& clock)
    : m_recording(std::move(recording)), m_clock(clock), m_duration(m_recording.duration()) {}

void RecordingPlayer::play() {
  if (isPlaying()) return;
  seek(m_position < m_duration ? m_position : 0.0);
  m_isPlaying = true;
}

void RecordingPlayer::pause() {
  seek(position());
  m_isPlaying = false;
}

bool RecordingPlayer::isPlaying() const {
  return m_isPlaying && position() < m_duration;
}

void RecordingPlayer::seek(double seconds) {
  m_isPlaying = isPlaying();
  m_position = seconds > 0.0 ? std::min(seconds, m_duration) : 0.0;  // NaN, too
  m_setAt = m_clock.now();
}

double RecordingPlayer::position() const {
  if (!m_isPlaying) return m_position;
  const double since = static_cast<double>(m_clock.now() - m_setAt) / kNanoseconds;
  return std::clamp(m_position + since, 0.0, m_duration);
}

// A recording that was written by hand may have decreasing times: then some tick is returned, always the same.
const RecordedTick* RecordingPlayer::tick() const {
  if (m_recording.size() == 0) return nullptr;
  const double at = position();
  if (at >= m_duration) return &m_recording[m_recording.size() - 1];  // the sum below may be rounded to before it
  const double time = m_recording[0].tip.time + at;
  std::size_t low = 0, high = m_recording.size();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (m_recording[middle].tip.time <= time ? low : high) = middle;
  }
  return &m_recording[low];
}

}  // namespace handwheel
