// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/BumpySphere.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "haptics/scene/TouchFidelity.h"

namespace handwheel {
namespace {

constexpr std::size_t kTicks = 2000;
constexpr std::size_t kLook = 64;  // so many ticks pass between two looks at the cancel flag
// A millionth of the smallest that is measured: the proxy goes on until its next move cannot be resolved.
constexpr double kFinest = 1e-18;
constexpr int kManySteps = 4096;

// mm, a hundredth of the finest step that a device can tell: not felt. A fast tip may be off by as much for a tick when
// all steps of the proxy are used up.
constexpr double kNothing = 1e-4;

// The path of a tip, tick by tick, and the final position of the proxy for each tick: empty until it was first
// computed.
struct Slide {
  BumpySphere ball;
  std::vector<Vec3> tips;
  std::vector<Vec3> rests;
};

// Not to the end once cancelled.
std::vector<Vec3> followed(const Slide& slide, const ContactOptions& options, Progress progress) {
  std::vector<Vec3> proxies(slide.tips.size());
  GodObject god;
  god.place(slide.ball.above());
  for (std::size_t i = 0; i < proxies.size() && (i % kLook != 0 || !progress.cancelled()); ++i)
    proxies[i] = god.follow(slide.ball.surface(), slide.tips[i], options).proxy;
  return proxies;
}

// So many mm a tick.
Slide slideAt(double step, std::uint64_t seed) {
  Slide slide{BumpySphere(seed), {}, {}};
  for (std::size_t i = 0; i < kTicks; ++i) slide.tips.push_back(slide.ball.tipAt(step * static_cast<double>(i)));
  return slide;
}

void findRests(Slide& slide, Progress progress) {
  if (!slide.rests.empty()) return;
  ContactOptions finest;
  finest.tolerance = kFinest;
  finest.maxSteps = kManySteps;
  std::vector<Vec3> rests = followed(slide, finest, progress);
  if (!progress.cancelled()) slide.rests = std::move(rests);
}

FidelitySample off(const Slide& slide, double tolerance, Progress progress) {
  FidelityValues values;
  [[maybe_unused]] const Status inRange = values.set(proxyToleranceSetting(), tolerance);
  const ContactOptions options = contactOptions(values);
  FidelitySample sample;
  std::vector<Vec3> proxies;
  sample.cost =
      1e3 * cpuMilliseconds([&] { proxies = followed(slide, options, progress); }) / static_cast<double>(kTicks);
  double sum = 0.0;
  for (std::size_t i = 0; i < kTicks; ++i) {
    const double distance = (proxies[i] - slide.rests[i]).norm();
    if (distance > kNothing) sum += distance * distance;
  }
  sample.error = std::sqrt(sum / static_cast<double>(kTicks));
  return sample;
}

FidelityCase slideCase(const std::string& name, double step) {
  const SeededInput<Slide> input([step](std::uint64_t seed) { return slideAt(step, seed); });
  return {name, "a tolerance of 1e-18", [input](double value, std::uint64_t seed, Progress progress) {
            Slide& slide = input(seed);
            findRests(slide, progress);
            return progress.cancelled() ? FidelitySample{} : off(slide, value, progress);
          }};
}

}  // namespace

std::vector<FidelityCase> proxyToleranceCases() {
  return {slideCase("bumpy ball, 100 mm/s", 0.1), slideCase("bumpy ball, 1 m/s", 1.0)};
}

}  // namespace handwheel
