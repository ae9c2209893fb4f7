// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "haptics/contact/ContactSurface.h"
#include "window/JobRunner.h"

#include <QJsonObject>
#include <QObject>
#include <map>
#include <memory>

namespace handwheel {

class HapticSceneBuilder;
class HapticSession;
struct WindowContext;

// The contact surface of the displayed parts of a document, in their poses. While a device is open, a job builds the
// contact surface of each shape, once; a part that moves is felt at its new pose at once. The functions must be called
// on the window thread.
class RigidPartsHaptics : public QObject {
  Q_OBJECT

 public:
  explicit RigidPartsHaptics(const WindowContext& window, QObject* parent = nullptr);

  // Sets the parts that are felt; null: none.
  void setParts(std::shared_ptr<const DisplayModel> parts);
  bool isSettled() const { return m_making.isIdle(); }

 private:
  using Shape = std::shared_ptr<const TriangleSoup>;

  void feel();
  void build(std::vector<Shape> shapes);
  void place();
  QJsonObject describe();
  bool isAtHand(const DisplayModel& moved, const DisplayModel& others) const;

  HapticSession& m_session;
  HapticSceneBuilder& m_scene;
  JobRunner m_making;
  std::shared_ptr<const DisplayModel> m_parts;
  std::map<Shape, ContactSurface> m_surfaces;    // Contact surfaces of some or all shapes of m_parts
  std::shared_ptr<const DisplayModel> m_placed;  // The parts that are felt; null: none
  ContactSurface m_felt;                         // Contact surface of m_placed
  bool m_isEdit = false;                         // True if m_felt continues the previous contact surface
  std::shared_ptr<const DisplayModel> m_noted;   // The parts that the present recording contains; null: none
  std::map<Shape, std::string> m_digests;        // Digests of the noted shapes
  bool m_isOpen = false;                         // State of the session at its last signal
};

}  // namespace handwheel
