// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/ToolKey.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/operations/SubdivideOperation.h"

namespace handwheel {

class MeshDocument;

// Tool that subdivides a whole mesh by a scheme (subdivideAll()). The initial scheme leaves the surface unchanged.
class SubdivideTool : public Tool {
 public:
  // Only the destructor may be called after the document has been destroyed.
  SubdivideTool(MeshDocument& document, MeshServices services);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "subdivide"; }
  ToolReply pointer(const PointerEvent&) override { return ToolReply::Ignored; }
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;

 private:
  double facesAfterwards() const;

  MeshDocument& m_document;
  MeshServices m_services;
  OperationValues m_values{subdivideMeshOperation()};
};

}  // namespace handwheel
