// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundarySmoothing.h"
#include "mesh/boundary/BoundaryWelding.h"
#include "mesh/boundary/VertexDrag.h"
#include "tools/ToolKey.h"
#include "tools/mesh/MeshSelection.h"
#include "tools/mesh/boundary/BoundaryPicking.h"

namespace handwheel {

struct MeshPreview;

// Tool for editing the edges of holes by hand (He 2008, section 4.1.4). The pointer pulls a point of an edge, joins it
// with another point, or adds a bridge between the two points. A chosen edge can be smoothed, and its islands and
// peninsulas can be removed. A change of a whole edge is previewed first and applied with Return.
class BoundaryTool : public Tool {
 public:
  // Only the destructor may be called after the document has been destroyed. first: the key of the loop that is chosen
  // first.
  BoundaryTool(MeshDocument& document, MeshServices services, std::optional<Vertex> first = std::nullopt);
  ~BoundaryTool() override;

  // Chooses a loop by its key. If there is no such loop, no loop is chosen.
  void choose(std::optional<Vertex> key);
  const BoundaryLoop* loop() const;  // the chosen loop; null: none
  bool isBusy() const { return m_drag || m_proposal || m_job; }
  JoinProblem problem() const { return m_drag ? m_drag->problem : JoinProblem::None; }

  static std::span<const ToolKey> keys();
  std::string id() const override { return "boundary"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  std::vector<DeviceSpring> forces() const override;
  SnapTargets snapTargets() const override { return {.borderPoints = true, .borderEdges = true}; }
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  // Effect of dropping a point onto another; Shift selects the other effect.
  enum class Onto { Join, Bridge };
  // Effect of the drag on the dragged point.
  enum class Effect { Pull, Weld, Bridge };
  struct Drag {
    std::shared_ptr<const FaceLocator> near;
    BoundaryPoint held;
    VertexDrag pull;
    Ray grip;                      // ray of the pointer at the press
    std::optional<Vec3> tip = {};  // tip of the device at the press, mm
    double still = 0.0;            // a motion shorter than this is a click; mm
    bool hasMoved = false;
    Effect effect = Effect::Pull;
    Vec3 position = Vec3::Zero();  // position of the pointer, or of the point that attracts the pointer
    Vec3 stop = Vec3::Zero();      // final position of the pulled point
    HalfEdge target = kNone;       // half-edge at the point that attracts the pointer; kNone: no point
    JoinProblem problem = JoinProblem::None;
    BoundaryWeld weld = {};
    Bridge bridge = {};
  };
  // The kind of change that an action proposes for the chosen loop.
  enum class Kind { Smooth, Islands, Peninsulas };
  struct Proposal {
    Kind kind;
    SmoothingOptions options;
    SmoothedBoundary smoothed;
    FaceSelection faces;  // faces that change or are removed
    std::shared_ptr<const TriangleSoup> shapes;
  };

  ToolReply hover(const PointerEvent& event);
  ToolReply press(const PointerEvent& event);
  ToolReply release(const PointerEvent& event);
  void follow(const PointerEvent& event);
  void aim(Effect effect, HalfEdge target);
  void commitDrag(const Drag& drag);

  ToolReply propose(Kind kind);
  std::function<Proposal(Progress)> workFor(Kind kind) const;
  ToolReply commitProposal();
  ToolReply revert();
  void dropProposal();
  std::optional<Vertex> neighbour(bool forward) const;
  bool isHeld(const Proposal& proposal) const;
  void addDragPreview(ToolPreview& preview, MeshPreview& onMesh) const;
  const char* dragEffect() const;
  const HalfEdgeMesh& mesh() const;

  MeshDocument& m_document;
  MeshServices m_services;
  BoundaryPicking m_picking;
  SmoothingOptions m_smoothing;
  Onto m_onto = Onto::Join;
  std::optional<Vertex> m_key;          // key of the chosen loop
  std::optional<Vertex> m_hoveredLoop;  // key of the loop under the pointer
  std::optional<BoundaryPoint> m_hovered;
  double m_mark = 0.0;  // radius of the mark on a point, mm
  std::optional<Drag> m_drag;
  std::optional<Proposal> m_proposal;
  std::shared_ptr<const Kind> m_job;  // identifies the running job; results of earlier jobs are ignored
};

}  // namespace handwheel
