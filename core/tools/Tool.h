// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "document/DisplayModel.h"
#include "document/Property.h"
#include "mesh/search/PickRay.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Button of the mouse or of a haptic device.
enum class PointerButton { None, First, Second };  // left and right of the mouse; the two of a haptic device

// The modifier keys that are pressed.
struct Modifiers {
  bool shift = false;
  bool control = false;
  bool alt = false;
};

// Input event of a 3D pointer: the mouse or a haptic device. The mouse points along a ray; a haptic device also has a
// tip, and its ray runs along its stylus. Tools read the ray and, if they need it, the pose.
struct PointerEvent {
  enum class Kind { Hover, Press, Drag, Release, DoubleClick, Leave };
  Kind kind = Kind::Hover;
  Ray ray;
  PointerButton button = PointerButton::None;
  Modifiers modifiers;
  // The position of the viewer; none under parallel projection, for which all rays are parallel.
  std::optional<Vec3> eye;
  double pixel = 0.0;          // mm per logical pixel at the focus of the view
  std::optional<Pose> device;  // mm; tip of a haptic device, if that is the source
  double focus = 0.0;          // mm from the eye to the focus of the view; 0: unknown
  std::optional<Vec3> held;    // mm; the point on a corner or an edge that attracts the device tip
  std::optional<Vec3> proxy;   // mm; displayed position of the device tip, which the touched surface holds back
  // Time of the mouse event, s, by a clock of its own. None: unknown.
  std::optional<double> time = {};
  std::optional<double> pressure = {};  // 0 to 1, for a pen; none: another pointer, or unknown

  PickRay pickRay() const { return {ray, eye, pixel, focus}; }
};

// The response of a tool to an input.
enum class ToolReply {
  Ignored,  // not handled: the camera may use it
  Used,
  Finished,  // the tool has committed or reverted, and can be left
};

// An action that the tool offers now, declared as data. The hint bar, the menus and the keys are generated from it.
struct ToolAction {
  std::string id;      // "commit", "grow"; the argument of perform(). Empty: a hint on the pointer only.
  std::string input;   // English, context "ToolInput": "Click", "Shift+drag", "Wheel"; or a key: "Return", "Esc", "B"
  std::string effect;  // English, context "Tool": "select a face"
  bool enabled = true;
  std::string command = {};  // command of the window that does the same and has the key: "nextHole"; mostly none
  std::string reason = {};   // the reason why it is not enabled, if that is not plain; English, context "Tool"
  bool isKeyOnly = false;    // no button for it: a panel has something better
};

// Base class of previews in the terms of one kind of document. The user interface of that kind knows the type.
struct KindPreview {
  virtual ~KindPreview() = default;
};

// Lengths that a tool displays beside a point of the model, in the unit of the document: "⌀ 31.20 mm  Z 45.00 mm".
struct ToolLabel {
  struct Figure {
    std::string prefix;  // symbol of the figure, not translated: "⌀"; may be empty
    double value = 0.0;  // mm
  };
  Vec3 position = Vec3::Zero();  // mm
  std::vector<Figure> figures;
};

// Temporary geometry that a tool displays over the document. Nothing of it is in the document.
struct ToolPreview {
  std::vector<DisplayPart> parts;                 // proposed geometry, drawn translucent
  std::vector<std::vector<Vec3>> lines;           // polylines over the model: a lasso, a ruler; mm
  std::optional<std::pair<Vec3, double>> circle;  // brush: centre on the surface and radius; mm
  // Shown and picked instead of the parts of the document; null: those of the document. While the tool works, only
  // parts with another soup are built again.
  std::shared_ptr<const DisplayModel> replaced;
  std::shared_ptr<const KindPreview> ofKind;  // null: nothing more
  std::optional<ToolLabel> label = {};
};

// A spring and damper that a tool applies to the device tip. mm and newtons. The servo loop adds those of all tools and
// services and passes the sum through the safety chain.
struct DeviceSpring {
  Vec3 target = Vec3::Zero();  // the tip is pulled there
  double stiffness = 0.0;      // N/mm, at the device
  double damping = 0.0;        // N·s/mm, at the device
  // Orientation that the tip is turned to, for devices with motors for torque.
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  double turning = 0.0;  // N·mm/rad, at the device
};

// The features that attract the device tip while nothing is grabbed. They make the selectable features easy to hit.
struct SnapTargets {
  bool borderPoints = false;  // points of open edges
  bool borderEdges = false;   // open edges
  bool corners = false;       // ends of the edges at which the surface bends or ends
  bool edges = false;         // these edges
  bool faces = false;         // the surface, from above

  // Returns true if features are everywhere on the surface, so that only those near the tip can be considered.
  bool areEverywhere() const { return corners || edges || faces; }
  bool operator==(const SnapTargets&) const = default;
};

// Base class of interactive tools, independent of the window. From press to release it receives events, shows a
// preview, and commits one edit to its document or reverts. Window thread. Tests send it the same events.
class Tool {
 public:
  virtual ~Tool() = default;

  virtual std::string id() const = 0;  // "select"
  // Returns the name in recordings of a device, with the mode of the tool: "turn bore".
  virtual std::string recordedName() const { return id(); }
  virtual ToolReply pointer(const PointerEvent& event) = 0;
  // Executes one of the declared actions, by key, button or menu. "commit" and "revert" are common to all tools.
  virtual ToolReply perform(std::string_view action) = 0;
  virtual std::vector<ToolAction> actions() const = 0;
  // Called first by undo while the tool runs. Used: it has reverted its unfinished work, and that is all. Ignored: the
  // last step of the document is to be undone, which the tool may just have made.
  virtual ToolReply undo() { return isLive() ? perform("revert") : ToolReply::Ignored; }

  virtual ToolPreview preview() const { return {}; }
  // Returns true if the preview changes by itself, as that of a running simulation does: it is then shown with each
  // frame, not only after an input.
  virtual bool isLive() const { return false; }
  // Returns true if work that continued after an input is done: then resume() is called, while the tool is live.
  virtual bool isDue() const { return false; }
  virtual ToolReply resume() { return ToolReply::Ignored; }
  virtual std::vector<Property> settings() const { return {}; }
  virtual void setSetting(std::string_view id, const PropertyValue& value) {
    (void)id;
    (void)value;
  }
  // Returns true if settings of the user hold when the tool is started again, for any document. False for a tool whose
  // settings describe the next edit, or are kept by the owner of its services.
  virtual bool remembersSettings() const { return true; }
  // Returns true if a setting holds for the present document alone when it is remembered, as a plane of symmetry of its
  // part.
  virtual bool isOfDocument(std::string_view setting) const {
    (void)setting;
    return false;
  }
  virtual std::vector<DeviceSpring> forces() const { return {}; }
  virtual SnapTargets snapTargets() const { return {}; }

  // Called before the tool ends, and before its document is saved, handed in or closed. A tool whose work takes effect
  // immediately commits it here. The unfinished work of other tools is a proposal, which is dropped.
  virtual void settle() {}

  // Called after the document has changed: the unfinished work of the tool is discarded.
  virtual void documentChanged() {}

  // Returns the services that the tool requires: "picking", "fill preview". Only required services run.
  virtual std::vector<std::string> needs() const { return {}; }

  // Sets the listener, which is called after preview or actions change without an input, for example at the end of a
  // job.
  void whenUpdated(std::function<void()> listener) { m_listener = std::move(listener); }

 protected:
  void reportUpdated() const {
    if (m_listener) m_listener();
  }

 private:
  std::function<void()> m_listener;
};

}  // namespace handwheel
