// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "haptics/scene/TouchFidelity.h"

namespace handwheel {
namespace {

// A hand that swings to and fro, and the device that reads it.
struct Swing {
  double amplitude = 0.0;   // mm
  double frequency = 0.0;   // Hz
  double rate = 1000.0;     // readings a second
  double resolution = 0.0;  // mm, of a reading
};

constexpr double kTime = 4.0, kStart = 0.5;  // s; until the start the window fills

Vec3 inSteps(const Vec3& position, double resolution) {
  return (position / resolution).array().round() * resolution;
}

double rmsError(const Swing& swing, double window, std::uint64_t seed) {
  Random random(seed);
  const Vec3 swingVector = swing.amplitude * random.direction();
  const double phase = random.between(0.0, 2.0 * M_PI), circular = 2.0 * M_PI * swing.frequency;
  VelocityEstimator estimator(window);
  double sum = 0.0, count = 0.0;
  for (int i = 0; i < static_cast<int>(kTime * swing.rate); ++i) {
    const double time = i / swing.rate, angle = circular * time + phase;
    const Vec3 velocity = circular * std::cos(angle) * swingVector;
    const Vec3 estimate = estimator.add(inSteps(std::sin(angle) * swingVector, swing.resolution), 1.0 / swing.rate);
    if (time < kStart) continue;
    sum += (estimate - velocity).squaredNorm();
    ++count;
  }
  return std::sqrt(sum / count);
}

// s: under an acceleration of 1 mm/s², the velocity is behind by so many mm/s.
double delayOf(double rate, double window) {
  VelocityEstimator estimator(window);
  double time = 0.0, estimate = 0.0;
  for (int i = 0; i < static_cast<int>(kStart * rate); ++i) {
    time = i / rate;
    estimate = estimator.add({0.5 * time * time, 0, 0}, 1.0 / rate).x();
  }
  return time - estimate;
}

FidelityCase swingCase(const std::string& name, const Swing& swing) {
  return {name, "derivative of the motion", [swing](double value, std::uint64_t seed, Progress) {
            FidelityValues values;
            [[maybe_unused]] const Status inRange = values.set(velocityWindowSetting(), value);
            const double window = servoSettings(values).velocityWindow;
            return FidelitySample{rmsError(swing, window, seed), delayOf(swing.rate, window)};
          }};
}

}  // namespace

std::vector<FidelityCase> velocityWindowCases() {
  return {swingCase("slow hand, 1 kHz, steps of 0.05 mm", {20.0, 0.5, 1000.0, 0.05}),
          swingCase("fast hand, 1 kHz, steps of 0.05 mm", {20.0, 3.0, 1000.0, 0.05}),
          swingCase("fast hand, 4 kHz, steps of 0.01 mm", {20.0, 3.0, 4000.0, 0.01})};
}

}  // namespace handwheel
