// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/PropertyRow.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QSlider;

namespace handwheel {

class NumberField;

// A number; with a slider below when it is best changed between its limits.
class NumberRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit NumberRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  void slide(int position);

  NumberField* m_field;
  QSlider* m_slider;
  bool m_slid = false;  // the slider was moved since it was pressed
  double m_least = 0.0;
  double m_largest = 0.0;
};

class SwitchRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit SwitchRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  QCheckBox* m_box;
};

class TextRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit TextRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  QLineEdit* m_line;
};

class ChoiceRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit ChoiceRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  QComboBox* m_box;
};

class ReadOnlyRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit ReadOnlyRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  QLabel* m_text;
};

}  // namespace handwheel
