// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "document/Operation.h"
#include "mesh/structure/TriangleSoup.h"
#include "volume/SurfaceDensity.h"
#include "volume/repair/TriangleWalls.h"

#include <optional>
#include <vector>

namespace handwheel {

// The settings for making a volume of a surface, and the cost. A voxel is proposed until the user chooses one: a
// fraction of the extent, or, for drilling, the voxel by the rule of drilling if it suits the size of the part.
class VoxelizeSettings {
 public:
  // The reason for the size of the voxel.
  enum class Reason {
    Drilling,  // the rule of drilling: whole steps of density at 1 mm/s and 1 kHz (drillVoxel())
    Extent,    // a fraction of the extent: usualVoxel()
    Wall,      // the walls: four voxels per wall
    Chosen,
  };

  // The purpose of the volume.
  enum class Purpose { Any, Drilling };

  // Measures the surface. O(n).
  explicit VoxelizeSettings(const TriangleSoup& surface, Purpose purpose = Purpose::Any);

  // Returns the properties: the voxel, the method, and the wall thickness. Wall thickness 0: no walls.
  std::vector<Property> properties() const;
  void change(std::string_view id, const PropertyValue& value);

  double voxel() const;  // mm
  Reason reason() const;
  std::optional<double> wall() const;  // mm
  VoxelMethod method() const;
  double across() const;  // number of voxels along the largest extent
  double bytes() const;   // memory by predictedMakingBytes()
  double seconds() const;

 private:
  double proposed(Reason& reason) const;
  double area() const;  // mm², including both sides of the walls

  Purpose m_purpose;
  WallMeasure m_measure;
  Vec3 m_extent;
  double m_usual;
  OperationValues m_values;
};

}  // namespace handwheel
