// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sound/MachineSoundSynthesizer.h"

#include "Spectrum.h"
#include "TestClass.h"

#include <rapidcheck.h>

#include <algorithm>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kRate = 48000.0;
constexpr double kTenDecibels = 10.0;

std::vector<double> rendered(MachineSoundSynthesizer& synthesizer, double seconds) {
  std::vector<float> samples(static_cast<std::size_t>(seconds * synthesizer.sampleRate()));
  synthesizer.render(samples);
  return {samples.begin(), samples.end()};
}

// After it has come to rest at a state.
std::vector<double> steady(const MachineSoundState& state, double seconds) {
  MachineSoundSynthesizer synthesizer(kRate);
  synthesizer.set(state);
  rendered(synthesizer, 0.3);
  return rendered(synthesizer, seconds);
}

MachineSoundState cutting(double force) {
  return {.spindleSpeed = 800.0, .force = force, .cuttingSpeed = 100.0, .chipThickness = 0.2};
}

}  // namespace

class MachineSoundSynthesizerTest : public QObject {
  Q_OBJECT

 private slots:
  void atRestItIsSilent();
  void isBounded();
  void isTheSameInPieces();
  void gearsSoundAtTheirTeeth();
  void reverseSoundsAlike();
  void loudnessFollowsTheForce();
  void nothingCutsWithoutMotion();
  void thickChipsSoundLower();
  void aWornEdgeIsLouderAndSqueals();
  void chatterIsATone();
  void theCutSwellsOnceInATurn();
  void nothingClicks();
  void phasesGoOn();
  void lowSampleRates();
  void aCrashIsABlow();
};

void MachineSoundSynthesizerTest::atRestItIsSilent() {
  MachineSoundSynthesizer synthesizer(kRate);
  for (double s : rendered(synthesizer, 0.1)) QCOMPARE(s, 0.0);
  synthesizer.set(cutting(1000.0));
  QVERIFY(rootMeanSquare(rendered(synthesizer, 0.5)) > 0.05);
  synthesizer.set({});
  rendered(synthesizer, 0.5);  // 33 time constants
  for (double s : rendered(synthesizer, 0.1)) QVERIFY(std::abs(s) < 1e-6);
}

