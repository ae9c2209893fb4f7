// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace handwheel {

// An event filter that disables window shortcuts in popups and for typed text. Only the menu or list
// of choices receives the keys, and Return, Enter and Esc end the text in a field. Without the filter, Qt would also
// trigger the shortcuts of the window: Return would both accept the choice or the text and fill the selected hole.
class PopupKeys : public QObject {
  Q_OBJECT

 public:
  // Installs the filter on the application for the lifetime of this object.
  explicit PopupKeys(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool keepForPopup(QObject& watched, QEvent& event);

  bool m_isDelivering = false;
};

}  // namespace handwheel
