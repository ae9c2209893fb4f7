// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "audio/SoundStream.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

namespace handwheel {

namespace {

constexpr qint64 kMostFrames = 4096;  // at once; outputs ask again
constexpr int kMostChannels = 8;

template <class Convert>
void writeSamples(char* data, std::span<const float> samples, int channels, Convert convert) {
  using Sample = decltype(convert(0.0f));
  for (float s : samples) {
    const Sample sample = convert(s);
    for (int channel = 0; channel < channels; ++channel, data += sizeof(Sample)) {
      std::memcpy(data, &sample, sizeof(Sample));
    }
  }
}

}  // namespace

SoundStream::SoundStream(double sampleRate, int channels, Format format, QObject* parent)
    : QIODevice(parent),
      m_synthesizer(sampleRate),
      m_channels(std::clamp(channels, 1, kMostChannels)),
      m_format(format),
      m_samples(kMostFrames) {
  open(ReadOnly | Unbuffered);
}

void SoundStream::setState(const MachineSoundState& state) {
  m_sinceUpdate = 0.0;
  m_synthesizer.set(state);
}

qint64 SoundStream::bytesPerFrame() const {
  return m_channels * static_cast<qint64>(m_format == Format::Float ? sizeof(float) : sizeof(qint16));
}

qint64 SoundStream::bytesAvailable() const {
  return kMostFrames * bytesPerFrame();  // there is always more
}

qint64 SoundStream::readData(char* data, qint64 most) {
  const qint64 frames = std::clamp<qint64>(most / bytesPerFrame(), 0, kMostFrames);
  const std::span<float> samples(m_samples.data(), static_cast<std::size_t>(frames));
  m_sinceUpdate += static_cast<double>(frames) / m_synthesizer.sampleRate();
  if (m_sinceUpdate > kPatience) m_synthesizer.set({});
  m_synthesizer.render(samples);
  if (m_format == Format::Float)
    writeSamples(data, samples, m_channels, [](float s) { return s; });
  else
    writeSamples(data, samples, m_channels, [](float s) { return static_cast<qint16>(std::lround(32767.0f * s)); });
  return frames * bytesPerFrame();
}

}  // namespace handwheel
