// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/mapping/WorkspaceMapping.h"
#include "haptics/scene/MeshHaptics.h"
#include "tools/Tool.h"
#include "window/haptics/TouchSettings.h"

#include <QJsonObject>
#include <QObject>
#include <functional>

namespace handwheel {

class HapticSession;

// The context in which force sources are made when the scene is published.
struct TouchContext {
  const WorkspaceMapping& mapping;  // mapping from the device to the scene; stiffnesses are given at the device
  const TouchSettings& touch;
  ContactOptions contact;         // options with the chosen tolerance and friction
  std::size_t snapFeatures;       // number of features that may attract at once
  Vec3 comesFrom = Vec3::Zero();  // direction towards the viewer, from which the tip approaches
};

// Builds the haptic scene from the force sources of kinds of documents and tools. With each change the whole scene is
// passed to the servo loop; nothing is passed while no device is open. Must be used on the window thread.
class HapticSceneBuilder : public QObject {
  Q_OBJECT

 public:
  explicit HapticSceneBuilder(HapticSession& session, QObject* parent = nullptr);

  // A function that creates a source for the present view and settings. It is called again whenever these change, and
  // returns null if the source exerts no force at present.
  using MakeSource = std::function<std::unique_ptr<ForceSource>(const TouchContext&)>;
  // Adds a source to the scene or replaces the source with the same id. make: null: removes the source. isEdit: the
  // source belongs to the same object after an edit, so it takes effect at once; otherwise the force ramps up.
  void setSource(const std::string& id, MakeSource make, bool isEdit);

  // A function that describes the contents of a source for a recording of the device. It is called whenever the scene
  // changes during a recording.
  using Describe = std::function<QJsonObject()>;

  // Sets the contact surface, the source kSurfaceSource. describe: the function that describes the object with this
  // surface; may be null.
  void setSurface(std::optional<ContactSurface> surface, bool isEdit, Describe describe = {});
  // Sets the snap field, the source kSnapSource. It attracts the tip within `distance` (mm in the scene) unless
  // something is held or snapping is switched off.
  void setSnap(std::optional<SnapField> field, double distance, bool isEdit);
  void setHolding(bool isHolding);
  // Sets the springs of the tool, the source kSpringSource; stiffnesses are given at the device.
  void setSprings(const std::vector<DeviceSpring>& terms);

  // Sets the contact tolerance (proxy.tolerance) and the number of features that attract at once (snap.features).
  void setFidelity(const FidelityValues& values);

 private:
  void publish(bool isDiscontinuous);
  bool has(const std::string& id) const;
  std::string noteOf(const TouchContext& context, const ForceSources& sources) const;

  HapticSession& m_session;
  std::vector<std::pair<std::string, MakeSource>> m_sources;
  Describe m_describeSurface;
  bool m_isHolding = false;
  ContactOptions m_contact;
  std::size_t m_snapFeatures = SnapSum::kMost;
  std::vector<DeviceSpring> m_terms;
};

}  // namespace handwheel
