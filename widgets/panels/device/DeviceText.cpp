// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/DeviceText.h"

#include <QLocale>

namespace handwheel {

namespace {

QString number(const QLocale& locale, double value) {
  return locale.toString(value, 'g', 4);
}

QString homingAdvice(const std::string& driver) {
  if (driver == "falcon") {
    return DeviceText::tr(
        "Its position is not calibrated yet. Pull the grip slowly all the way out, push it all the way in, and bring "
        "it back to the middle. There is no force until then.");
  }
  if (driver == "openhaptics") {
    return DeviceText::tr(
        "Its position is not calibrated yet. Put the pen into its inkwell and hold it there for a moment; bring a "
        "device without an inkwell to its reset position. There is no force until then.");
  }
  return DeviceText::tr(
      "Its position is not calibrated yet. Calibrate it as described in its manual. There is no force until then.");
}

}  // namespace

QString DeviceText::status(DeviceStatus status) {
  switch (status) {
    case DeviceStatus::Absent:
      return tr("Not plugged in");
    case DeviceStatus::Starting:
      return tr("Starting…");
    case DeviceStatus::NeedsHoming:
      return tr("Needs homing");
    case DeviceStatus::Ready:
      return tr("Ready");
    case DeviceStatus::Failed:
      return tr("Does not respond correctly");
  }
  return {};
}

QString DeviceText::advice(DeviceStatus status, const std::string& driver) {
  switch (status) {
    case DeviceStatus::Absent:
      return tr("Plug it in. If it is not opened automatically then, choose it again.");
    case DeviceStatus::Starting:
      return tr("Connecting; the firmware may be loading. This can take some seconds.");
    case DeviceStatus::NeedsHoming:
      return homingAdvice(driver);
    case DeviceStatus::Failed:
      return tr(
          "Unplug it, wait for some seconds, and plug it in. If it is not opened automatically then, choose it again.");
    case DeviceStatus::Ready:
      break;
  }
  return {};
}

QStringList DeviceText::safety(SafetyActions actions) {
  QStringList sentences;
  const auto add = [&](SafetyAction action, const QString& sentence) {
    if (actions.has(action)) sentences << sentence;
  };
  add(SafetyAction::DeviceFault, tr("No force: the device is not ready."));
  add(SafetyAction::NotFinite, tr("No force: the requested force is not a number."));
  add(SafetyAction::Passivity, tr("Damped: the device returned more energy than was put in."));
  add(SafetyAction::SpeedDamping, tr("Damped: it moves faster than a hand normally does."));
  add(SafetyAction::SpeedCut, tr("No force: it moves as if nobody were holding it."));
  add(SafetyAction::Ramp, tr("The force rises slowly after a change."));
  add(SafetyAction::Watchdog, tr("The force fades: no update arrived in time."));
  add(SafetyAction::Slew, tr("The rate of change of the force is limited."));
  add(SafetyAction::Clamp, tr("The force is at the limit of the device."));
  return sentences;
}

QString DeviceText::softened(double stiffness, double asked, const DeviceInUse& device, double rate,
                             const QLocale& locale) {
  const QString name = device.chosen ? QString::fromStdString(device.chosen->name) : QString();
  const QString felt = locale.toString(stiffness, 'f', 2), set = locale.toString(asked, 'f', 2);
  if (stiffness > 0.99 * device.capabilities.maxStiffness && device.capabilities.maxStiffness > 0.0)
    return tr("Softer than set: %1 of %2 N/mm; limit specified for the %3").arg(felt, set, name);
  const QString kilohertz = locale.toString(rate / 1e3, 'g', 2);
  const QString milliseconds = locale.toString(device.capabilities.latency * 1e3, 'g', 2);
  return tr("Softer than set: %1 of %2 N/mm; limit of the %3 at %4 kHz and %5 ms of delay")
      .arg(felt, set, name, kilohertz, milliseconds);
}

QString DeviceText::realTimeAdvice() {
  return tr(
      "The system does not allow the servo loop to run in real time. Ticks are late when the computer is busy, and the "
      "stiffness is reduced to allow for that. To permit real time, run this line in a terminal, then log out and in "
      "again:");
}

// The limit is the priority of ServoSettings with some room.
QString DeviceText::realTimeCommand() {
  return QStringLiteral("echo \"%1 - rtprio 90\" | sudo tee /etc/security/limits.d/90-handwheel.conf")
      .arg(qEnvironmentVariable("USER", QStringLiteral("$USER")));
}

std::vector<DeviceText::Line> DeviceText::dataSheet(const DeviceCapabilities& device, const QLocale& locale) {
  std::vector<Line> lines;
  const auto add = [&](const QString& name, double value, const QString& unit) {
    if (value > 0.0) lines.push_back({name, QStringLiteral("%1 %2").arg(number(locale, value), unit)});
  };
  lines.push_back({tr("Measured axes"), locale.toString(device.inputs)});
  lines.push_back({tr("Actuated axes"), device.outputs == 0 ? tr("none") : locale.toString(device.outputs)});
  lines.push_back({tr("Buttons"), locale.toString(device.buttons)});
  add(tr("Largest force"), device.maxForce, QStringLiteral("N"));
  add(tr("Largest torque"), device.maxTorque, QStringLiteral("N·mm"));
  add(tr("Largest force of the grip"), device.maxGripperForce, QStringLiteral("N"));
  add(tr("Stiffness"), device.maxStiffness, QStringLiteral("N/mm"));
  add(tr("Stiffness in rotation"), device.maxAngularStiffness, QStringLiteral("N·mm/rad"));
  add(tr("Damping"), device.maxDamping, QStringLiteral("N·s/mm"));
  add(tr("Internal damping"), device.inherentDamping, QStringLiteral("N·s/mm"));
  add(tr("Radius of the workspace"), device.workspaceRadius, QStringLiteral("mm"));
  add(tr("Servo rate"), device.nominalRate, QStringLiteral("Hz"));
  add(tr("Delay"), device.latency * 1e3, QStringLiteral("ms"));
  if (device.isRateControl)
    lines.push_back({tr("Operating mode"), tr("rate control: it springs back, its deflection sets the speed")});
  return lines;
}

}  // namespace handwheel
