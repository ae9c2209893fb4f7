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
// resolves a role once for each widget and caches the result, and setting the style sheet again costs three times as
// much: it also processes hidden panels, menus and closed cards, and lays everything out again. Here the visible
// widgets are updated at once, so that no frame shows a mixture of themes; the hidden ones when they are shown, or when
// the application is idle. Window thread.
class Restyling : public QObject {
  Q_OBJECT

 public:
  // Starts the update. The object is owned by the application. Starts over if an earlier update is not finished.
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
