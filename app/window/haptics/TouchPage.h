// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/PropertyList.h"

#include <QAction>

namespace handwheel {

class HapticSession;

// The page of the device's panel that says how what is touched feels, and the command that switches snapping. Joined to
// the session, which keeps it; there with or without a device.
class TouchPage : public PropertyList {
  Q_OBJECT

 public:
  explicit TouchPage(HapticSession& session, QWidget* parent = nullptr);  // the session outlives it

 private:
  void showTouch();

  HapticSession& m_session;
  QAction m_snap;
};

}  // namespace handwheel
