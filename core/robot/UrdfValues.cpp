// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfValues.h"

#include "xml/XmlNumbers.h"

#include <string>

namespace handwheel {

namespace {

Error inLine(Error error, const XmlElement& element) {
  error.position = InputPosition::line(element.line);
  return error;
}

}  // namespace

Status readNumbers(const XmlElement& element, std::string_view attribute, std::span<double> numbers) {
  const std::string* text = element.attribute(attribute);
  if (!text) return Done{};
  const Status status = parseNumbers(*text, numbers);
  if (!status) return inLine(status.error(), element);
  return Done{};
}

Result<double> readNumber(const XmlElement& element, std::string_view attribute, double fallback) {
  double value = fallback;
  if (const Status status = readNumbers(element, attribute, {&value, 1}); !status) return status.error();
  return value;
}

Result<Vec3> readVector(const XmlElement& element, std::string_view attribute, const Vec3& fallback) {
  Vec3 value = fallback;
  if (const Status status = readNumbers(element, attribute, {value.data(), 3}); !status) return status.error();
  return value;
}

Result<Pose> readOrigin(const XmlElement& element) {
  Pose pose = Pose::Identity();
  const XmlElement* origin = element.child("origin");
  if (!origin) return pose;
  const Result<Vec3> xyz = readVector(*origin, "xyz", Vec3::Zero());
  if (!xyz) return xyz.error();
  if (xyz->cwiseAbs().maxCoeff() > kLargestLength) {
    const std::string limit = std::to_string(static_cast<long>(kLargestLength));
    return inLine({ErrorCode::ValueOutOfRange, {"an origin", *origin->attribute("xyz"), "-" + limit, limit}, {}, {}},
                  *origin);
  }
  const Result<Vec3> rpy = readVector(*origin, "rpy", Vec3::Zero());
  if (!rpy) return rpy.error();
  pose.translation() = *xyz * kMillimetresPerMetre;
  pose.linear() = (Eigen::AngleAxisd(rpy->z(), Vec3::UnitZ()) * Eigen::AngleAxisd(rpy->y(), Vec3::UnitY()) *
                   Eigen::AngleAxisd(rpy->x(), Vec3::UnitX()))
                      .toRotationMatrix();
  return pose;
}

}  // namespace handwheel
