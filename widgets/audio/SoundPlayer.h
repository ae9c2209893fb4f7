// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sound/MachineSoundSynthesizer.h"

#include <QObject>
#include <QString>
#include <memory>

class QAudioSink;

namespace handwheel {

class SoundStream;

// Player of a machine's sound on the default output of the computer. The player lives on a thread that may wait for
// devices, and all calls must be made on that thread. Without a device it does nothing.
class SoundPlayer : public QObject {
  Q_OBJECT

 public:
  SoundPlayer();
  ~SoundPlayer() override;

  void start(double volume);
  void stop();
  void setVolume(double volume);  // 0 to 1, perceived loudness
  void setState(const MachineSoundState& state);

 signals:
  void deviceChanged(const QString& device);  // name: the device that plays; empty: none

 private:
  std::unique_ptr<SoundStream> m_stream;
  std::unique_ptr<QAudioSink> m_sink;  // reads the stream
};

}  // namespace handwheel
