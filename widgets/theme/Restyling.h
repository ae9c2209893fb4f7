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

// Gives the application's widgets the colours of a new palette under a style sheet that names roles of the palette. Qt
// resolves a role once for each widget and keeps the result, and setting the sheet anew costs three times as much: it
// goes through hidden panels, menus and closed cards too, and lays everything out again. Here the visible widgets
// follow at once, so that no picture shows half of a theme; the hidden ones when they are shown, or when nothing else
// is to be done. Window thread.
class Restyling : public QObject {
  Q_OBJECT

 public:
  // Belongs to the application. Starts over if it is not done with an earlier palette.
  static void restyle(QApplication& application);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void timerEvent(QTimerEvent* event) override;

 private:
  explicit Restyling(QApplication& application);
  void start();

  QApplication& m_application;
  std::deque<QPointer<QWidget>> m_hidden;  // that still have the colours of the palette before
  QBasicTimer m_idle;
};

}  // namespace handwheel
