// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sound/MachineSoundSynthesizer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr std::size_t kPiece = 32;      // samples between two changes of direction
constexpr double kGlide = 0.015;        // s, time constant of changes
constexpr double kSilence = 1e-6;       // level, -120 dB: a smaller change is inaudible
constexpr double kHighest = 0.45;       // share of the sample rate: there are no tones above
constexpr double kSquealTone = 2900.0;  // Hz

// Levels at their most. The sum is softly limited.
constexpr double kGearLevel = 0.12, kCutLevel = 0.24, kSquealLevel = 0.12, kChatterLevel = 0.35;
constexpr double kBlowLevel = 0.9, kBlowTone = 140.0, kBlowTime = 0.12;  // Hz; s, to 1/e
constexpr double kHalfSpeed = 600.0;  // r/min at which the gears are half as loud as they become
constexpr double kHalfForce = 400.0;  // N, likewise for the cut
constexpr double kHalfMotion = 0.05;  // m/s: without motion nothing cuts
constexpr double kSwell = 0.3;        // share of the cut, in a turn of the spindle

// Share of v/h, the rate at which a chip moves by its own thickness: its segments. The result is within the range of
// small loudspeakers.
constexpr double kChipShare = 0.25;
constexpr double kLeastCentre = 900.0, kLargestCentre = 5000.0;  // Hz
constexpr double kSharpQuality = 2.5, kWornQuality = 1.0;
constexpr double kLargestSpeed = 30000.0;  // r/min

double within(double value, double least, double largest) {
  return std::isfinite(value) ? std::clamp(value, least, largest) : least;
}

// 0 at 0, half at half, towards 1.
double saturated(double value, double half) {
  return value / (value + half);
}

void wrap(double& phase) {
  phase -= std::floor(phase);
}

}  // namespace

MachineSoundSynthesizer::MachineSoundSynthesizer(double sampleRate)
    : m_rate(within(sampleRate, kLeastRate, kLargestRate)),
      m_share(1.0 - std::exp(-static_cast<double>(kPiece) / (kGlide * m_rate))),
      m_noise(m_rate),
      m_ringing(std::exp(-1.0 / (kBlowTime * m_rate))) {
  set({});
  m_blows.reset();
  m_value = m_target;
}

void MachineSoundSynthesizer::set(const MachineSoundState& state) noexcept {
  const double spindle =
      std::isfinite(state.spindleSpeed) ? std::min(std::abs(state.spindleSpeed), kLargestSpeed) : 0.0;
  const double wear = within(state.wear, 0.0, 1.0), chatter = within(state.chatter, 0.0, 1.0);
  const double speed = within(state.cuttingSpeed, 0.0, 1e5) / 60.0;          // m/s
  const double thickness = 1e-3 * within(state.chipThickness, 1e-3, 100.0);  // m
  const double cut = saturated(within(state.force, 0.0, 1e6), kHalfForce) * saturated(speed, kHalfMotion);
  m_target[Gears] = kGearLevel * saturated(spindle, kHalfSpeed);
  m_target[Cut] = kCutLevel * cut * (1.0 + 0.5 * wear);
  m_target[Squeal] = kSquealLevel * cut * wear * wear;
  m_target[Chatter] = kChatterLevel * cut * chatter;
  m_target[Turns] = spindle / 60.0;
  m_target[Centre] = std::clamp(kChipShare * speed / thickness, kLeastCentre, kLargestCentre);
  m_target[ChatterTone] = within(state.chatterFrequency, 50.0, 1500.0);
  if (m_blows && state.blows > *m_blows) {
    if (!(m_blowLevel > kSilence)) m_blow = 0.0;
    m_blowLevel = kBlowLevel;
  }
  m_blows = state.blows;
  m_target[Quality] = kSharpQuality + (kWornQuality - kSharpQuality) * wear;
}

// Exponentially, in straight pieces.
void MachineSoundSynthesizer::glide() noexcept {
  for (std::size_t part = 0; part < kParts; ++part) {
    const double distance = m_target[part] - m_value[part];
    if (std::abs(distance) <= kSilence) m_value[part] = m_target[part];
    m_step[part] = std::abs(distance) <= kSilence ? 0.0 : m_share * distance / static_cast<double>(kPiece);
  }
  m_noise.setBand(m_value[Centre], m_value[Quality]);
  m_left = kPiece;
}

// Partials 1, 2, … of a tone, each weaker by a factor; at most 1. Those beyond the sample rate are left out gradually.
double MachineSoundSynthesizer::tone(double& phase, double frequency, int partials, double fall) noexcept {
  phase += frequency / m_rate;
  wrap(phase);
  double sum = 0.0, level = 1.0, levels = 0.0;
  for (int partial = 1; partial <= partials; ++partial, level *= fall) {
    const double room = (kHighest * m_rate - partial * frequency) / (0.1 * m_rate);
    sum += level * std::clamp(room, 0.0, 1.0) * std::sin(2.0 * std::numbers::pi * partial * phase);
    levels += level;
  }
  return sum / levels;
}

double MachineSoundSynthesizer::next() noexcept {
  if (m_left == 0) glide();
  --m_left;
  for (std::size_t part = 0; part < kParts; ++part) m_value[part] += m_step[part];
  m_turn += m_value[Turns] / m_rate;
  wrap(m_turn);
  const double swell = 1.0 - kSwell * (0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * m_turn));
  double sum = m_value[Gears] * tone(m_gears, kTeeth * m_value[Turns], 2, 0.4);
  sum += m_value[Cut] * swell * m_noise.next();
  sum += m_value[Squeal] * swell * tone(m_squeal, kSquealTone, 2, 0.3);
  sum += m_value[Chatter] * tone(m_chatter, m_value[ChatterTone], 4, 0.6);
  if (m_blowLevel > kSilence) {
    sum += m_blowLevel * tone(m_blow, kBlowTone, 5, 0.75);
    m_blowLevel *= m_ringing;
  }
  return std::tanh(sum);
}

void MachineSoundSynthesizer::render(std::span<float> samples) noexcept {
  for (float& sample : samples) sample = static_cast<float>(next());
}

}  // namespace handwheel
