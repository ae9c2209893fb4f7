// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/ServoClock.h"
#include "haptics/recording/Recording.h"

namespace handwheel {

// Plays a recording in real time, with pause and seek. It determines the current tick. The same clock gives the same
// ticks. One thread.
class RecordingPlayer {
 public:
  // Starts paused at the beginning. The clock must outlive the player.
  RecordingPlayer(Recording recording, ServoClock& clock);

  void play();  // starts from the beginning if it was at the end
  void pause();
  bool isPlaying() const;     // false once the end is reached
  void seek(double seconds);  // limited to the recording; goes on playing if it was
  double position() const;    // s from the beginning
  double duration() const { return m_duration; }

  // Returns the current tick: the last whose time has been reached. Null if the recording is empty.
  const RecordedTick* tick() const;

 private:
  Recording m_recording;
  ServoClock& m_clock;
  double m_duration;        // s
  double m_position = 0.0;  // s, position when it was set last
  bool m_isPlaying = false;
  std::int64_t m_setAt = 0;  // ns, time when it was set last
};

}  // namespace handwheel
