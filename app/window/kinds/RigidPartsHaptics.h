// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "window/JobRunner.h"

#include <QObject>
#include <memory>

namespace handwheel {

class HapticSceneBuilder;
class HapticSession;
struct WindowContext;

// The contact surface of the displayed parts of a document, in their poses. Built by a job while a device is open, anew
// with each change. Window thread.
class RigidPartsHaptics : public QObject {
  Q_OBJECT

 public:
  explicit RigidPartsHaptics(const WindowContext& window, QObject* parent = nullptr);

  // Sets the parts that are felt; null for none.
  void setParts(std::shared_ptr<const DisplayModel> parts);
  bool isSettled() const { return m_making.isIdle(); }

 private:
  void rebuild();

  HapticSession& m_session;
  HapticSceneBuilder& m_scene;
  JobRunner m_making;
  std::shared_ptr<const DisplayModel> m_parts;
  bool m_isOpen = false;  // state of the session at its last signal
};

}  // namespace handwheel
