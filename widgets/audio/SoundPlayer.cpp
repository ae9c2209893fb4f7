// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "audio/SoundPlayer.h"

#include "audio/SoundStream.h"

#include <QAudio>
#include <QAudioDevice>
#include <QAudioFormat>
#include <QAudioSink>
#include <QMediaDevices>

namespace handwheel {

namespace {

constexpr int kRate = 48000;   // Hz
constexpr int kBufferMs = 60;  // latency of the sound

QAudioFormat formatFor(const QAudioDevice& device) {
  QAudioFormat format;
  format.setSampleRate(kRate);
  format.setChannelCount(1);
  format.setSampleFormat(QAudioFormat::Float);
  if (device.isFormatSupported(format)) return format;
  format = device.preferredFormat();
  if (format.sampleFormat() != QAudioFormat::Float) format.setSampleFormat(QAudioFormat::Int16);
  return format;
}

}  // namespace

SoundPlayer::SoundPlayer() = default;
SoundPlayer::~SoundPlayer() = default;

void SoundPlayer::start(double volume) {
  stop();
  const QAudioDevice device = QMediaDevices::defaultAudioOutput();
  if (device.isNull()) return;
  const QAudioFormat format = formatFor(device);
  if (!device.isFormatSupported(format)) return;
  const bool isFloat = format.sampleFormat() == QAudioFormat::Float;
  m_stream = std::make_unique<SoundStream>(format.sampleRate(), format.channelCount(),
                                           isFloat ? SoundStream::Format::Float : SoundStream::Format::Int16);
  m_sink = std::make_unique<QAudioSink>(device, format);
  m_sink->setBufferSize(format.bytesForDuration(1000 * kBufferMs));
  setVolume(volume);
  m_sink->start(m_stream.get());
  if (m_sink->error() != QAudio::NoError) return stop();
  emit deviceChanged(device.description());
}

void SoundPlayer::stop() {
  if (!m_sink) return;
  m_sink.reset();
  m_stream.reset();
  emit deviceChanged({});
}

void SoundPlayer::setVolume(double volume) {
  if (!m_sink) return;
  m_sink->setVolume(
      QAudio::convertVolume(static_cast<float>(volume), QAudio::LogarithmicVolumeScale, QAudio::LinearVolumeScale));
}

void SoundPlayer::setState(const MachineSoundState& state) {
  if (m_stream) m_stream->setState(state);
}

}  // namespace handwheel
