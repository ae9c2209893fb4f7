// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "audio/SoundStream.h"

#include "TestClass.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace handwheel;

class SoundStreamTest : public QObject {
  Q_OBJECT

 private slots:
  void givesTheSynthesizersSound();
  void wholeFramesOnly();
  void fallsSilentWhenNobodyTells();
};

namespace {

const MachineSoundState kCut{.spindleSpeed = 800.0, .force = 500.0, .cuttingSpeed = 120.0};

template <class Sample>
std::vector<Sample> samplesIn(const QByteArray& bytes) {
  std::vector<Sample> samples(static_cast<std::size_t>(bytes.size()) / sizeof(Sample));
  std::memcpy(samples.data(), bytes.constData(), samples.size() * sizeof(Sample));
  return samples;
}

double loudest(const std::vector<float>& samples) {
  double most = 0.0;
  for (float s : samples) most = std::max(most, std::abs(static_cast<double>(s)));
  return most;
}

}  // namespace

void SoundStreamTest::givesTheSynthesizersSound() {
  MachineSoundSynthesizer synthesizer(44100.0);
  synthesizer.set(kCut);
  std::vector<float> wanted(1000);
  synthesizer.render(wanted);
  SoundStream floats(44100.0, 1, SoundStream::Format::Float), stereo(44100.0, 2, SoundStream::Format::Int16);
  floats.setState(kCut);
  stereo.setState(kCut);
  QCOMPARE(samplesIn<float>(floats.read(4000)), wanted);
  const std::vector<qint16> both = samplesIn<qint16>(stereo.read(4000));
  QCOMPARE(both.size(), std::size_t(2000));
  for (std::size_t i = 0; i < 1000; ++i) {
    QVERIFY(both[2 * i] == both[2 * i + 1]);
    QVERIFY(std::abs(both[2 * i] / 32767.0 - wanted[i]) <= 0.5001 / 32767.0);
  }
}

void SoundStreamTest::wholeFramesOnly() {
  SoundStream stream(48000.0, 99, SoundStream::Format::Int16);  // 8 channels are the most: 16 bytes
  QCOMPARE(stream.read(47).size(), 32);
  QCOMPARE(stream.read(15).size(), 0);
  QVERIFY(stream.isSequential() && stream.bytesAvailable() > 0);
}

void SoundStreamTest::fallsSilentWhenNobodyTells() {
  SoundStream stream(48000.0, 1, SoundStream::Format::Float);
  const auto tenthOfASecond = [&stream] {
    std::vector<float> samples;
    while (samples.size() < 4800) {
      const std::vector<float> more = samplesIn<float>(stream.read(4 * std::min<qint64>(4800, 4096)));
      samples.insert(samples.end(), more.begin(), more.end());
    }
    return samples;
  };
  for (int i = 0; i < 20; ++i) {
    stream.setState(kCut);
    tenthOfASecond();
  }
  QVERIFY(loudest(tenthOfASecond()) > 0.05);
  for (int i = 0; i < 8; ++i) tenthOfASecond();
  QVERIFY(loudest(tenthOfASecond()) < 1e-4);
  stream.setState(kCut);
  tenthOfASecond();
  QVERIFY(loudest(tenthOfASecond()) > 0.05);
}

HANDWHEEL_TEST(SoundStreamTest)
#include "SoundStreamTest.moc"
