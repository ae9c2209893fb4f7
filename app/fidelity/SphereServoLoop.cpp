// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/SphereServoLoop.h"

#include "base/FidelitySweep.h"
#include "haptics/device/SimulatedDevice.h"
#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/scene/TouchFidelity.h"

#include <chrono>

namespace handwheel {
namespace {

constexpr double kSpeed = 100.0;   // mm/s
constexpr double kPoses = 2000.0;  // a second
constexpr double kUseTime = 0.6;   // s
constexpr int kNaps = 30;          // in that time: so often the cancel flag is looked at

}  // namespace

SphereContact ballSlide(std::uint64_t seed, double seconds) {
  BumpySphere ball(seed);
  std::vector<HandPose> poses{{0.0, ball.above()}};
  for (int i = 0; i <= static_cast<int>(seconds * kPoses); ++i) {
    const double time = i / kPoses;
    poses.push_back({SphereContact::kArrival + time, ball.tipAt(kSpeed * time)});
  }
  return {std::move(ball), PoseTrajectory(std::move(poses))};
}

std::unique_ptr<ServoLoop> sphereServoLoop(const SphereContact& slide, const ServoSettings& servo, ServoClock& clock,
                                           Service& service) {
  SimulatedDeviceSettings settings = simulatedDevice();
  settings.isCommanded = true;
  auto device = std::make_unique<SimulatedDevice>(settings, slide.path, clock);
  [[maybe_unused]] const Status opened = device->open({});  // needs no hardware
  auto loop = std::make_unique<ServoLoop>(std::move(device), servo, clock, service);
  auto scene = std::make_unique<HapticScene>();
  MeshHaptics feel;
  feel.surface = touchedSurface(slide.ball.surface(), {});
  scene->renderer = std::make_unique<SceneForces>(forceSources(std::move(feel)));
  loop->setScene(std::move(scene));
  return loop;
}

double tickInUse(double rate, Progress progress) {
  MonotonicClock clock;
  Service service("servo");
  ServoSettings servo;
  servo.rate = rate;
  const auto loop = sphereServoLoop(ballSlide(1, kUseTime), servo, clock, service);
  loop->start();
  for (int i = 0; i < kNaps && !progress.cancelled(); ++i) {
    std::this_thread::sleep_for(std::chrono::duration<double>(kUseTime / kNaps));
    progress.set(static_cast<double>(i + 1) / kNaps);
  }
  loop->stop();
  std::vector<double> times;
  for (ServoSample sample; loop->nextSample(sample);) {
    if (sample.felt.isContact) times.push_back(static_cast<double>(sample.microseconds));
  }
  return times.empty() || progress.cancelled() ? 0.0 : median(times);
}

}  // namespace handwheel
