// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMainWindow;
class QWidget;

namespace handwheel {

// Keeps the keyboard focus in the 3D view while commands are given by mouse. Qt passes the focus of a widget that is
// hidden or disabled to the next widget in the tab order, where the space bar would press a button that the user did
// not choose. Focus changes by Tab are not affected.
class ViewFocus : public QObject {
  Q_OBJECT

 public:
  // Window and view must outlive this object.
  ViewFocus(QMainWindow& window, QWidget& view, QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow(QWidget* old, QWidget* now);
  void takeBackFrom(const QWidget* holder);

  QMainWindow& m_window;
  QWidget& m_view;
};

}  // namespace handwheel
