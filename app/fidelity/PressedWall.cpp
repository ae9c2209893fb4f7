// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/PressedWall.h"

#include "haptics/SceneForces.h"
#include "haptics/ServoLoop.h"

#include <cmath>

namespace handwheel {
namespace {

constexpr double kFreeTime = 5.0, kPressTime = 3.0, kMeanTime = 1.0;  // s
constexpr double kWallSize = 1000.0;                                  // mm

// The plane x = 0, to be touched from below.
std::unique_ptr<HapticScene> wallOf(double stiffness) {
  const double s = kWallSize;
  const std::vector<Vec3> points{{0, -s, -s}, {0, s, -s}, {0, s, s}, {0, -s, s}};
  const std::vector<Triangle> triangles{{0, 2, 1}, {0, 3, 2}};
  SceneFeel feel;
  feel.surface.emplace();
  feel.surface->surface = ContactSurface(points, triangles);
  feel.surface->stiffness = stiffness;
  auto scene = std::make_unique<HapticScene>();
  scene->source = std::make_unique<SceneForces>(std::move(feel));
  return scene;
}

}  // namespace

double pressedDepth(const DeviceCapabilities& device, double rate, double stiffness) {
  SimulatedDeviceSettings settings = simulatedDevice();
  settings.capabilities = device;
  settings.grip.maxForce = kPressingForce;
  VirtualClock clock;
  auto made = std::make_unique<SimulatedDevice>(settings, HandPath(), clock);
  SimulatedDevice& hand = *made;
  if (!hand.open({})) return 0.0;  // which needs no hardware
  Service service("servo");
  ServoSettings servo;
  servo.rate = rate;
  ServoLoop loop(std::move(made), servo, clock, service);
  loop.setScene(wallOf(stiffness));
  const auto ticksIn = [rate](double seconds) { return static_cast<std::uint64_t>(std::ceil(seconds * rate)); };
  hand.setTarget({0.0, {-0.5, 0, 0}});
  loop.runTicks(ticksIn(kFreeTime));
  // So far away that the hand gives all of its force wherever the wall lets it be.
  hand.setTarget({0.0, {kWallSize, 0, 0}});
  loop.runTicks(ticksIn(kPressTime - kMeanTime));
  double sum = 0.0;
  const std::uint64_t ticks = ticksIn(kMeanTime);
  for (std::uint64_t i = 0; i < ticks; ++i) {
    loop.runTicks(1);
    sum += loop.latest().device.position.x();
  }
  return sum / static_cast<double>(ticks);
}

}  // namespace handwheel
