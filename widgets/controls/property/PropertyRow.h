// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "document/Property.h"

class QLabel;

namespace handwheel {

// One row of a PropertyList: label, editor, and notes on the value.
class PropertyRow : public QWidget {
  Q_OBJECT

 public:
  // Creates the row for a property, showing its value. The class of the row depends on the kind of the property.
  static PropertyRow* make(const Property& property, LengthUnit unit, QWidget* parent);

  const std::string& id() const { return m_id; }
  // Returns true if this row can show the property, because id and kind are the same.
  bool fits(const Property& property) const;
  void showProperty(const Property& property, LengthUnit unit);
  // Shows the reason why the document has refused a value. A refused text stays in the field until it is corrected or
  // Esc restores the former one.
  void refuse(const PropertyValue& entered, const QString& reason);
  // Leaves the display of the remark on the value to the owner of the row, so that the row keeps its height. The row
  // itself only marks its label as invalid.
  void showRemarkOutside();
  // Returns the remark with the label: "Points: they cannot be scored without a limit". The result is empty if there is
  // no remark.
  QString namedRemark() const;
  bool isRefused() const { return !m_refusal.isEmpty(); }

 signals:
  void edited(const PropertyValue& value, bool stillDragging);
  void typed(const PropertyValue& value);  // emitted for a number while it is being typed, before it is entered
  void remarkChanged();

 protected:
  // Stretch factors of label and editor in a line.
  static constexpr int kLabelStretch = 2, kEditorStretch = 3;

  enum class Kind { Number, Switch, Text, LongText, Suggested, Colour, Choice, List, ReadOnly };
  static Kind kindOf(const Property& property);
  static QString translated(const std::string& english);

  explicit PropertyRow(QWidget* parent);
  // Lays out the parts; to be called once. The label is beside the editor, or the editor has the line to itself. below:
  // a widget below the editor; after: a widget at the end of the editor's line.
  void arrange(QWidget* editor, bool besideLabel = true, QWidget* below = nullptr, QWidget* after = nullptr);

  virtual void showValue(const Property& property, LengthUnit unit) = 0;
  virtual void setLabel(const QString& label) = 0;  // accessible name, or the text of an editor that shows it
  // Shows the refused input in the editor again. Returns true if it stays until it is corrected.
  virtual bool keep(const PropertyValue& entered) {
    (void)entered;
    return false;
  }
  void forgetRefusal();
  // Gives a widget the look of an invalid one, or removes it.
  static void markBad(QWidget& widget, bool isBad);

 private:
  const QString& remark() const { return m_refusal.isEmpty() ? m_remark : m_refusal; }
  void showRemark();

  std::string m_id;
  Kind m_kind = Kind::ReadOnly;
  QString m_remark;   // the remark on the value
  QString m_refusal;  // the reason against the value entered last
  bool m_isKept = false;
  bool m_isRemarkOutside = false;
  QLabel* m_label;
  QLabel* m_problem;
};

}  // namespace handwheel
