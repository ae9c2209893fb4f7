// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/DevicePanel.h"

#include <QElapsedTimer>

namespace handwheel {

class HapticSession;

// The panel of the devices, joined to the session. While nobody can see it, it asks for nothing and no devices are
// looked for.
class DeviceDock : public DevicePanel {
  Q_OBJECT

 public:
  explicit DeviceDock(HapticSession& session, QWidget* parent = nullptr);  // the session outlives it

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showChosen();
  void showTick();
  void showRun();

  HapticSession& m_session;
  QElapsedTimer m_sinceRun;  // since timings were shown
};

}  // namespace handwheel
