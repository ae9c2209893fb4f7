// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/KeptRecording.h"
#include "haptics/RecordingPlayer.h"
#include "viewport/DeviceCursor.h"

#include <QObject>
#include <QTimer>
#include <optional>

namespace handwheel {

// A recording that is looked at: the cursor follows it as fast as the hand went. Nothing runs while none is taken up,
// or it stands still. Window thread.
class Playback : public QObject {
  Q_OBJECT

 public:
  explicit Playback(ServoClock& clock, QObject* parent = nullptr);  // the clock outlives it

  void takeUp(const KeptRecording& recording);  // paused at its beginning
  void leave();
  bool isTakenUp() const { return m_player.has_value(); }
  const std::string& key() const { return m_key; }  // of the recording taken up

  void play();
  void pause();
  void seek(double seconds);
  bool isPlaying() const { return m_player && m_player->isPlaying(); }
  double position() const { return m_player ? m_player->position() : 0.0; }  // s
  double duration() const { return m_player ? m_player->duration() : 0.0; }

  // As it was then. None: nothing is taken up, or the device did not know where it was.
  std::optional<DeviceCursor> cursor() const;

 signals:
  void moved();  // another moment is to be seen, or none any more, or it has begun or ended to play

 private:
  void follow();

  ServoClock& m_clock;
  std::optional<RecordingPlayer> m_player;
  std::string m_key;
  double m_limit = 1.0;  // N
  QTimer m_timer;
};

}  // namespace handwheel
