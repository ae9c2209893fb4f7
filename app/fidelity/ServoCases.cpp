// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/Cases.h"
#include "fidelity/PressedWall.h"
#include "fidelity/SeededInput.h"
#include "fidelity/SphereServoLoop.h"
#include "haptics/scene/TouchFidelity.h"
#include "haptics/servo/ServoLoop.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr double kStiffest = 1e3;   // N/mm: more than any loop allows
constexpr double kTouchTime = 0.5;  // s that the cost is taken over

DeviceCapabilities promptDevice() {
  return simulatedDevice().capabilities;
}

DeviceCapabilities lateDevice(double latency) {
  DeviceCapabilities device = promptDevice();
  device.latency = latency;
  return device;
}

DeviceCapabilities stiffDevice() {
  DeviceCapabilities device = promptDevice();
  device.inherentDamping *= 4.0;
  device.maxStiffness = 14.0;
  return device;
}

// The slowest rate at which the loop carries the stiffness that is felt (stiffnessLimit() solved for the period), or
// the fastest that there is.
double rateFor(const DeviceCapabilities& device, double stiffness) {
  const double felt = std::min(stiffness, device.maxStiffness);
  const double period = 2.0 * (device.inherentDamping / felt - device.latency);
  return period * kLargestServoRate > 1.0 ? std::max(1.0 / period, kLeastServoRate) : kLargestServoRate;
}

FidelityCase stiffnessCase(const std::string& name, const DeviceCapabilities& device) {
  return {name, "a surface that does not yield", [device](double stiffness, std::uint64_t, Progress) {
            FidelityValues values;
            [[maybe_unused]] const Status inRange = values.set(contactStiffnessSetting(), stiffness);
            const double asked = touchedSurface(ContactSurface(), values).stiffness;
            const double rate = rateFor(device, asked);
            return FidelitySample{pressedDepth(device, rate, asked), rate};
          }};
}

// us a second: all that the loop does in its ticks, of a device that itself does nothing.
double costOfTouch(const SphereContact& slide, const ServoSettings& servo) {
  VirtualClock clock;
  Service service("servo");
  const auto loop = sphereServoLoop(slide, servo, clock, service);
  const auto ticksIn = [&](double seconds) { return static_cast<std::uint64_t>(std::ceil(seconds * servo.rate)); };
  loop->runTicks(ticksIn(SphereContact::kArrival) + 1);
  return 1e3 * cpuMilliseconds([&] { loop->runTicks(ticksIn(kTouchTime)); }) / kTouchTime;
}

FidelityCase rateCase(const std::string& name, const DeviceCapabilities& device, double packets = 0.0) {
  const SeededInput<SphereContact> input([](std::uint64_t seed) { return ballSlide(seed, kTouchTime); });
  return {name, "a wall that does not yield",
          [input, device, packets](double rate, std::uint64_t seed, Progress progress) {
            FidelityValues values;
            [[maybe_unused]] const Status inRange = values.set(servoRateSetting(), rate);
            const ServoSettings servo = servoSettings(values);
            return FidelitySample{pressedDepth(device, servo.rate, kStiffest, packets, progress),
                                  costOfTouch(input(seed), servo)};
          }};
}

}  // namespace

std::vector<FidelityCase> contactStiffnessCases() {
  return {stiffnessCase("device that carries 1 N/mm at 1 kHz", promptDevice()),
          stiffnessCase("the same, 0.2 ms late", lateDevice(0.0002)),
          stiffnessCase("device of four times the friction", stiffDevice())};
}

std::vector<FidelityCase> servoRateCases() {
  return {rateCase("device that carries 1 N/mm at 1 kHz", promptDevice()),
          rateCase("the same, 1 ms late", lateDevice(0.001)),
          rateCase("the same, on a wire with a packet a ms", promptDevice(), 0.001),
          rateCase("device of four times the friction", stiffDevice())};
}

}  // namespace handwheel
