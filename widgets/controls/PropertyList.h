// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>
#include <vector>

#include "document/Property.h"

class QLabel;
class QVBoxLayout;

namespace handwheel {

class PropertyRow;

// A form for the properties of a document or the settings of a tool. Showing the same ids again changes the values
// only: a row keeps the focus, a text half typed and a slider being dragged.
class PropertyList : public QScrollArea {
  Q_OBJECT

 public:
  explicit PropertyList(QWidget* parent = nullptr);
  ~PropertyList() override;

  // In groups as they come; with ids that are all different.
  void setProperties(const std::vector<Property>& properties);
  void setLengthUnit(LengthUnit unit);
  void setEmptyText(const QString& text);  // what stands there without properties

  QSize sizeHint() const override;

 signals:
  void edited(const std::string& id, const handwheel::PropertyValue& value, bool stillDragging);

 private:
  bool fit(const std::vector<Property>& properties) const;
  void rebuild();
  void chainTab();
  PropertyRow* addRow(const Property& property);
  void addHeading(const std::string& group);

  QWidget* m_page;
  QVBoxLayout* m_column;
  QLabel* m_empty;
  std::vector<PropertyRow*> m_rows;
  std::vector<QLabel*> m_headings;
  std::vector<Property> m_properties;
  LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace handwheel
