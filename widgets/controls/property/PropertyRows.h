// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/property/PropertyRow.h"

#include <QColor>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QMenu;
class QPlainTextEdit;
class QSlider;
class QToolButton;

namespace handwheel {

class NumberField;

// A row for a number, with an optional slider below. The slider is shown if the property requests it, between the
// limits of its range.
class NumberRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit NumberRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  void slide(int position);
  void showNearness(double share);

  NumberField* m_field;
  QWidget* m_travel;  // contains the slider between its limits
  QSlider* m_slider;
  QLabel* m_lower;
  QLabel* m_upper;
  bool m_slid = false;  // the slider has been moved since it was pressed
  double m_least = 0.0;
  double m_largest = 0.0;
};

// A row for a yes-or-no property: a check box.
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

// A row for a text property: a line edit.
class TextRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit TextRow(QWidget* parent);

 protected:
  // Creates a row with another widget beside the line edit.
  TextRow(QWidget* parent, QWidget* beside);
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;
  bool keep(const PropertyValue& entered) override;
  bool eventFilter(QObject* watched, QEvent* event) override;  // Esc restores the value

 private:
  QString shown(const QString& value) const;

  QLineEdit* m_line;
  QString m_value;           // displayed text
  bool m_isNumbers = false;  // the text consists of numbers, which are shown with the user's decimal separator
};

// A row for a text that may be chosen from a list: a line edit, and a button that opens the list.
class SuggestedTextRow : public TextRow {
  Q_OBJECT

 public:
  explicit SuggestedTextRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  SuggestedTextRow(QWidget* parent, QToolButton* button);

  QToolButton* m_button;
  QMenu* m_list;
  QStringList m_texts;
};

// A row for a text of several lines, below its label. It is entered when the field is left, or by Ctrl+Return.
class LongTextRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit LongTextRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;
  bool keep(const PropertyValue& entered) override;
  bool eventFilter(QObject* watched, QEvent* event) override;  // Esc restores the value

 private:
  void take();
  void restore();

  QLabel* m_heading;
  QPlainTextEdit* m_field;
  QString m_value;
};

// A row for a colour, "#rrggbb": a line edit, and a button that opens the colour dialog.
class ColourRow : public TextRow {
  Q_OBJECT

 public:
  explicit ColourRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  ColourRow(QWidget* parent, QToolButton* button);
  void choose();

  QToolButton* m_button;
  QColor m_colour;
};

// A row for one of several choices: a combo box.
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

// A row for one of several choices that are all visible: a list, below the heading of the group.
class ListRow : public PropertyRow {
  Q_OBJECT

 public:
  explicit ListRow(QWidget* parent);

 protected:
  void showValue(const Property& property, LengthUnit unit) override;
  void setLabel(const QString& label) override;

 private:
  QListWidget* m_list;
};

// A row for a property that cannot be edited: a label.
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
