// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBasicTimer>
#include <QObject>
#include <QPointer>
#include <deque>

class QApplication;
class QWidget;

namespace handwheel {

// Updates the widgets after a change of the application's palette. The style sheet refers to roles of the palette. Qt
// resolves a role once for each widget and caches the result, so the widgets must be updated. Setting the style sheet
// again would cost three times as much, because it also processes hidden panels, menus and closed cards, and repeats
// all layouts. This class updates the visible widgets at once, so that no frame shows a mixture of themes, and each
// hidden widget when it is shown or the application is idle. Must be used on the window thread.
class Restyling : public QObject {
  Q_OBJECT

 public:
  // Starts the update. An update that is not finished is started again. The object that performs the update is owned by
  // the application.
  static void restyle(QApplication& application);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void timerEvent(QTimerEvent* event) override;

 private:
  explicit Restyling(QApplication& application);
  void start();

  QApplication& m_application;
  std::deque<QPointer<QWidget>> m_hidden;  // widgets that still have the colours of the previous palette
  QBasicTimer m_idle;
};

}  // namespace handwheel
