// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sound/MachineSoundSynthesizer.h"

#include <QIODevice>
#include <vector>

namespace handwheel {

// The samples of a machine's sound as a device that audio outputs read from. If it receives no state for kPatience of
// played sound, it fades to silence, so that the sound ends when the machine stops. Its functions must be called by one
// thread.
class SoundStream : public QIODevice {
  Q_OBJECT

 public:
  enum class Format { Float, Int16 };       // samples in native byte order
  static constexpr double kPatience = 0.5;  // s

  // channels: the number of channels, 1 to 8. All have the same sound.
  SoundStream(double sampleRate, int channels, Format format, QObject* parent = nullptr);

  void setState(const MachineSoundState& state);

  bool isSequential() const override { return true; }
  qint64 bytesAvailable() const override;

 protected:
  qint64 readData(char* data, qint64 most) override;
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  qint64 bytesPerFrame() const;

  MachineSoundSynthesizer m_synthesizer;
  int m_channels;
  Format m_format;
  std::vector<float> m_samples;
  double m_sinceUpdate = 0.0;  // s of sound since the last state
};

}  // namespace handwheel
