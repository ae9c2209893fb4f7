// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellDocument.h"
#include "tools/cell/FlatFace.h"
#include "tools/cell/PlaceBodyTool.h"

namespace handwheel {

// Tool that lays a body with one of its faces on another face. The first click takes a face of the body to be laid, the
// second a face of another body or of the robot, on which the body is to lie. The preview shows the body on that face,
// with an offset and a rotation that can be changed; committing is one edit. Faces are pointed at by the mouse, or by
// the ray of a device.
class FaceMateTool : public Tool {
 public:
  // The selection must outlive the tool.
  FaceMateTool(RobotCellDocument& document, BodySelection& selection, PlaceBodyServices services);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "snap"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  SnapTargets snapTargets() const override { return {.faces = true}; }
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  enum class Meeting { Middles, Points };
  struct Pointed {
    std::string part;
    FlatFace face;
  };

  std::optional<Pointed> pointedBy(const PointerEvent& event, bool isWhole) const;
  ToolReply take(const PointerEvent& event);
  std::optional<Body> placed() const;  // In the frame of the base; nothing: a face is not chosen yet
  const Vec3& meetingPointOf(const FlatFace& face) const;
  ToolReply commit();

  RobotCellDocument& m_document;
  BodySelection& m_selection;
  PlaceBodyServices m_services;
  std::optional<Pointed> m_hovered, m_first, m_second;
  BodyId m_body = 0;  // The body with the face m_first
  Meeting m_meeting = Meeting::Middles;
  double m_offset = 0.0;  // mm
  double m_angle = 0.0;   // rad
};

}  // namespace handwheel
