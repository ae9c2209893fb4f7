// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/ServoClock.h"
#include "haptics/recording/Recording.h"

namespace handwheel {

// Plays a recording in real time, with pause and seek. It determines the current tick. The same clock gives the same
// ticks. A player must be used by one thread only.
class RecordingPlayer {
 public:
  // The player is paused at the beginning of the recording. The clock must outlive it.
  RecordingPlayer(Recording recording, ServoClock& clock);

  void play();  // starts from the beginning if the end was reached
  void pause();
  bool isPlaying() const;     // false once the end is reached
  void seek(double seconds);  // the position is limited to the recording; a playing player continues to play
  double position() const;    // s from the beginning
  double duration() const { return m_duration; }

  // Returns the current tick, which is the last tick whose time has been reached. Returns null if the recording is
  // empty.
  const RecordedTick* tick() const;

 private:
  Recording m_recording;
  ServoClock& m_clock;
  double m_duration;        // s
  double m_position = 0.0;  // s, the position that was set last
  bool m_isPlaying = false;
  std::int64_t m_setAt = 0;  // ns, the time at which the position was set last
};

}  // namespace handwheel
