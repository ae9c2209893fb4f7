// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/PressedWall.h"

#include "haptics/scene/MeshHaptics.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/servo/ServoLoop.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kFreeTime = 5.0, kPressTime = 3.0, kMeanTime = 1.0;  // s
constexpr double kSettled = 1e-3;          // mm: what is left of the settling by then is less, and tells nothing
constexpr double kWallSize = 1000.0;       // mm
constexpr std::uint64_t kWallLook = 1000;  // ticks between two looks at the cancel flag

// The plane x = 0, to be touched from below.
std::unique_ptr<HapticScene> wallOf(double stiffness) {
  const double s = kWallSize;
  const std::vector<Vec3> points{{0, -s, -s}, {0, s, -s}, {0, s, s}, {0, -s, s}};
  const std::vector<Triangle> triangles{{0, 2, 1}, {0, 3, 2}};
  MeshHaptics feel;
  feel.surface.emplace();
  feel.surface->surface = ContactSurface(points, triangles);
  feel.surface->stiffness = stiffness;
  auto scene = std::make_unique<HapticScene>();
  scene->renderer = std::make_unique<SceneForces>(forceSources(std::move(feel)));
  return scene;
}

// A simulated device behind a wire.
class WiredDevice : public Device {
 public:
  WiredDevice(const SimulatedDeviceSettings& settings, double packets, ServoClock& clock)
      : m_device(settings, PoseTrajectory(), clock), m_period(std::llround(packets * kNanoseconds)), m_clock(clock) {}

  DeviceCapabilities capabilities() const override { return m_device.capabilities(); }
  Status open(Progress progress) override { return m_device.open(progress); }
  void close() noexcept override { m_device.close(); }
  DeviceState read() noexcept override {
    if (m_period > 0) m_clock.waitUntil(nextPacket(m_clock.now()));
    return m_device.read();
  }
  void write(const DeviceForce& force) noexcept override { m_device.write(force); }

  void setTarget(const Vec3& position) noexcept { m_device.setTarget({0.0, position}); }

 private:
  // At half a period, and each whole one after that.
  std::int64_t nextPacket(std::int64_t now) const {
    return (now + m_period - 1 - m_period / 2) / m_period * m_period + m_period / 2;
  }

  SimulatedDevice m_device;
  std::int64_t m_period;  // ns
  ServoClock& m_clock;
};

}  // namespace

double pressedDepth(const DeviceCapabilities& device, double rate, double stiffness, double packets,
                    Progress progress) {
  SimulatedDeviceSettings settings = simulatedDevice();
  settings.capabilities = device;
  settings.grip.maxForce = kPressingForce;
  VirtualClock clock;
  auto made = std::make_unique<WiredDevice>(settings, packets, clock);
  WiredDevice& hand = *made;
  if (!hand.open({})) return 0.0;  // needs no hardware
  Service service("servo");
  ServoSettings servo;
  servo.rate = rate;
  ServoLoop loop(std::move(made), servo, clock, service);
  loop.setScene(wallOf(stiffness));
  const auto ticksIn = [rate](double seconds) { return static_cast<std::uint64_t>(std::ceil(seconds * rate)); };
  const auto runFor = [&](double seconds) {
    for (std::uint64_t left = ticksIn(seconds); left > 0 && !progress.cancelled();) {
      const std::uint64_t part = std::min<std::uint64_t>(left, kWallLook);
      loop.runTicks(part);
      left -= part;
    }
  };
  hand.setTarget({-0.5, 0, 0});
  runFor(kFreeTime);
  // So far away that the hand gives all of its force wherever the wall lets it be.
  hand.setTarget({kWallSize, 0, 0});
  runFor(kPressTime - kMeanTime);
  double sum = 0.0;
  const std::uint64_t ticks = ticksIn(kMeanTime);
  for (std::uint64_t i = 0; i < ticks && !progress.cancelled(); ++i) {
    loop.runTicks(1);
    sum += loop.latest().device.position.x();
  }
  const double depth = sum / static_cast<double>(ticks);
  return std::round(depth / kSettled) * kSettled;
}

}  // namespace handwheel
