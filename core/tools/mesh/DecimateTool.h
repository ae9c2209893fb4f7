// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/ToolKey.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/operations/DecimateOperation.h"

namespace handwheel {

class MeshDocument;

// Tool that reduces the number of triangles of a mesh (decimate()). The goal is a number of triangles, or the smallest
// number that stays within a distance of the present surface.
class DecimateTool : public Tool {
 public:
  // Only the destructor may be called after the document has been destroyed.
  DecimateTool(MeshDocument& document, MeshServices services);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "decimate"; }
  ToolReply pointer(const PointerEvent&) override { return ToolReply::Ignored; }
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  void documentChanged() override;

 private:
  enum class Goal { Count, Distance };
  DecimationOptions options() const;
  void resetGoals();
  void setFaces(double faces);
  bool isQuadric() const;
  Goal goal() const { return isQuadric() ? Goal::Count : m_goal; }

  MeshDocument& m_document;
  MeshServices m_services;
  Goal m_goal = Goal::Count;
  // The values of both goals and the crease angle, including those not used at present.
  OperationValues m_values{decimateOperation()};
  bool m_keepsCreases = false;
};

}  // namespace handwheel
