// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/DeviceMapping.h"

#include <QSettings>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kRestShare = 0.05;         // fraction of the workspace: smaller displacements from rest are ignored
constexpr double kRestAngle = 0.02;         // radian
constexpr std::uint32_t kClutch = 1u << 2;  // the first two are those of the tools
constexpr double kBefore = 0.1;  // fraction of the height of the view: distance in front of a visible surface
constexpr double kLeastFactor = 1e-3, kLargestFactor = 1e3;

QString keyOf(const std::string& driver, const char* name) {
  return QStringLiteral("haptics/%1/%2").arg(QString::fromStdString(driver), QString::fromLatin1(name));
}

double number(const std::string& driver, const char* name, double standard, double least, double largest) {
  bool isNumber = false;
  const double kept = QSettings().value(keyOf(driver, name)).toDouble(&isNumber);
  return isNumber && kept >= least && kept <= largest ? kept : standard;
}

// "+0-1+2": for each axis of the view, the sign and the axis of the device.
QString textOf(const std::array<DeviceAxis, 3>& axes) {
  QString text;
  for (const DeviceAxis& axis : axes) text += (axis.isInverted ? u'-' : u'+') + QString::number(axis.axis);
  return text;
}

std::array<DeviceAxis, 3> axesOf(const QString& text, const std::array<DeviceAxis, 3>& standard) {
  std::array<DeviceAxis, 3> axes;
  std::array<bool, 3> isTaken{};
  if (text.size() != 6) return standard;
  for (int i = 0; i < 3; ++i) {
    const QChar sign = text[2 * i];
    const int axis = text[2 * i + 1].digitValue();
    if ((sign != u'+' && sign != u'-') || axis < 0 || axis > 2 || isTaken[static_cast<std::size_t>(axis)])
      return standard;
    isTaken[static_cast<std::size_t>(axis)] = true;
    axes[static_cast<std::size_t>(i)] = {axis, sign == u'-'};
  }
  return axes;
}

// mm from the focus of the view to the front of the model, but no more than what the device can reach back over.
double depthOfFront(const CameraState& camera, const Box& model, const std::optional<Vec3>& seen) {
  if (seen) return (*seen - camera.centre).dot(camera.towardsViewer()) + kBefore * camera.height;
  if (model.isEmpty()) return 0.0;
  double front = 0.0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = model.corner(static_cast<Box::CornerType>(i));
    front = std::max(front, (corner - camera.centre).dot(camera.towardsViewer()));
  }
  return std::min(front, 0.5 * camera.height);
}

}  // namespace

WorkspaceMapping standardMapping(const DeviceCapabilities& device) {
  WorkspaceMapping mapping;
  mapping.isRateControl = device.isRateControl;
  if (device.isRateControl) {
    mapping.deadZone = kRestShare * device.workspaceRadius;
    mapping.angularDeadZone = kRestAngle;
  }
  if (device.buttons > 2) mapping.clutchButtons = kClutch;
  return mapping;
}

WorkspaceMapping loadMapping(const std::string& driver, const WorkspaceMapping& standard) {
  WorkspaceMapping kept = standard;
  kept.axes = axesOf(QSettings().value(keyOf(driver, "axes")).toString(), standard.axes);
  kept.scale = number(driver, "scale", standard.scale, kLeastFactor, kLargestFactor);
  kept.forceGain = number(driver, "force_gain", standard.forceGain, kLeastFactor, kLargestFactor);
  kept.deadZone = number(driver, "dead_zone", standard.deadZone, 0.0, kLargestFactor);
  kept.angularDeadZone = number(driver, "angular_dead_zone", standard.angularDeadZone, 0.0, M_PI);
  kept.rateGain = number(driver, "rate_gain", standard.rateGain, kLeastFactor, kLargestFactor);
  kept.angularRateGain = number(driver, "angular_rate_gain", standard.angularRateGain, kLeastFactor, kLargestFactor);
  kept.clutchButtons = QSettings().value(keyOf(driver, "clutch"), standard.clutchButtons).toUInt();
  return kept;
}

void storeMapping(const std::string& driver, const WorkspaceMapping& mapping) {
  QSettings settings;
  settings.setValue(keyOf(driver, "axes"), textOf(mapping.axes));
  settings.setValue(keyOf(driver, "scale"), mapping.scale);
  settings.setValue(keyOf(driver, "force_gain"), mapping.forceGain);
  settings.setValue(keyOf(driver, "dead_zone"), mapping.deadZone);
  settings.setValue(keyOf(driver, "angular_dead_zone"), mapping.angularDeadZone);
  settings.setValue(keyOf(driver, "rate_gain"), mapping.rateGain);
  settings.setValue(keyOf(driver, "angular_rate_gain"), mapping.angularRateGain);
  settings.setValue(keyOf(driver, "clutch"), mapping.clutchButtons);
}

WorkspaceMapping mappingInView(const WorkspaceMapping& user, const DeviceCapabilities& device,
                               const CameraState& camera, const Box& model, const std::optional<Vec3>& seen) {
  WorkspaceMapping mapping = user;
  const Vec3 origin = camera.centre + depthOfFront(camera, model, seen) * camera.towardsViewer();
  mapping.sceneFromView = Eigen::Translation3d(origin) * camera.orientation;
  if (device.workspaceRadius > 0.0) mapping.scale *= 0.5 * camera.height / device.workspaceRadius;
  return mapping;
}

std::array<AboutAxis, 3> axesAbout(const Ray& axis, const WorkspaceMapping& inScene, const Vec3& tip) {
  // The cosine of what is taken for a direction: some 25°. Far from it a name would be as wrong as that of the other.
  constexpr double kMostly = 0.9;
  const Vec3 along = axis.direction.normalized(), from = tip - axis.origin;
  const Vec3 away = from - along * along.dot(from);
  const Vec3 radius = away.norm() > 0.0 ? Vec3(away.normalized()) : Vec3::Zero();
  const Eigen::Matrix3d directions = inScene.sceneFromView.linear() * inScene.viewFromDevice();
  std::array<AboutAxis, 3> all{};
  for (int i = 0; i < 3; ++i) {
    const Vec3 direction = directions.col(i).normalized();
    if (std::abs(direction.dot(along)) > kMostly)
      all[static_cast<std::size_t>(i)] = AboutAxis::Along;
    else if (std::abs(direction.dot(radius)) > kMostly)
      all[static_cast<std::size_t>(i)] = AboutAxis::Radius;
    else if (std::abs(direction.dot(along.cross(radius))) > kMostly)
      all[static_cast<std::size_t>(i)] = AboutAxis::Across;
  }
  return all;
}

bool isInView(const CameraState& camera, const Vec3& point) {
  const Vec3 seen = camera.orientation.conjugate() * (point - camera.centre);
  return seen.cwiseAbs().maxCoeff() <= 0.5 * camera.height;
}

}  // namespace handwheel
