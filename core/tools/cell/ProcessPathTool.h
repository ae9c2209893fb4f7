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
  // Returns the surface of a body; null while it is being prepared.
  std::function<std::shared_ptr<const PartSurface>(const BodyPointer& body)> surface;
  // Plans a path with these values, which also name the part.
  std::function<void(const OperationValues& values)> plan;
};

// Tool that selects the curve on a part that the robot's tool follows. The curve is an edge or a section of the part.
// The curve under the pointer is shown, a click takes it, and the settings define how the tool is held; "commit" plans
// the path. A curve can also be drawn: by clicks on the part, or in one stroke.
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
  // Returns corners and edges, which are hard to hit by hand.
  SnapTargets snapTargets() const override { return {.corners = true, .edges = true}; }
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  // A point on a body at which a curve is chosen.
  struct BodyPoint {
    BodyId body = 0;
    Vec3 point = Vec3::Zero();  // Position in the frame of the robot's base
  };
  std::optional<BodyPoint> bodyPointAt(const PointerEvent& event) const;
  // Returns the point on a body under the pointer, or else the nearest point on a part whose edge the pointer just
  // misses.
  std::optional<BodyPoint> bodyPointNear(const PointerEvent& event) const;
  SurfaceTrack trackAt(const BodyPoint& bodyPoint) const;
  SurfaceTrack shown() const;
  bool isDrawing() const { return m_values.whole("along") == kAlongDrawn; }
  // Begins the curve at the chosen point, and removes all other points.
  void beginDrawing();
  bool drawTo(const BodyPoint& bodyPoint);
  SurfaceTrack drawnTrack() const;
  ToolReply press(const PointerEvent& event);
  ToolReply drag(const PointerEvent& event);
  std::vector<std::string> ends() const;  // Names of configurations
  void look();

  const RobotCellDocument& m_document;
  ProcessPathServices m_services;
  OperationValues m_values;
  std::optional<BodyPoint> m_hovered, m_chosen;
  SurfaceTrack m_track;  // The displayed curve
  // The points after the chosen one through which a drawn curve leads, in the frame of the base; and the curve up to
  // the chosen point and up to each of these points, in the frame of the body when it was drawn.
  std::vector<Vec3> m_through;
  std::vector<DrawnCurve> m_drawn;
  BodyPointer m_drawnOn;
};

}  // namespace handwheel
