// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/scene/SceneForces.h"
#include "haptics/snap/SnapScene.h"
#include "tools/Tool.h"

#include <QObject>

namespace handwheel {

class HapticSession;

// The haptic scene: the contact surface, the snap forces, and the tool's springs. The surface is that of the model in
// view. Passed to the servo loop as a whole with each change; nothing is stored or passed while no device is open.
// Window thread.
class TouchScene : public QObject {
  Q_OBJECT

 public:
  explicit TouchScene(HapticSession& session, QObject* parent = nullptr);

  // Sets the contact surface. isEdit: the same surface after an edit, which takes effect at once. Otherwise the force
  // ramps up.
  void setSurface(std::optional<ContactSurface> surface, bool isEdit);
  // Sets the snap field, which attracts the tip within `distance` (mm in the scene) unless something is held. isEdit:
  // as above.
  void setSnap(std::optional<SnapField> field, double distance, bool isEdit);
  void setHolding(bool isHolding);
  // Sets the springs of the tool; stiffnesses are those at the device.
  void setSprings(const std::vector<ForceTerm>& terms);

  // Sets the contact tolerance and the number of features that attract at once: proxy.tolerance and snap.features.
  void setFidelity(const FidelityValues& values);

 private:
  void publish(bool isDiscontinuous);

  HapticSession& m_session;
  std::optional<ContactSurface> m_surface;
  std::optional<SnapField> m_snap;
  double m_snapDistance = 0.0;
  bool m_isHolding = false;
  ContactOptions m_contact;
  std::size_t m_mostFeatures = SnapSum::kMost;
  std::vector<ForceTerm> m_terms;
};

}  // namespace handwheel
