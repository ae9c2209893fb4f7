// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "tools/ToolKey.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"
#include "volume/repair/TriangleWalls.h"

#include <memory>
#include <optional>

namespace handwheel {

class MeshDocument;

// Tool that repairs a mesh by the volume that it encloses (volumeRepairChange()). It is meant for defects that the
// repair of triangles leaves, such as interpenetrating bodies, self-intersections and inner walls.
class VolumeRepairTool : public Tool {
 public:
  // A function that asks whether this number of bytes may be used. If the user agrees, it calls start, at once or
  // later.
  using AskForMemory = std::function<void(double bytes, std::function<void()> start)>;

  // Only the destructor may be called after the document has been destroyed. ask: called if needsConsent() returns
  // true.
  VolumeRepairTool(
      MeshDocument& document, MeshServices services,
      AskForMemory ask = [](double, const std::function<void()>& start) { start(); });

  static std::span<const ToolKey> keys();
  std::string id() const override { return "volume-repair"; }
  ToolReply pointer(const PointerEvent&) override { return ToolReply::Ignored; }
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  void documentChanged() override;

 private:
  void measure();
  std::optional<double> area() const;
  double predictedBytes(double sampled) const;  // sampled: area, mm²

  MeshDocument& m_document;
  MeshServices m_services;
  AskForMemory m_ask;
  double m_area = 0.0;                 // area of the mesh, mm²
  std::optional<WallMeasure> m_walls;  // walls of the mesh; none: a job is measuring them
  std::shared_ptr<const int> m_job;    // identifies the running job; null: no job is running
  Vec3 m_extent = Vec3::Zero();        // extent of the mesh, mm
  double m_usual = 0.0;                // usual voxel size, mm; 0: there are no triangles
  VolumeRepairParameters m_parameters;
};

}  // namespace handwheel
