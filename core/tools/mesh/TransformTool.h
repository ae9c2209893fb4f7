// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/ToolKey.h"
#include "tools/mesh/Placement.h"

namespace handwheel {

class MeshDocument;

// Tool that moves, rotates and scales a whole mesh by numbers. It also has standard placements: onto its largest flat
// face, along its main axes, to the origin. The resulting bounding box is shown. The numbers are those of the next edit
// and are reset after each, so that nothing is scaled twice.
class TransformTool : public Tool {
 public:
  // The document must outlive all calls but the destructor's.
  TransformTool(MeshDocument& document, MeshServices services)
      : m_document(document), m_services(std::move(services)) {}

  // The transformation of the present mesh.
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