void MachineSoundSynthesizerTest::isBounded() {
  QVERIFY(rc::check("all samples are within one", [] {
    const auto any = [] {
      return *rc::gen::element(0.0, -1.0, 1e-9, 0.5, 1.0, 100.0, 1e4, 1e300, -1e300,
                               std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
    };
    MachineSoundSynthesizer synthesizer(kRate);
    for (int change = 0; change < 6; ++change) {
      synthesizer.set({any(), any(), any(), any(), any(), any(), any()});
      for (double s : rendered(synthesizer, 0.02)) RC_ASSERT(std::isfinite(s) && std::abs(s) <= 1.0);
    }
  }));
}

void MachineSoundSynthesizerTest::isTheSameInPieces() {
  QVERIFY(rc::check("the pieces it is asked for do not matter", [] {
    MachineSoundSynthesizer whole(kRate), pieces(kRate);
    whole.set(cutting(500.0));
    pieces.set(cutting(500.0));
    std::vector<float> one(4000), other(4000);
    whole.render(one);
    for (std::size_t at = 0; at < other.size();) {
      const std::size_t count = std::min<std::size_t>(*rc::gen::inRange<std::size_t>(1, 700), other.size() - at);
      pieces.render({other.data() + at, count});
      at += count;
    }
    RC_ASSERT(one == other);
  }));
}

void MachineSoundSynthesizerTest::gearsSoundAtTheirTeeth() {
  for (double speed : {300.0, 1000.0, 3000.0, 10000.0}) {
    const Spectrum spectrum(steady({.spindleSpeed = speed}, 1.0), kRate);
    const double expected = MachineSoundSynthesizer::kTeeth * speed / 60.0;
    const double peak = spectrum.peak(20.0, 20000.0);
    QVERIFY2(std::abs(peak - expected) <= spectrum.binWidth(), qPrintable(QString::number(peak)));
    // Nothing but the tone and its octave.
    const double tones =
        spectrum.power(0.9 * expected, 1.1 * expected) + spectrum.power(1.9 * expected, 2.1 * expected);
    QVERIFY(tones > 0.999 * spectrum.power(0.0, kRate));
  }
  QVERIFY(rootMeanSquare(steady({.spindleSpeed = 3000.0}, 0.5)) > rootMeanSquare(steady({.spindleSpeed = 300.0}, 0.5)));
}

void MachineSoundSynthesizerTest::reverseSoundsAlike() {
  QCOMPARE(steady({.spindleSpeed = -500.0}, 0.1), steady({.spindleSpeed = 500.0}, 0.1));
}

void MachineSoundSynthesizerTest::loudnessFollowsTheForce() {
  double last = rootMeanSquare(steady(cutting(0.0), 1.0));
  for (double force : {50.0, 100.0, 200.0, 400.0, 1000.0, 4000.0}) {
    const double loudness = rootMeanSquare(steady(cutting(force), 1.0));
    QVERIFY2(loudness > 1.05 * last,
             qPrintable(QStringLiteral("%1 N: %2 after %3").arg(force).arg(loudness).arg(last)));
    last = loudness;
  }
  QVERIFY(last < 0.5);
}

void MachineSoundSynthesizerTest::nothingCutsWithoutMotion() {
  QCOMPARE(rootMeanSquare(steady({.force = 1000.0}, 0.2)), 0.0);
}

// The chip's segments come at a quarter of v/h: at 100 m/min and 0.2 mm, 2083 Hz.
void MachineSoundSynthesizerTest::thickChipsSoundLower() {
  const auto centre = [](double thickness) {
    MachineSoundState state = cutting(1e5);
    state.spindleSpeed = 0.0;
    state.chipThickness = thickness;
    return Spectrum(steady(state, 2.0), kRate).median();
  };
  const double thin = centre(0.15), middle = centre(0.2), thick = centre(0.4);
  QVERIFY2(std::abs(middle - 2083.0) < 250.0, qPrintable(QString::number(middle)));
  QVERIFY(thin > 1.2 * middle && thick < 0.7 * middle);
}

void MachineSoundSynthesizerTest::aWornEdgeIsLouderAndSqueals() {
  MachineSoundState state = cutting(300.0);
  const std::vector<double> sharp = steady(state, 1.0);
  state.wear = 1.0;
  const std::vector<double> worn = steady(state, 1.0);
  QVERIFY(rootMeanSquare(worn) > 1.3 * rootMeanSquare(sharp));
  const auto squeal = [](const std::vector<double>& samples) {
    const Spectrum spectrum(samples, kRate);
    return spectrum.power(2890.0, 2910.0) / (spectrum.power(2800.0, 2850.0) + spectrum.power(2950.0, 3000.0));
  };
  QVERIFY(squeal(sharp) < 1.0 && squeal(worn) > kTenDecibels * squeal(sharp));
}

void MachineSoundSynthesizerTest::chatterIsATone() {
  MachineSoundState state = cutting(2000.0);
  state.chatterFrequency = 180.0;
  const auto tone = [](const std::vector<double>& samples) {
    const Spectrum spectrum(samples, kRate);
    return spectrum.power(176.0, 184.0) / spectrum.power(200.0, 208.0);
  };
  const std::vector<double> calm = steady(state, 1.0);
  state.chatter = 1.0;
  const std::vector<double> loud = steady(state, 1.0);
  QVERIFY(tone(loud) > 100.0 * kTenDecibels * tone(calm));
  QVERIFY(rootMeanSquare(loud) > rootMeanSquare(calm));
}

// At 120 r/min, twice a second: the power of the noise in eighths of a turn rises and falls.
void MachineSoundSynthesizerTest::theCutSwellsOnceInATurn() {
  const std::vector<double> samples =
      steady({.spindleSpeed = 120.0, .force = 1e5, .cuttingSpeed = 100.0, .chipThickness = 0.1}, 8.0);
  std::complex<double> once = 0.0, thrice = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double power = samples[i] * samples[i], turn = 2.0 * static_cast<double>(i) / kRate;
    once += power * std::polar(1.0, -2.0 * std::numbers::pi * turn);
    thrice += power * std::polar(1.0, -6.0 * std::numbers::pi * turn);
    all += power;
  }
  QVERIFY(std::abs(once) > 0.1 * all && std::abs(thrice) < 0.03 * all);
}

