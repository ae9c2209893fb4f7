// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/PreviewMesh.h"
#include "tools/ToolKey.h"
#include "tools/mesh/MeshServices.h"
#include "tools/mesh/sculpt/SculptScript.h"

#include <deque>

namespace handwheel {

class MeshDocument;

// Tool that sculpts a surface with brushes: drag, smooth, inflate and flatten. A patch, if one is given, can be
// subdivided and sculpted at each of its levels; vertices outside the patch then do not move. Each stroke is one undo
// step. The next stroke can begin on the displayed surface before the previous stroke is in the document.
class SculptTool : public Tool {
 public:
  // patch: the faces to work on; empty: the whole surface. Existing levels of a patch with all these faces are used.
  // Only the destructor may be called after the document has been destroyed.
  SculptTool(MeshDocument& document, MeshServices services, FaceSelection patch = {});
  ~SculptTool() override;

  // The levels, including the present stroke and steps that are not yet in the document.
  const PatchLevels& levels() const { return m_stroke ? m_stroke->levels() : m_levels; }
  std::size_t level() const { return m_level; }  // the level that is sculpted

  static std::span<const ToolKey> keys();
  std::string id() const override { return "sculpt"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  std::vector<DeviceSpring> forces() const override;
  void documentChanged() override;
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  // A step that is done but not yet in the document.
  struct Step {
    std::uint64_t ticket;
    PatchLevels levels;  // levels after the step
  };

  ToolReply press(const PointerEvent& event);
  ToolReply drag(const PointerEvent& event);
  ToolReply release(const PointerEvent& event);
  std::optional<SurfacePosition> positionAt(const Ray& ray) const;
  void dabAlong(const Ray& ray);
  SculptStroke::Settings strokeSettings(const Modifiers& modifiers) const;

  void start(const char* name, const char* text, std::function<SculptResult(PatchLevels, Progress)> make);
  void take(const char* text, SculptResult made);
  void subdivideLater();
  void refineLater();
  void smoothNoiseLater();
  void goBackALevel();
  void landed();
  void stepEnded(std::uint64_t ticket);
  void stepCrossed(std::size_t pairs);
  void restart();
  void setLevels(PatchLevels levels);
  void showPreviewMesh();
  ToolReply revert();
  void cancelJob();
  void dropStroke();

  MeshDocument& m_document;
  MeshServices m_services;
  SculptSettings m_settings;
  PatchLevels m_levels;  // levels including the steps that are not yet in the document
  std::size_t m_level = 0;
  bool m_isWhole = false;                    // work on the whole surface was requested, even if a patch has levels
  std::vector<std::vector<Vec3>> m_outline;  // outline of the patch
  double m_aspect = 0.0;                     // aspect ratio of the triangles along the outline
  const char* m_problem = nullptr;           // problem of the last action
  std::size_t m_crossings = 0;  // number of pairs of faces that have begun to intersect since the last press

  std::optional<SculptStroke> m_stroke;
  Ray m_last;                 // ray of the last dab
  std::optional<Vec3> m_tip;  // tip of a haptic device at the beginning of the stroke
  std::optional<SurfacePosition> m_hovered;

  HalfEdgeMesh m_known;  // the document's mesh at the last update
  std::deque<Step> m_waiting;
  std::uint64_t m_ticket = 0;  // ticket of the last step
  FaceSelection m_touched;     // faces touched by the steps that are not yet in the document
  std::shared_ptr<const PreviewMesh> m_previewMesh;

  std::shared_ptr<const int> m_job;  // the running job, as in SelectTool
  std::shared_ptr<const int> m_alive =
      std::make_shared<const int>();  // destroyed with the tool, so that late callbacks are ignored
};

}  // namespace handwheel
