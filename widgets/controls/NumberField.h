// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include "base/Expression.h"

class QLabel;

namespace handwheel {

class NumberLineEdit;

// An input field for a number with a unit. It accepts expressions ("25.4/2", "1 in + 2mm"). The arrow keys, and the
// mouse wheel if the field has the focus, change the value by a step (Shift: ten steps, Ctrl: a tenth). Invalid input
// stays in the field, with the reason below it, until it is corrected or Esc restores the value. Values are in mm and
// radian, independent of the displayed unit.
class NumberField : public QWidget {
  Q_OBJECT

 public:
  explicit NumberField(QWidget* parent = nullptr);
  ~NumberField() override;

  void setQuantity(Quantity quantity, LengthUnit unit);
  void setRange(double least, double largest);  // no range when least > largest
  void setPrefix(const QString& prefix);        // text before the number: "⌀", "R"
  void setLabel(const QString& label);          // accessible name
  void setStep(double step) { m_step = step; }  // 0: depends on the magnitude of the value
  // Shows the reason for invalid input over what is below the field, so that nothing moves away from the mouse.
  void setProblemOver();
  // Sets the value, but does not replace a text that is being edited.
  void setValue(double value);

  double value() const { return m_value; }
  QString problem() const;  // reason why the text is invalid; empty: it is valid

 signals:
  // Emitted for each change by the user. During a run of steps stillDragging is true; at its end the last value is
  // emitted once more with false.
  void valueEdited(double value, bool stillDragging);
  // Emitted while the user is typing, whenever the text is a valid value.
  void valueTyped(double value);

 protected:
  void changeEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void showMarks();
  void showValue();
  void describe();
  void commit();
  void type();
  void revert();
  void step(double steps);
  void endSteps();
  double oneStep() const;
  QString text() const;
  QString rangeProblem(double value) const;
  void showProblem(const QString& problem);
  void placeProblem();

  NumberLineEdit* m_line;
  QPointer<QLabel> m_problem;  // over other widgets it belongs to the window
  bool m_isProblemOver = false;
  QTimer m_pause;  // ends a run of steps
  bool m_stepping = false;
  Quantity m_quantity = Quantity::Number;
  LengthUnit m_unit = LengthUnit::Millimetre;
  QString m_prefix;
  double m_least;
  double m_largest;
  double m_step = 0.0;
  double m_value = 0.0;
};

}  // namespace handwheel
