// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/VoxelizeSettings.h"

#include "tools/OperationSettings.h"
#include "tools/volume/VoxelizeOperations.h"
#include "volume/drilling/DrillForce.h"

#include <cmath>

namespace handwheel {
namespace {

constexpr double kFeed = 1.0, kRate = 1000.0;               // mm/s and Hz, as He 2008 has them: 0.255 mm
constexpr double kLeastAcross = 64.0, kMostAcross = 512.0;  // voxels, of a part that they suit
constexpr double kAcrossWalls = 4.0;                        // voxels; less than two lose a wall

Vec3 extentOf(const TriangleSoup& surface) {
  Box box;
  for (const Vec3& p : surface.points) box.extend(p);
  return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
}

}  // namespace

VoxelizeSettings::VoxelizeSettings(const TriangleSoup& surface, Purpose purpose)
    : m_purpose(purpose),
      m_measure(measureForWalls(surface)),
      m_extent(extentOf(surface)),
      m_usual(usualVoxel(surface)),
      m_values(voxelizeOperation()) {}

std::vector<Property> VoxelizeSettings::properties() const {
  Property voxel = settingOf(m_values, "voxel"), wall = settingOf(m_values, "wall");
  voxel.value = this->voxel();
  wall.least = 0.0;
  wall.value = this->wall().value_or(0.0);
  return {std::move(voxel), settingOf(m_values, "method"), std::move(wall)};
}

void VoxelizeSettings::change(std::string_view id, const PropertyValue& value) {
  const auto* const number = std::get_if<double>(&value);
  if (id == "wall" && number && *number == 0.0) return m_values.reset("wall");
  if (number && !std::isfinite(*number)) return;
  takeSetting(m_values, id, value);
}

double VoxelizeSettings::proposed(Reason& reason) const {
  const double drilling = drillVoxel(kFeed, kRate), largest = m_extent.maxCoeff();
  const bool suits =
      m_purpose == Purpose::Drilling && largest >= kLeastAcross * drilling && largest <= kMostAcross * drilling;
  const double voxel = suits ? drilling : m_usual;
  reason = suits ? Reason::Drilling : Reason::Extent;
  if (!wall() || *wall() >= kAcrossWalls * voxel) return voxel;
  reason = Reason::Wall;
  return *wall() / kAcrossWalls;
}

double VoxelizeSettings::voxel() const {
  Reason reason;
  return m_values.given("voxel").value_or(proposed(reason));
}

VoxelizeSettings::Reason VoxelizeSettings::reason() const {
  Reason reason;
  proposed(reason);
  return m_values.given("voxel") ? Reason::Chosen : reason;
}

std::optional<double> VoxelizeSettings::wall() const {
  return m_values.given("wall");
}

VoxelMethod VoxelizeSettings::method() const {
  return static_cast<VoxelMethod>(m_values.whole("method"));
}

double VoxelizeSettings::across() const {
  return m_extent.maxCoeff() / voxel();
}

double VoxelizeSettings::area() const {
  return m_measure.areaWith(wall().value_or(0.0));
}

double VoxelizeSettings::bytes() const {
  return predictedMakingBytes(area(), m_extent, voxel());
}

double VoxelizeSettings::seconds() const {
  return predictedMakingSeconds(area(), voxel());
}

}  // namespace handwheel
