// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Recording.h"
#include "haptics/ServoClock.h"

namespace handwheel {

// Says which tick of a recording is to be seen now: it runs as fast as time did, stands still where it is paused, and
// may be set anywhere. The same clock gives the same ticks. One thread.
class RecordingPlayer {
 public:
  // The clock outlives it. Paused at the beginning.
  RecordingPlayer(Recording recording, ServoClock& clock);

  void play();  // from the beginning where it was at the end
  void pause();
  bool isPlaying() const;     // not any more, once the end is reached
  void seek(double seconds);  // kept within the recording; goes on playing if it was
  double position() const;    // s from the beginning
  double duration() const { return m_duration; }

  // The last whose time has come. Null: the recording is empty.
  const RecordedTick* tick() const;

 private:
  Recording m_recording;
  ServoClock& m_clock;
  double m_duration;        // s
  double m_position = 0.0;  // s, when it was set last
  bool m_isPlaying = false;
  std::int64_t m_setAt = 0;  // ns
};

}  // namespace handwheel
