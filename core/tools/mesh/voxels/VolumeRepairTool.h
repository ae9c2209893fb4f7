// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/ToolKey.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel {

class MeshDocument;

// Tool that repairs a mesh by the volume that it encloses (volumeRepairChange()), for what the repair of triangles
// leaves: bodies through one another, self-intersections, walls inside.
class VolumeRepairTool : public Tool {
 public:
  // The document must outlive all calls but the destructor's.
  VolumeRepairTool(MeshDocument& document, MeshServices services);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "volume-repair"; }
  ToolReply pointer(const PointerEvent&) override { return ToolReply::Ignored; }
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  void documentChanged() override;

 private:
  void predict();

  MeshDocument& m_document;
  MeshServices m_services;
  double m_voxel = 0.0;    // mm; 0: there are no triangles
  bool m_isOwn = false;    // the user has set it
  double m_gaps = 0.0;     // mm
  double m_megabytes = 0;  // that the voxels are going to take at least
};

}  // namespace handwheel
