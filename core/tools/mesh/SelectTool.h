// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/BrushStroke.h"
#include "mesh/selection/Lasso.h"
#include "tools/ToolKey.h"
#include "tools/mesh/MeshSelection.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/SelectSettings.h"

#include <variant>

namespace handwheel {

class MeshDocument;

// Tool that selects faces and holes. The modes are click, brush, lasso, connected component, and smooth region up to an
// angle. Shift adds to the selection, Control removes from it. Selecting is not an edit of the document; deleting the
// selection is one.
class SelectTool : public Tool {
 public:
  // Only the destructor may be called after the document has been destroyed.
  SelectTool(MeshDocument& document, MeshServices services, MeshSelection selection = {});
  ~SelectTool() override;

  // The selection, including the faces that the present stroke has painted so far.
  const MeshSelection& selection() const { return m_live ? *m_live : m_steps.present(); }
  // Sets the selection, for example from a list.
  void select(MeshSelection selection);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "select"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;  // includes the number of selected faces
  void setSetting(std::string_view id, const PropertyValue& value) override;
  SnapTargets snapTargets() const override;
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  using Mode = SelectSettings::Mode;
  enum class Combine { Replace, Add, Remove };

  // The loop or face under a ray.
  struct Target {
    std::optional<Vertex> loop;
    std::optional<FaceHierarchy::Hit> hit;

    bool isNothing() const { return !loop && !hit; }
  };
  struct Pressed {
    Target target;
    Combine how;
  };
  struct Stroke {
    BrushStroke brush;
    Combine how;
  };
  struct Path {
    std::shared_ptr<const FaceHierarchy> faces;
    Lasso lasso;
    Combine how;
    double depth;  // distance along the rays, mm, at which the line is drawn
  };

  ToolReply press(const PointerEvent& event);
  ToolReply drag(const PointerEvent& event);
  ToolReply release(const PointerEvent& event);
  ToolReply hover(const PointerEvent& event);

  Target targetOf(const PointerEvent& event) const;
  // Extends the stroke or the lasso.
  void extend(const PointerEvent& event);
  void paint(Stroke& stroke, const PointerEvent& event);
  void selectTarget(const Target& target, Combine how);
  void selectConnected(Face seed, Combine how);
  void selectLater(const char* name, std::function<std::optional<FaceSelection>(Progress)> find, Combine how);
  void combine(const MeshSelection& found, Combine how);
  FaceSelection regionOf(Face seed) const;
  ToolReply revert();
  void dropGesture();
  void cancelJob();
  void step(bool forward);
  MeshSelection presentAlive() const;
  const HalfEdgeMesh& mesh() const;
  static Combine combineOf(const Modifiers& modifiers);

  MeshDocument& m_document;
  MeshServices m_services;
  SelectSettings m_settings;
  SelectionHistory m_steps;
  std::optional<MeshSelection> m_live;
  std::variant<std::monostate, Pressed, Stroke, Path> m_gesture;

  FaceSelection m_hovered;
  std::optional<Vertex> m_hoveredLoop;
  std::optional<std::pair<Vec3, double>> m_circle;

  // Identifies the running job; results of earlier jobs are ignored. It is destroyed with the tool, so that later
  // results are ignored too.
  std::shared_ptr<const int> m_job;
};

}  // namespace handwheel
