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
  const WorkspaceMapping& mapping;  // mapping for stiffnesses, which are those at the device
  const TouchSettings& touch;
  ContactOptions contact;         // with the chosen tolerance and friction
  std::size_t snapFeatures;       // number of features that may attract at once
  Vec3 comesFrom = Vec3::Zero();  // towards the viewer
};

// Builds the haptic scene from the force sources of kinds of documents and tools. The scene is passed to the servo loop
// as a whole with each change; nothing is passed while no device is open. Window thread.
class HapticSceneBuilder : public QObject {
  Q_OBJECT

 public:
  explicit HapticSceneBuilder(HapticSession& session, QObject* parent = nullptr);

  // Makes a source for the present view and settings; called again whenever these change. Null: nothing now.
  using MakeSource = std::function<std::unique_ptr<ForceSource>(const TouchContext&)>;
  // Adds a source to the scene or replaces the one of the same id; null removes it. isEdit: it is the same object after
  // an edit, which takes effect at once; otherwise the force ramps up.
  void setSource(const std::string& id, MakeSource make, bool isEdit);

  // Describes the contents of a source, for a recording of the device. Called only while a recording runs, whenever the
  // scene changes.
  using Describe = std::function<QJsonObject()>;

  // Sets the contact surface, the source kSurfaceSource. describe: describes the object with this surface; may be null.
  void setSurface(std::optional<ContactSurface> surface, bool isEdit, Describe describe = {});
  // Sets the snap field, the source kSnapSource. It attracts the tip within `distance` (mm in the scene) unless
  // something is held or snapping is switched off.
  void setSnap(std::optional<SnapField> field, double distance, bool isEdit);
  void setHolding(bool isHolding);
  // Sets the springs of the tool, the source kSpringSource; stiffnesses are those at the device.
  void setSprings(const std::vector<DeviceSpring>& terms);

  // Sets the contact tolerance and the number of features that attract at once: proxy.tolerance and snap.features.
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
