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

// The settings of making a volume of a surface, with what it needs. The voxel is proposed until one is
// chosen: as a share of the extent; of a part to be drilled by the rule of drilling, where that suits its size.
class VoxelizeSettings {
 public:
  // Why the voxel is as large as it is.
  enum class Reason {
    Drilling,  // whole steps of density at 1 mm/s and 1 kHz (drillVoxel())
    Extent,    // usualVoxel()
    Wall,      // four to a wall
    Chosen,
  };

  // What the volume is for.
  enum class Purpose { Any, Drilling };

  // O(n).
  explicit VoxelizeSettings(const TriangleSoup& surface, Purpose purpose = Purpose::Any);

  // Voxel, method and wall thickness; 0: none.
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
  double area() const;  // mm², with both sides of walls

  Purpose m_purpose;
  WallMeasure m_measure;
  Vec3 m_extent;
  double m_usual;
  OperationValues m_values;
};

}  // namespace handwheel
