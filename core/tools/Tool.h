// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "document/DisplayModel.h"
#include "document/Property.h"
#include "mesh/FaceSelection.h"
#include "mesh/LiveMesh.h"
#include "mesh/Sight.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

enum class PointerButton { None, First, Second };  // left and right of the mouse; the two of a haptic device

struct Modifiers {
  bool shift = false;
  bool control = false;
  bool alt = false;
};

// What a pointer does in space. The mouse points along a ray; a haptic device has a tip there, too, and its ray runs
// along its stylus. Tools read the ray and, where they care, the pose.
struct PointerEvent {
  enum class Kind { Hover, Press, Drag, Release, DoubleClick, Leave };
  Kind kind = Kind::Hover;
  Ray ray;
  PointerButton button = PointerButton::None;
  Modifiers modifiers;
  // Where the viewer stands; none under parallel projection, when all rays run alike.
  std::optional<Vec3> eye;
  double pixel = 0.0;          // mm to a logical pixel: at the focus of the view
  std::optional<Pose> device;  // mm; of the tip of a haptic device, when that is the source
  double focus = 0.0;          // mm from the eye to the focus of the view; 0: not known
  std::optional<Vec3> held;    // mm; the place on a corner or an edge that draws the tip of the device

  Sight sight() const { return {ray, eye, pixel, focus}; }
};

// What a tool makes of an input.
enum class ToolReply {
  Ignored,  // not meant for it: the camera may have it
  Used,
  Finished,  // the tool has committed or given up, and can be left
};

// Something the tool can do now, declared as data: the hint bar, the menus and the keys are made from it.
struct ToolAction {
  std::string id;      // "commit", "grow"; what perform() takes. Empty: a hint on the pointer only.
  std::string input;   // English, context "ToolInput": "Click", "Shift+drag", "Wheel"; or a key: "Return", "Esc", "B"
  std::string effect;  // English, context "Tool": "select a face"
  bool enabled = true;
  std::string command = {};  // of the window, that does the same and whose key it is: "nextHole"; mostly none
};

// What the tool shows over the document while it works; nothing of it is in the document.
struct ToolPreview {
  std::vector<DisplayPart> parts;                 // proposed geometry, drawn translucent
  FaceSelection highlighted;                      // faces under the pointer or about to be selected
  std::vector<std::vector<Vec3>> lines;           // polylines over the model: a lasso, a ruler; mm
  std::optional<std::pair<Vec3, double>> circle;  // brush: centre on the surface and radius; mm
  FaceSelection selected;                         // faces that are selected now
  std::shared_ptr<const LiveMesh> live;           // null: the document's mesh
};

// A contribution to the force that the user feels, mm and newtons. The servo loop adds those of all tools and services
// and passes the sum through the safety chain.
struct ForceTerm {
  Vec3 target = Vec3::Zero();  // the tip is drawn there
  double stiffness = 0.0;      // N/mm, at the hand
  double damping = 0.0;        // N·s/mm, at the hand
};

// What draws the tip of a device while nothing is held, so that what a click takes is easily hit.
struct Magnets {
  bool borderPoints = false;  // points of open edges
  bool borderEdges = false;   // open edges
  bool corners = false;       // ends of the edges where the surface bends or ends,
  bool edges = false;         // and these edges
  bool faces = false;         // the surface, from above

  // Of what is everywhere on a surface only what is near the tip can be looked at.
  bool areEverywhere() const { return corners || edges || faces; }
  bool operator==(const Magnets&) const = default;
};

// What happens between press and release, without a window: fed with events, a tool shows a preview, and commits one
// edit to its document or reverts. Window thread. Tests feed it the same events.
class Tool {
 public:
  virtual ~Tool() = default;

  virtual std::string id() const = 0;  // "select"
  virtual ToolReply pointer(const PointerEvent& event) = 0;
  // One of the declared actions, by key, button or menu. "commit" and "revert" are common to all tools.
  virtual ToolReply perform(std::string_view action) = 0;
  virtual std::vector<ToolAction> actions() const = 0;

  virtual ToolPreview preview() const { return {}; }
  virtual std::vector<Property> settings() const { return {}; }
  virtual void setSetting(std::string_view id, const PropertyValue& value) {
    (void)id;
    (void)value;
  }
  virtual std::vector<ForceTerm> forces() const { return {}; }
  virtual Magnets magnets() const { return {}; }

  // The document has changed under the tool: what it had begun is dropped.
  virtual void documentChanged() {}

  // The services without which it cannot work: "picking", "fill preview". Only those run that somebody needs.
  virtual std::vector<std::string> needs() const { return {}; }

  // Who runs the tool hears when it shows or offers something else although nothing was asked of it: a job has ended.
  void whenUpdated(std::function<void()> listener) { m_listener = std::move(listener); }

 protected:
  void tellUpdated() const {
    if (m_listener) m_listener();
  }

 private:
  std::function<void()> m_listener;
};

}  // namespace handwheel
