// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QWidget;

namespace handwheel {

// Keeps keys of a widget from the commands of the window and from the tools. Qt asks the widget with the focus, and
// then its parents, whether they need a key, before it looks for a command with it; many widgets of Qt do not answer.
class OwnKeys : public QObject {
  Q_OBJECT

 public:
  // keys: pressed without modifiers, in the widget or in one inside of it. This object is a child of the widget.
  OwnKeys(QWidget& widget, QList<Qt::Key> keys);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QList<Qt::Key> m_keys;
};

}  // namespace handwheel
