// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

namespace handwheel {

// An event filter for Esc in the panels, where nothing else uses it. The view has its own (ToolHost::setEscape).
class PanelEscape : public QObject {
  Q_OBJECT

 public:
  // Installs the filter on the application for the lifetime of this object. escape: returns true if it did anything.
  PanelEscape(std::function<bool()> escape, QObject* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::function<bool()> m_escape;
};

}  // namespace handwheel
