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

// The settings for making a volume of a surface, with the cost. The voxel is proposed until one is chosen: as a share
// of the extent, or for drilling by the rule of drilling, if that suits the size of the part.
class VoxelizeSettings {
 public:
  // The reason for the size of the voxel.
  enum class Reason {
    Drilling,  // whole steps of density at 1 mm/s and 1 kHz (drillVoxel())
    Extent,    // usualVoxel()
    Wall,      // four voxels per wall
    Chosen,
  };

  // The purpose of the volume.
  enum class Purpose { Any, Drilling };

  // O(n).
  explicit VoxelizeSettings(const TriangleSoup& surface, Purpose purpose = Purpose::Any);

  // Returns voxel, method and wall thickness; 0: none.
  std::vector<Property> properties() const;
  void change(std::string_view id, const PropertyValue& value);

  double voxel() const;  // mm
  Reason reason() const;
  std::optional<double> wall() const;  // mm
  VoxelMethod method() const;
  double across() const;  // voxels along the largest extent
  double bytes() const;   // predictedMakingBytes()
  double seconds() const;

 private:
  double proposed(Reason& reason) const;
  double area() const;  // mm², including both sides of walls

  Purpose m_purpose;
  WallMeasure m_measure;
  Vec3 m_extent;
  double m_usual;
  OperationValues m_values;
};

}  // namespace handwheel
