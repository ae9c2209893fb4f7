// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

namespace handwheel {

// A large button: a picture, what it does, and one line more.
class Tile : public QFrame {
  Q_OBJECT

 public:
  Tile(const QString& iconName, const QString& title, const QString& text, QWidget* parent = nullptr);

 signals:
  void clicked();

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace handwheel
