// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sound/NoiseBand.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace handwheel {

// The audible state of a machine tool at one moment. Values that are not finite count as zero.
struct MachineSoundState {
  double spindleSpeed = 0.0;        // r/min, in either direction
  double force = 0.0;               // N, force of cutting or drilling
  double cuttingSpeed = 0.0;        // m/min
  double chipThickness = 0.2;       // mm
  double wear = 0.0;                // edge wear; 0: new, 1: worn out
  double chatter = 0.0;             // 0: no chatter, 1: as strong as the cut
  double chatterFrequency = 200.0;  // Hz
  unsigned blows = 0;               // number of crashes so far; each further crash sounds as a blow
  bool operator==(const MachineSoundState&) const = default;
};

// The synthesised sound of a machine tool. It consists of gears, the cut, the squeal of a worn edge, chatter, and the
// blow of a crash. The gears sound at kTeeth times the spindle frequency; the cut is noise around the rate at which
// chips form, which falls with their thickness, and swells once a revolution; it gets louder with the force. Samples
// are within ±1 and phases are continuous; changes take some 20 ms, so there are no clicks. The same states at the same
// samples give the same sound, even if the calls of render() divide the samples differently. An object must be used on
// one thread; it takes no lock and allocates no memory. A sample takes some 100 ns.
class MachineSoundSynthesizer {
 public:
  static constexpr double kTeeth = 24.0;
  static constexpr double kLeastRate = 8000.0, kLargestRate = 192000.0;  // Hz

  explicit MachineSoundSynthesizer(double sampleRate);

  void set(const MachineSoundState& state) noexcept;
  void render(std::span<float> samples) noexcept;

  double sampleRate() const { return m_rate; }

 private:
  // The values that glide: levels and frequencies (Hz).
  enum Part { Gears, Cut, Squeal, Chatter, Turns, Centre, ChatterTone, Quality, kParts };

  void glide() noexcept;
  double next() noexcept;
  double tone(double& phase, double frequency, int partials, double fall) noexcept;

  double m_rate;
  double m_share;  // fraction of the distance to its target that a value glides in a piece of 32 samples
  NoiseBand m_noise;
  std::array<double, kParts> m_target{}, m_value{}, m_step{};
  double m_turn = 0.0, m_gears = 0.0, m_squeal = 0.0, m_chatter = 0.0;  // phases, in turns
  double m_blow = 0.0, m_blowLevel = 0.0;                               // phase, in turns, and level of the last blow
  double m_ringing;                 // factor of the level from one sample to the next
  std::optional<unsigned> m_blows;  // none: before the first state
  std::size_t m_left = 0;           // number of samples to the end of the present piece
};

}  // namespace handwheel
