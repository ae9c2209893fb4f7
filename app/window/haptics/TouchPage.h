// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/property/PropertyList.h"

#include <QAction>

namespace handwheel {

class HapticSession;

// The page of the device panel with the haptic surface properties. It includes the command that switches snapping. The
// session stores the settings. The page is available even if no device is open.
class TouchPage : public PropertyList {
  Q_OBJECT

 public:
  explicit TouchPage(HapticSession& session, QWidget* parent = nullptr);  // the session must outlive the page

 private:
  void showTouch();

  HapticSession& m_session;
  QAction m_snap;
};

}  // namespace handwheel
