// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMainWindow;
class QWidget;

namespace handwheel {

// Keeps the keyboard focus in the 3D view while the mouse gives commands. Qt hands the focus of a widget that is hidden
// or disabled to the next in the tab order, where the space bar would press a button that nobody chose. Who goes
// through the window by Tab keeps the focus wherever that leads.
class ViewFocus : public QObject {
  Q_OBJECT

 public:
  // Both outlive this.
  ViewFocus(QMainWindow& window, QWidget& view, QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow(QWidget* old, QWidget* now);
  void takeBack();

  QMainWindow& m_window;
  QWidget& m_view;
};

}  // namespace handwheel
