// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellDocument.h"
#include "tools/AxisDrag.h"
#include "tools/ToolKey.h"

#include <functional>

namespace handwheel {

// The first hit of a ray on a robot cell.
struct RobotCellPick {
  std::string part;  // Name of the part, as in displayOf()
  Vec3 point;        // mm
};

// Tool that moves a robot by dragging its links. The joint nearest to the link follows the pointer, or the whole arm if
// Shift is pressed. The joints stay within their limits. Releasing commits one edit.
class JointDragTool : public Tool {
 public:
  using Pick = std::function<std::optional<RobotCellPick>(const Ray&)>;
  JointDragTool(RobotCellDocument& document, Pick pick) : m_document(document), m_pick(std::move(pick)) {}

  // Returns the joint values of the preview while a link is dragged, otherwise those of the document.
  const JointValues& joints() const { return m_drag ? m_drag->values : m_document.joints(); }
  bool isDragging() const { return m_drag.has_value(); }
  bool hasMoved() const { return m_drag && m_drag->values != m_drag->start; }

  static std::span<const ToolKey> keys();
  std::string id() const override { return "joints"; }
  ToolReply pointer(const PointerEvent& given) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void settle() override;
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  // A picked link with the joint that it drags.
  struct Hold {
    std::uint32_t link = kNone;   // The picked link
    std::uint32_t joint = kNone;  // The nearest joint that moves the picked point
    HeldPoint at;
  };
  struct Drag {
    Hold hold;
    Ray grip;  // Ray at the press
    bool hasMoved = false;
    bool isWholeArm = false;
    double travel = 0.0;  // Motion of the joint since the press, regardless of its limits; rad, mm
    JointValues start, values;
  };

  std::optional<Hold> holdAt(const Ray& ray) const;
  Property settingOf(std::uint32_t dof, const std::string& id) const;
  bool isItsOwn(std::uint32_t joint) const;
  ToolReply press(const PointerEvent& event);
  ToolReply release();
  void follow(const PointerEvent& event);
  void followWithJoint(const PointerEvent& event);
  void followWithPull(const Ray& ray, std::uint32_t onlyDof);

  RobotCellDocument& m_document;
  Pick m_pick;
  std::optional<Hold> m_hovered;
  std::optional<Drag> m_drag;
};

}  // namespace handwheel
