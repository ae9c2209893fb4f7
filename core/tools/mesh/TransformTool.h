// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/ToolKey.h"
#include "tools/mesh/Placement.h"

namespace handwheel {

class MeshDocument;

// Tool that moves, rotates and scales a whole mesh by numbers. It also offers standard placements: onto the largest
// flat face, along the main axes, or at the origin. The resulting bounding box is shown. The numbers describe the next
// edit and are reset after it, so that the mesh is not scaled twice.
class TransformTool : public Tool {
 public:
  // Only the destructor may be called after the document has been destroyed.
  TransformTool(MeshDocument& document, MeshServices services)
      : m_document(document), m_services(std::move(services)) {}

  // Returns the transformation of the present mesh that the numbers describe.
  Eigen::Affine3d placement() const;

  static std::span<const ToolKey> keys();
  std::string id() const override { return "transform"; }
  ToolReply pointer(const PointerEvent&) override { return ToolReply::Ignored; }
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  bool remembersSettings() const override { return false; }

 private:
  bool isIdle() const { return m_placement == Placement(); }

  MeshDocument& m_document;
  MeshServices m_services;
  Placement m_placement;
};

}  // namespace handwheel
