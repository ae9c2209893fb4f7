// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/scene/BodyOwner.h"
#include "tools/ToolKey.h"
#include "tools/scene/BodySelection.h"
#include "tools/scene/FloorDrag.h"

#include <QString>

namespace handwheel {

class Document;

// Returns the text of the undo step that removes these bodies.
QString removeBodiesText(const BodySet& bodies, const std::set<BodyId>& ids);

// The first hit of a ray on a body.
struct BodyPick {
  BodyId body;
  Vec3 point;  // mm
};

// Tool that selects bodies by a click and moves them by dragging. A body moves on the horizontal plane through the
// grabbed point. With Shift, or if that plane is seen from the side, the body moves along Z. Its position snaps to a
// step that fits the zoom, except with Ctrl. When the button is released, the move is committed as one edit.
class BodyDragTool : public Tool {
 public:
  using Pick = std::function<std::optional<BodyPick>(const Ray&)>;
  // The document must be a BodyOwner, too. The selection must outlive the tool.
  template <class OwningDocument>
  BodyDragTool(OwningDocument& document, BodySelection& selection, Pick pick)
      : m_document(document), m_owner(document), m_selection(selection), m_pick(std::move(pick)) {}

  bool isDragging() const { return m_drag.has_value(); }
  // Returns the body at its dragged pose; null if no body is dragged, or the dragged body has not moved.
  const Body* moved() const { return m_drag && m_drag->floor.hasMoved() ? &m_drag->body : nullptr; }

  // Returns true if the body is dragged along Z instead of over the floor.
  bool isUpright() const { return m_drag && m_drag->floor.isUpright(); }

  static std::span<const ToolKey> keys();
  std::string id() const override { return "bodies"; }
  ToolReply pointer(const PointerEvent& given) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  struct Drag {
    Body body;  // Body at its present pose
    FloorDrag floor;
  };

  ToolReply press(const PointerEvent& event);
  void follow(const PointerEvent& event);
  ToolReply release();
  ToolReply remove();

  Document& m_document;
  const BodyOwner& m_owner;
  BodySelection& m_selection;
  Pick m_pick;
  std::optional<Drag> m_drag;
};

}  // namespace handwheel
