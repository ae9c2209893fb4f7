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

// The sound of a machine, played on the default output of the computer. The sound is off until it is switched on. The
// output is opened for the first state and released if no state is set for kHeldMs. Devices are found and opened on a
// separate thread, because this may take long. Without a device the sound is silent, and devices are looked for again
// after a pause of kHeldMs. The state is to be set about ten times a second while the machine runs: the sound ends half
// a second after the last state. All calls must be made on the window thread, and return at once.
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
  // Emitted with the name of the device that plays; empty: the device was released.
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
