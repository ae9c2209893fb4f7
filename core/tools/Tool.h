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

// Button of the mouse, left or right, or of a haptic device, first or second.
enum class PointerButton { None, First, Second };

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
  // The position of the viewer. None: the projection is parallel, and so are all rays.
  std::optional<Vec3> eye;
  double pixel = 0.0;          // mm per logical pixel at the focus of the view
  std::optional<Pose> device;  // mm; tip of a haptic device, if the event is one of a device
  double focus = 0.0;          // mm from the eye to the focus of the view; 0: unknown
  std::optional<Vec3> held;    // mm; the point on a corner or an edge that attracts the device tip
  std::optional<Vec3> proxy;   // mm; displayed position of the device tip, which the touched surface holds back
  // Time of the mouse event by its own clock, s. None: unknown.
  std::optional<double> time = {};
  std::optional<double> pressure = {};  // 0 to 1, for a pen; none: another pointer, or unknown

  PickRay pickRay() const { return {ray, eye, pixel, focus}; }
};

// The response of a tool to an input.
enum class ToolReply {
  Ignored,  // not handled: the camera may use the input
  Used,
  Finished,  // the tool has committed or reverted its work, and can be left
};

// An action that the tool offers at present. The hint bar, the menus and the keys are generated from these
// declarations.
struct ToolAction {
  std::string id;  // argument of perform(): "commit", "grow"; empty: only a hint on the pointer
  // English text, translated in the context "ToolInput": "Click", "Shift+drag"; or a key: "Return", "Esc", "B".
  std::string input;
  std::string effect;  // English text, translated in the context "Tool": "select a face"
  bool enabled = true;
  std::string command = {};  // command of the window with the same effect, which has the key: "nextHole"; empty: none
  // The reason why it is not enabled, if that is not obvious; English text, translated in the context "Tool".
  std::string reason = {};
  bool isKeyOnly = false;  // true if the action has no button, because a panel offers something better
};

// Base class of previews for one kind of document. The user interface of that kind knows the derived type.
struct KindPreview {
  virtual ~KindPreview() = default;
};

// Lengths that a tool displays beside a point of the model, in the unit of the document: "⌀ 31.20 mm  Z 45.00 mm".
struct ToolLabel {
  struct Figure {
    std::string prefix;  // symbol of the length, not translated: "⌀"; may be empty
    double value = 0.0;  // mm
  };
  Vec3 position = Vec3::Zero();  // mm
  std::vector<Figure> figures;
};

// Temporary geometry that a tool displays over the document. The document does not contain it.
struct ToolPreview {
  std::vector<DisplayPart> parts;                 // proposed geometry, which is drawn translucent
  std::vector<std::vector<Vec3>> lines;           // polylines over the model, such as a lasso or a ruler; mm
  std::optional<std::pair<Vec3, double>> circle;  // brush: its centre on the surface and its radius; mm
  // The parts that are shown and picked instead of those of the document; null: the parts of the document. While the
  // tool works, only parts whose DisplayPart::soup is another object are prepared for display again.
  std::shared_ptr<const DisplayModel> replaced;
  std::shared_ptr<const KindPreview> ofKind;  // preview for the kind of document; null: none
  std::optional<ToolLabel> label = {};
};

// A spring and damper that a tool applies to the device tip; mm, N. The servo loop adds the springs of all tools and
// services and passes the sum through the safety chain.
struct DeviceSpring {
  Vec3 target = Vec3::Zero();  // position to which the tip is pulled
  double stiffness = 0.0;      // N/mm at the device
  double damping = 0.0;        // N·s/mm at the device
  // Orientation to which the tip is turned, on devices with motors for torque.
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  double turning = 0.0;  // N·mm/rad at the device
};

// The features that attract the device tip while nothing is grabbed. They are easy to hit and select by the device.
struct SnapTargets {
  bool borderPoints = false;  // points of open edges
  bool borderEdges = false;   // open edges
  bool corners = false;       // ends of the edges at which the surface bends or ends
  bool edges = false;         // the edges at which the surface bends or ends
  bool faces = false;         // the surface, which attracts the tip from above

  // Returns true if features are everywhere on the surface, so that only those near the tip can be considered.
  bool areEverywhere() const { return corners || edges || faces; }
  bool operator==(const SnapTargets&) const = default;
};

// Base class of interactive tools. It does not depend on the window. From press to release a tool receives events,
// shows a preview, and commits one edit to its document or reverts. It must be used on the window thread. Tests send
// the same events.
class Tool {
 public:
  virtual ~Tool() = default;

  virtual std::string id() const = 0;  // "select"
  // Returns the name of the tool in recordings of a device, with its mode: "turn bore".
  virtual std::string recordedName() const { return id(); }
  virtual ToolReply pointer(const PointerEvent& event) = 0;
  // Executes one of the actions, requested by key, button or menu. "commit" and "revert" are common to all tools.
  virtual ToolReply perform(std::string_view action) = 0;
  virtual std::vector<ToolAction> actions() const = 0;
  // Undoes the unfinished work of the tool. The command undo calls this function first while the tool runs. Returns
  // Used if the tool has reverted work, and Ignored if the last step of the document, perhaps made by the tool, is to
  // be undone.
  virtual ToolReply undo() { return isLive() ? perform("revert") : ToolReply::Ignored; }

  virtual ToolPreview preview() const { return {}; }
  // Returns true if the preview changes by itself, like that of a running simulation. Such a preview is shown with each
  // frame, and not only after an input.
  virtual bool isLive() const { return false; }
  // Returns true if work that continued after an input is done. resume() is called in this case while the tool is live.
  virtual bool isDue() const { return false; }
  virtual ToolReply resume() { return ToolReply::Ignored; }
  virtual std::vector<Property> settings() const { return {}; }
  virtual void setSetting(std::string_view id, const PropertyValue& value) {
    (void)id;
    (void)value;
  }
  // Returns true if settings chosen by the user are used when the tool is started again, for any document. Returns
  // false for a tool whose settings describe the next edit, or are kept by the owner of its services.
  virtual bool remembersSettings() const { return true; }
  // Returns true if a remembered setting is valid for the present document only, such as a plane of symmetry of its
  // part.
  virtual bool isOfDocument(std::string_view setting) const {
    (void)setting;
    return false;
  }
  virtual std::vector<DeviceSpring> forces() const { return {}; }
  virtual SnapTargets snapTargets() const { return {}; }

  // Ends the unfinished work of the tool. It is called before the tool ends, and before its document is saved, handed
  // in or closed. A tool whose work takes effect immediately commits it; other tools drop theirs, as it is only a
  // proposal.
  virtual void settle() {}

  // Discards the unfinished work of the tool. It is called after the document has changed.
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
