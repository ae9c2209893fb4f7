// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/property/PropertyList.h"

#include <QAction>

namespace handwheel {

class HapticSession;

// The page of the device panel with the haptic surface properties. It includes the command that switches snapping. It
// is connected to the session, which stores the settings, and available with or without a device.
class TouchPage : public PropertyList {
  Q_OBJECT

 public:
  explicit TouchPage(HapticSession& session, QWidget* parent = nullptr);  // the session must outlive it

 private:
  void showTouch();

  HapticSession& m_session;
  QAction m_snap;
};

}  // namespace handwheel
