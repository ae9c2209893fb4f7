// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sound/MachineSoundSynthesizer.h"

#include <QObject>
#include <QString>
#include <QTimer>

class QThread;

namespace handwheel {

class SoundPlayer;

// Plays the sound of a machine on the default output of the computer. Off until it is switched on. The output is opened
// with the first state and given back when no state came for kHeldMs. Everything that may wait, looking for devices and
// opening one, is done on a thread of its own; without a device it stays silent and tries again after such a pause. The
// state is to be set some ten times a second while the machine runs: the sound ends half a second after the last one.
// Window thread; calls return at once.
class MachineSound : public QObject {
  Q_OBJECT

 public:
  static constexpr int kHeldMs = 10'000;

  explicit MachineSound(QObject* parent = nullptr);
  ~MachineSound() override;

  void setOn(bool isOn);
  bool isOn() const { return m_isOn; }
  void setVolume(double volume);  // 0 to 1, perceived loudness
  void setState(const MachineSoundState& state);

 signals:
  // Emitted with the name of the device that plays; empty: it was given back.
  void deviceChanged(const QString& device);

 private:
  void start();
  void stop();

  QTimer m_rest;                // active while the output is wanted
  QThread* m_thread = nullptr;  // null before the first state
  SoundPlayer* m_player = nullptr;
  double m_volume = 1.0;
  bool m_isOn = false;
};

}  // namespace handwheel
