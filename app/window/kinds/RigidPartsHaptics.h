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

// The contact surface of the displayed parts of a document, in their poses. While a device is open a job builds that of
// each shape, once; a part that moves is felt elsewhere at once. Window thread.
class RigidPartsHaptics : public QObject {
  Q_OBJECT

 public:
  explicit RigidPartsHaptics(const WindowContext& window, QObject* parent = nullptr);

  // Sets the parts that are felt; null for none.
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
  std::map<Shape, ContactSurface> m_surfaces;    // of the shapes of m_parts, or fewer
  std::shared_ptr<const DisplayModel> m_placed;  // what is felt; null: nothing
  ContactSurface m_felt;                         // of it
  bool m_isEdit = false;                         // it goes on from the one before
  std::shared_ptr<const DisplayModel> m_noted;   // what the present recording knows of; null: nothing
  std::map<Shape, std::string> m_digests;        // of what was noted
  bool m_isOpen = false;                         // state of the session at its last signal
};

}  // namespace handwheel