// The fourth difference takes away the tone, of which it leaves (2 sin(pi f / rate))^4 < 0.2 %, and makes 6 h of a leap
// by h: no leap is above -80 dB. Without gliding there would be several times as much.
void MachineSoundSynthesizerTest::nothingClicks() {
  MachineSoundSynthesizer synthesizer(kRate);
  std::vector<double> samples = rendered(synthesizer, 0.1);
  for (double speed : {900.0, 0.0, 2000.0, 100.0, 1500.0, 0.0}) {
    synthesizer.set({.spindleSpeed = speed});
    const std::vector<double> more = rendered(synthesizer, 0.2537);
    samples.insert(samples.end(), more.begin(), more.end());
  }
  double largest = 0.0;
  for (std::size_t i = 4; i < samples.size(); ++i) {
    largest = std::max(largest, std::abs(samples[i] - 4.0 * samples[i - 1] + 6.0 * samples[i - 2] -
                                         4.0 * samples[i - 3] + samples[i - 4]));
  }
  QVERIFY2(largest < 6e-4, qPrintable(QString::number(largest)));
}

// Only the tone's frequency changes: its phase has no leap, so neighbours differ by less than the tone allows.
void MachineSoundSynthesizerTest::phasesGoOn() {
  MachineSoundSynthesizer synthesizer(kRate);
  synthesizer.set({.spindleSpeed = 1000.0});
  rendered(synthesizer, 0.5);
  std::vector<double> samples = rendered(synthesizer, 0.01);
  for (int change = 0; change < 200; ++change) {
    synthesizer.set({.spindleSpeed = 1000.0 + 10.0 * (change % 7)});
    for (double s : rendered(synthesizer, 0.003)) samples.push_back(s);
  }
  double loudest = 0.0, steepest = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    loudest = std::max(loudest, std::abs(samples[i]));
    steepest = std::max(steepest, std::abs(samples[i] - samples[i - 1]));
  }
  const double fastest = MachineSoundSynthesizer::kTeeth * 1060.0 / 60.0 * 2.0;
  QVERIFY(steepest <= 1.1 * loudest * 2.0 * std::numbers::pi * fastest / kRate);
}

// Tones beyond half the sample rate do not come back as others.
void MachineSoundSynthesizerTest::lowSampleRates() {
  MachineSoundSynthesizer synthesizer(1.0);
  QCOMPARE(synthesizer.sampleRate(), MachineSoundSynthesizer::kLeastRate);
  synthesizer.set({.spindleSpeed = 30000.0});  // 12 kHz
  rendered(synthesizer, 0.3);
  QVERIFY(rootMeanSquare(rendered(synthesizer, 0.3)) < 1e-3);
  QCOMPARE(MachineSoundSynthesizer(std::numeric_limits<double>::quiet_NaN()).sampleRate(),
           MachineSoundSynthesizer::kLeastRate);
  QCOMPARE(MachineSoundSynthesizer(1e9).sampleRate(), MachineSoundSynthesizer::kLargestRate);
}

// Each crash is heard once, however often it is reported, and rings out; those before the synthesizer began are not.
void MachineSoundSynthesizerTest::aCrashIsABlow() {
  const auto level = [](const std::vector<double>& samples) {
    double sum = 0.0;
    for (const double x : samples) sum += x * x;
    return std::sqrt(sum / static_cast<double>(samples.size()));
  };
  MachineSoundSynthesizer synthesizer(kRate);
  synthesizer.set({.blows = 2});
  QCOMPARE(level(rendered(synthesizer, 0.2)), 0.0);
  synthesizer.set({.blows = 3});
  const double struck = level(rendered(synthesizer, 0.1));
  QVERIFY(struck > 0.1);
  synthesizer.set({.blows = 3});
  const double ringing = level(rendered(synthesizer, 0.1));
  QVERIFY(ringing < struck && ringing > 0.0);
  rendered(synthesizer, 3.0);
  QCOMPARE(level(rendered(synthesizer, 0.1)), 0.0);
}

HANDWHEEL_TEST(MachineSoundSynthesizerTest)
#include "MachineSoundSynthesizerTest.moc"
