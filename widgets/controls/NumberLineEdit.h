// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace handwheel {

// Returns the factor by which held modifier keys change a step. Shift multiplies a step by ten, Ctrl divides it by ten.
double stepFactor(Qt::KeyboardModifiers modifiers);
// Returns the rotation of the wheel in notches, positive upwards or to the right. Smooth wheels turn by fractions of a
// notch.
double wheelNotches(const QWheelEvent& event);

// The line edit of a NumberField. Prefix and unit are shown in its margins, so that only the number is edited.
class NumberLineEdit : public QLineEdit {
  Q_OBJECT

 public:
  using QLineEdit::QLineEdit;

  void setMarks(const QString& prefix, const QString& unit);

 signals:
  void stepped(double steps);
  void stepsEnded();
  void committed();
  void reverted();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QFont prefixFont() const;

  QString m_prefix;
  QString m_unit;
};

}  // namespace handwheel
