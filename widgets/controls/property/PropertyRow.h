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
  // Creates the row for this kind of property, showing its value.
  static PropertyRow* make(const Property& property, LengthUnit unit, QWidget* parent);

  const std::string& id() const { return m_id; }
  // Whether this row can show the property: same id and kind.
  bool fits(const Property& property) const;
  void showProperty(const Property& property, LengthUnit unit);
  // Says why the document has not taken a value. A text stays in the field, to be corrected, or until Esc restores the
  // former one.
  void refuse(const PropertyValue& entered, const QString& reason);
  // The remark on the value is shown by who shows the row, so that the row is always as high: here, only its label
  // looks bad.
  void showRemarkOutside();
  // "Points: they cannot be scored without a limit"; empty: there is nothing to remark.
  QString namedRemark() const;
  bool isRefused() const { return !m_refusal.isEmpty(); }

 signals:
  void edited(const PropertyValue& value, bool stillDragging);
  void typed(const PropertyValue& value);  // before it is entered
  void remarkChanged();

 protected:
  // How label and editor share the width of a line.
  static constexpr int kLabelStretch = 2, kEditorStretch = 3;

  enum class Kind { Number, Switch, Text, LongText, Colour, Choice, List, ReadOnly };
  static Kind kindOf(const Property& property);
  static QString translated(const std::string& english);

  explicit PropertyRow(QWidget* parent);
  // Lays out the parts; to be called once. The label is beside the editor, or the editor is alone. after: stands at the
  // end of its line.
  void arrange(QWidget* editor, bool besideLabel = true, QWidget* below = nullptr, QWidget* after = nullptr);

  virtual void showValue(const Property& property, LengthUnit unit) = 0;
  virtual void setLabel(const QString& label) = 0;  // for screen readers, or where the editor shows it
  // Puts back what was entered and refused. True: it stays until it is corrected.
  virtual bool keep(const PropertyValue& entered) {
    (void)entered;
    return false;
  }
  void forgetRefusal();
  // Gives a widget the look of what is not as it should be, or takes that back.
  static void markBad(QWidget& widget, bool isBad);

 private:
  const QString& remark() const { return m_refusal.isEmpty() ? m_remark : m_refusal; }
  void showRemark();

  std::string m_id;
  Kind m_kind = Kind::ReadOnly;
  QString m_remark;   // on the value
  QString m_refusal;  // of the value that was entered last
  bool m_isKept = false;
  bool m_isRemarkOutside = false;
  QLabel* m_label;
  QLabel* m_problem;
};

}  // namespace handwheel
