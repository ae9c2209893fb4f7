// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellDocument.h"
#include "planning/DrawnCurve.h"
#include "tools/cell/JointDragTool.h"
#include "tools/cell/ProcessPathOperation.h"

namespace handwheel {

// Services that ProcessPathTool uses.
struct ProcessPathServices {
  JointDragTool::Pick pick;
  // The surface of a body; null while it is being prepared.
  std::function<std::shared_ptr<const PartSurface>(const BodyPointer& body)> surface;
  // Plans with these values, which name the part.
  std::function<void(const OperationValues& values)> plan;
};

// Tool that selects the curve on a part that the robot's tool follows. It is an edge or a section of the part. The
// curve under the pointer is shown, a click takes it, and the settings say how the tool is held; "commit" plans the
// path. A curve can be drawn, too: by clicks on the part, or in one go.
class ProcessPathTool : public Tool {
 public:
  ProcessPathTool(const RobotCellDocument& document, ProcessPathServices services);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "process"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  // Edges are hard to hit by hand.
  SnapTargets snapTargets() const override { return {.corners = true, .edges = true}; }
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  // Where a curve was pointed to.
  struct Place {
    BodyId body = 0;
    Vec3 point = Vec3::Zero();  // in the frame of the robot's base
  };
  std::optional<Place> placeAt(const PointerEvent& event) const;
  // The same, or the place beside it on a part that the pointer just misses an edge of.
  std::optional<Place> placeNear(const PointerEvent& event) const;
  SurfaceTrack trackAt(const Place& place) const;
  SurfaceTrack shown() const;
  bool isDrawing() const { return m_values.whole("along") == kAlongDrawn; }
  // Begins the curve at the chosen place, without any other.
  void beginDrawing();
  bool drawTo(const Place& place);
  SurfaceTrack drawnTrack() const;
  ToolReply press(const PointerEvent& event);
  ToolReply drag(const PointerEvent& event);
  std::vector<std::string> ends() const;  // names of configurations
  void look();

  const RobotCellDocument& m_document;
  ProcessPathServices m_services;
  OperationValues m_values;
  std::optional<Place> m_hovered, m_chosen;
  SurfaceTrack m_track;  // that is shown
  // Of a drawn curve: where it goes on to from the chosen place, in the frame of the base; the curve before each of
  // these and after the last, in that of the body, as it is then.
  std::vector<Vec3> m_through;
  std::vector<DrawnCurve> m_drawn;
  BodyPointer m_drawnOn;
};

}  // namespace handwheel
