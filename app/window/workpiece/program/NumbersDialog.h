// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

namespace handwheel {

class NumberField;

// A dialog that asks for some numbers. The window stays usable while the dialog is open. The dialog is deleted when it
// is closed.
class NumbersDialog : public QDialog {
  Q_OBJECT

 public:
  struct Number {
    const char* name;  // name of its field, for tests
    QString label;
    QString unit;  // "mm", "r/min"
    double value, least, largest;
    QString tip = {};
  };
  // button: the text of the button that accepts the numbers.
  NumbersDialog(const QString& title, const QString& intro, const QString& button, std::vector<Number> numbers,
                QWidget* parent);

 signals:
  void chosen(const std::vector<double>& values);  // values in the order of the numbers, all within their limits

 private:
  std::vector<NumberField*> m_fields;
};

}  // namespace handwheel
