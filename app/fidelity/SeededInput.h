// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <functional>
#include <memory>
#include <optional>
#include <random>

namespace handwheel {

// A random number generator with the same sequence on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}

  double between(double a, double b) { return a + (b - a) * static_cast<double>(m_engine() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(m_engine() % n); }
  // Returns a unit vector, uniformly distributed over all directions (Archimedes: height and angle are uniform).
  Vec3 direction() {
    const double z = between(-1.0, 1.0), u = between(0.0, 2.0 * M_PI), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(u), r * std::sin(u), z};
  }

 private:
  std::mt19937_64 m_engine;
};

// The input of a case, created on first use and cached for one seed. Copies of this object share the input. It must not
// be used by two threads at once.
template <class Input>
class SeededInput {
 public:
  explicit SeededInput(std::function<Input(std::uint64_t seed)> make)
      : m_state(std::make_shared<State>(State{std::move(make), 0, nullptr})) {}

  Input& operator()(std::uint64_t seed) const {
    State& s = *m_state;
    if (!s.input || s.seed != seed) s.input = std::make_unique<Input>(s.make(seed));
    s.seed = seed;
    return *s.input;
  }

 private:
  struct State {
    std::function<Input(std::uint64_t)> make;
    std::uint64_t seed;
    std::unique_ptr<Input> input;
  };
  std::shared_ptr<State> m_state;
};

}  // namespace handwheel
