// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/SceneForces.h"
#include "haptics/SnapScene.h"
#include "tools/Tool.h"

#include <QObject>

namespace handwheel {

class HapticSession;

// What the device of a session feels: the surface of the model in view, what draws the tip, and what the tool in use
// pulls with. Handed to the servo loop whole with each change; nothing is kept or handed over while no device is open.
// Window thread.
class TouchScene : public QObject {
  Q_OBJECT

 public:
  explicit TouchScene(HapticSession& session, QObject* parent = nullptr);

  // isEdit: the same surface after an edit, which may be felt at once. Else the force comes back by the ramp.
  void setSurface(std::optional<ContactSurface> surface, bool isEdit);
  // What draws the tip within `distance` (mm in the scene), as long as nothing is held. isEdit: as above.
  void setSnap(std::optional<SnapField> field, double distance, bool isEdit);
  void setHolding(bool isHolding);
  // Springs of the tool; stiffnesses as they are felt at the device.
  void setSprings(const std::vector<ForceTerm>& terms);

  // Tolerance of the contact and number of features that pull at once: proxy.tolerance and snap.features.
  void setFidelity(const FidelityValues& values);

 private:
  void publish(bool mayLeap);

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
