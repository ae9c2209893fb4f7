// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/ToolKey.h"
#include "tools/mesh/boundary/BoundaryPicking.h"

namespace handwheel {

// Tool that creates single faces from three clicked points of open edges. The points are clicked one after the other,
// counter-clockwise as seen from outside, and the third click creates the face. The face takes the orientation of the
// surface. It must share an edge with the surface, and must not touch it elsewhere than at its corners and shared
// edges.
class MakeFaceTool : public Tool {
 public:
  // Only the destructor may be called after the document has been destroyed.
  MakeFaceTool(MeshDocument& document, MeshServices services);

  std::size_t cornerCount() const { return m_corners.size(); }
  // The problem of the face whose last corner is the point under the pointer.
  JoinProblem problem() const { return m_problem; }

  static std::span<const ToolKey> keys();
  std::string id() const override { return "face"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  SnapTargets snapTargets() const override { return {.borderPoints = true}; }
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  void hover(const PointerEvent& event);
  ToolReply press(const PointerEvent& event);
  void judge();
  const HalfEdgeMesh& mesh() const;

  MeshDocument& m_document;
  MeshServices m_services;
  BoundaryPicking m_picking;
  std::vector<Vertex> m_corners;  // at most two
  std::optional<Vertex> m_hovered;
  double m_mark = 0.0;  // radius of the mark on a point, mm
  Triangle m_face{};    // the corners and the hovered point, if there are three
  JoinProblem m_problem = JoinProblem::NoBorder;
};

}  // namespace handwheel
