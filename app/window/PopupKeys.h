// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace handwheel {

// While a menu or a list of choices is open, the keys belong to it alone. Qt would ask the shortcuts of the window
// first: Return would take the choice and fill the selected hole as well.
class PopupKeys : public QObject {
  Q_OBJECT

 public:
  // As long as this lives, for the whole application.
  explicit PopupKeys(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool m_isDelivering = false;
};

}  // namespace handwheel
