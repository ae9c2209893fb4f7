// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace handwheel {

// An event filter that disables window shortcuts while a popup is open. Only the menu or list of choices receives the
// keys. Without the filter, Qt would also trigger the shortcuts of the window: Return would both accept the choice and
// fill the selected hole.
class PopupKeys : public QObject {
  Q_OBJECT

 public:
  // Installs the filter on the application for the lifetime of this object.
  explicit PopupKeys(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool m_isDelivering = false;
};

}  // namespace handwheel
