// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/carving/DrillSettings.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kFinestDrill = 6.0;    // voxels, of a diameter
constexpr double kWidestDrill = 900.0;  // voxels
constexpr double kThinnestSaw = 2.0;    // voxels
constexpr Limits kSpeeds{0.05, 50.0};   // mm/s
constexpr Limits kSpindle{1.0, 1e5};    // r/min
constexpr Limits kPecks{0.0, 1000.0};   // mm
constexpr double kOutlineLength = 4.0;  // radii, of the axis

// In the order of DrillShape.
constexpr const char* kHeads[] = {QT_TRANSLATE_NOOP("Property", "Ball"), QT_TRANSLATE_NOOP("Property", "Burr"),
                                  QT_TRANSLATE_NOOP("Property", "Twist drill"),
                                  QT_TRANSLATE_NOOP("Property", "Circular saw")};

Limits diameterLimits(double voxel) {
  const Limits all{DrillBit::kLeastDiameter, DrillBit::kLargestDiameter};
  if (!(voxel > 0.0)) return all;
  const Limits ofVoxels{kFinestDrill * voxel, kWidestDrill * voxel};
  const Limits both{std::max(ofVoxels.least, all.least), std::min(ofVoxels.largest, all.largest)};
  return both.least < both.largest ? both : ofVoxels;
}

Limits widthLimits(double voxel, const DrillBit& head) {
  const double least = std::max(kThinnestSaw * voxel, DrillBit::kLeastWidth);
  return {least, std::max(least, 0.5 * head.diameter)};
}

// The axis of a head that is fed out of the surface by `out`: that of a saw lies along the surface, so that it cuts
// upright.
Vec3 axisOf(const DrillBit& head, const Vec3& out) {
  if (head.shape != DrillShape::Saw) return out;
  const Vec3 across = out.cross(Vec3::UnitZ());
  return across.norm() > 0.1 ? Vec3(across.normalized()) : Vec3(Vec3::UnitX());
}

std::vector<Vec3> circleAt(const Vec3& centre, const Vec3& axis, double radius) {
  constexpr int kSides = 48;
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Vec3> line;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    line.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return line;
}

}  // namespace

DrillSettings::DrillSettings(const DrillBit& head, std::string_view material, double spindle, double feed)
    : m_head(head), m_rpm(spindle), m_speed(feed) {
  const std::vector<DrillMaterial>& all = drillMaterials();
  while (all[m_material].id != material) ++m_material;
}

void DrillSettings::setHead(std::size_t type, double voxel) {
  m_head = drillBits()[type].tool;
  const double usual = m_head.diameter;
  m_head.diameter = diameterLimits(voxel).bring(usual);
  m_head.length *= m_head.diameter / usual;
  m_head.width = widthLimits(voxel, m_head).bring(m_head.width);
}

DrillSetup DrillSettings::setup() const {
  return {m_head, drillMaterials()[m_material], m_rpm * 2.0 * M_PI / 60.0};
}

DrillFeed DrillSettings::feedOutOf(const Vec3& out) const {
  return {axisOf(m_head, out), m_speed, m_peck, -out};
}

std::vector<Property> DrillSettings::properties(double voxel) const {
  std::vector<std::string> materials, heads;
  int head = 0;
  for (const DrillBitType& type : drillBits()) {
    if (type.tool.shape == m_head.shape) head = static_cast<int>(heads.size());
    heads.push_back(kHeads[static_cast<std::size_t>(type.tool.shape)]);
  }
  for (const DrillMaterial& material : drillMaterials()) materials.push_back(material.name);
  std::vector<Property> all{
      choiceSetting("head", QT_TRANSLATE_NOOP("Property", "Drill"), head, heads),
      numberSetting("diameter", QT_TRANSLATE_NOOP("Property", "Diameter"), m_head.diameter, Quantity::Length,
                    diameterLimits(voxel)),
      choiceSetting("material", QT_TRANSLATE_NOOP("Property", "Material"), static_cast<int>(m_material), materials),
      numberSetting("rpm", QT_TRANSLATE_NOOP("Property", "Spindle (r/min)"), m_rpm, Quantity::Number, kSpindle),
      numberSetting("feed", QT_TRANSLATE_NOOP("Property", "Feed by the mouse (mm/s)"), m_speed, Quantity::Number,
                    kSpeeds),
      numberSetting("peck", QT_TRANSLATE_NOOP("Property", "Peck by the mouse (0: none)"), m_peck, Quantity::Length,
                    kPecks)};
  if (m_head.shape == DrillShape::Saw)
    all.insert(all.begin() + 2, numberSetting("width", QT_TRANSLATE_NOOP("Property", "Width"), m_head.width,
                                              Quantity::Length, widthLimits(voxel, m_head)));
  return all;
}

bool DrillSettings::set(std::string_view id, const PropertyValue& value, double voxel) {
  if (id == "head") {
    int type = 0;
    const bool isSet = assignChoice(type, value, static_cast<int>(drillBits().size()));
    if (isSet) setHead(static_cast<std::size_t>(type), voxel);
    return isSet;
  }
  if (id == "material") return assignChoice(m_material, value, static_cast<int>(drillMaterials().size()));
  if (id == "diameter") {
    const double before = m_head.diameter;
    if (!assignNumber(m_head.diameter, value, diameterLimits(voxel))) return false;
    m_head.length *= m_head.diameter / before;
    m_head.width = widthLimits(voxel, m_head).bring(m_head.width);
    return true;
  }
  if (id == "width") return assignNumber(m_head.width, value, widthLimits(voxel, m_head));
  if (id == "rpm") return assignNumber(m_rpm, value, kSpindle);
  if (id == "feed") return assignNumber(m_speed, value, kSpeeds);
  return id == "peck" && assignNumber(m_peck, value, kPecks);
}

std::vector<std::vector<Vec3>> DrillSettings::outlineAt(const Vec3& position, const Vec3& normal) const {
  const double radius = m_head.radius();
  const Vec3 centre = position + (m_head.shape == DrillShape::Saw ? radius : 0.0) * normal;
  return {circleAt(centre, axisOf(m_head, normal), radius),
          {position, Vec3(position + kOutlineLength * radius * normal)}};
}

}  // namespace handwheel
