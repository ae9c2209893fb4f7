// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/StoredRecording.h"
#include "haptics/recording/RecordingPlayer.h"
#include "viewport/DeviceCursor.h"

#include <QObject>
#include <QTimer>
#include <optional>

namespace handwheel {

// Plays back a recording by moving the device cursor at the recorded speed. No timer runs while no recording is loaded
// or playing is paused. Must be used on the window thread.
class Playback : public QObject {
  Q_OBJECT

 public:
  explicit Playback(ServoClock& clock, QObject* parent = nullptr);  // the clock must outlive this object

  void takeUp(const StoredRecording& recording);  // loads a recording, paused at its beginning
  void leave();
  bool isRecordingLoaded() const { return m_player.has_value(); }
  const std::string& key() const { return m_key; }  // key of the loaded recording

  void play();
  void pause();
  void seek(double seconds);
  bool isPlaying() const { return m_player && m_player->isPlaying(); }
  double position() const { return m_player ? m_player->position() : 0.0; }  // s
  double duration() const { return m_player ? m_player->duration() : 0.0; }

  // Returns the cursor at the present position. The result is empty if no recording is loaded or the device had no
  // valid position.
  std::optional<DeviceCursor> cursor() const;

 signals:
  void moved();  // the position has changed, playing started or stopped, or the recording was unloaded

 private:
  void follow();

  ServoClock& m_clock;
  std::optional<RecordingPlayer> m_player;
  std::string m_key;
  double m_limit = 1.0;  // N
  QTimer m_timer;
};

}  // namespace handwheel
