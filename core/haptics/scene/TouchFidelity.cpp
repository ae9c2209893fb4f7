// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/TouchFidelity.h"

#include "base/Translatable.h"

namespace handwheel {

FidelitySetting proxyToleranceSetting() {
  FidelitySetting s;
  s.id = "proxy.tolerance";
  s.label = translatable("Fidelity", "Tolerance of the contact point");
  s.unit = translatable("Fidelity", "diagonals of the model");
  s.scale = FidelityScale::Logarithmic;
  s.least = 1e-12;   // below the effect of rounding
  s.largest = 1e-4;  // a hundredth of a millimetre of an object that fills a hand; beyond, it feels steps
  s.standard = ContactOptions().tolerance;
  s.presets = {s.standard, s.standard, s.standard};
  s.error = {translatable("Fidelity", "RMS distance from its final position"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of a tick"), "us"};
  s.budget = FidelityBudget::Tick;
  return s;
}

FidelitySetting servoRateSetting() {
  FidelitySetting s;
  s.id = "servo.rate";
  s.label = translatable("Fidelity", "Rate of the servo loop");
  s.unit = "Hz";
  s.scale = FidelityScale::Logarithmic;
  s.least = kLeastServoRate;
  s.largest = kLargestServoRate;
  s.whole = true;
  s.standard = DeviceCapabilities().nominalRate;
  s.presets = {500.0, 1000.0, 1000.0};
  s.error = {translatable("Fidelity", "penetration at 2 N into the stiffest wall that the rate allows"), "mm"};
  s.cost = {translatable("Fidelity", "CPU time of a second of touch"), "us/s"};
  s.budget = FidelityBudget::Core;
  return s;
}

FidelitySetting contactStiffnessSetting() {
  FidelitySetting s;
  s.id = "contact.stiffness";
  s.label = translatable("Fidelity", "Stiffness of surfaces");
  s.unit = "N/mm";
  s.scale = FidelityScale::Logarithmic;
  s.least = 0.1;
  s.largest = 10.0;
  s.standard = TouchedSurface().stiffness;
  s.presets = {0.5, 1.0, 2.2};
  s.error = {translatable("Fidelity", "penetration at 2 N into the surface"), "mm"};
  s.cost = {translatable("Fidelity", "rate of the servo loop that keeps it stable"), "Hz"};
  s.budget = FidelityBudget::Rate;
  return s;
}

FidelitySetting velocityWindowSetting() {
  FidelitySetting s;
  s.id = "servo.velocity_window";
  s.label = translatable("Fidelity", "Velocity window");
  s.unit = "s";
  s.scale = FidelityScale::Logarithmic;
  s.least = 0.0005;
  s.largest = 0.05;
  s.standard = VelocityEstimator::kStandardWindow;
  s.presets = {0.0011, 0.0034, 0.01};
  s.error = {translatable("Fidelity", "RMS error of the velocity"), "mm/s"};
  s.cost = {translatable("Fidelity", "delay of the velocity"), "s"};
  return s;
}

ServoSettings servoSettings(const FidelityValues& values) {
  ServoSettings settings;
  const FidelitySetting rate = servoRateSetting();
  if (values.preset() || values.overrides().contains(rate.id)) settings.rate = values.of(rate);
  settings.velocityWindow = values.of(velocityWindowSetting());
  return settings;
}

ContactOptions contactOptions(const FidelityValues& values) {
  ContactOptions options;
  options.tolerance = values.of(proxyToleranceSetting());
  return options;
}

TouchedSurface touchedSurface(ContactSurface surface, const FidelityValues& values) {
  TouchedSurface feel;
  feel.surface = std::move(surface);
  feel.stiffness = values.of(contactStiffnessSetting());
  feel.contact = contactOptions(values);
  return feel;
}

}  // namespace handwheel
