// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace handwheel {

class ProgramEditor;

// The margin of a program, with line numbers, marks and the executed line. A click moves the cursor to the
// clicked line.
class ProgramMargin : public QWidget {
  Q_OBJECT

 public:
  explicit ProgramMargin(ProgramEditor* editor);

  QSize sizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  ProgramEditor* m_editor;
};

}  // namespace handwheel
