// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>
#include <map>
#include <vector>

#include "document/Property.h"

class QLabel;
class QVBoxLayout;

namespace handwheel {

class PropertyRow;

// A form for the properties of a document or the settings of a tool. Showing the same ids again only updates the
// values: a row keeps the focus, an unfinished text and a slider being dragged.
class PropertyList : public QScrollArea {
  Q_OBJECT

 public:
  explicit PropertyList(QWidget* parent = nullptr);
  ~PropertyList() override;

  // Shows the properties, grouped in the given order. Ids must be unique.
  void setProperties(const std::vector<Property>& properties);
  // Sets the groups whose fields can be folded below their heading, and whether they are open at first. A group with an
  // unchanged entry stays as the user left it. To be called before setProperties().
  void setFolding(const std::map<std::string, bool>& open);
  void setLengthUnit(LengthUnit unit);
  // Shows at its field why the document has not taken a value. Nothing happens if it is not shown any more.
  void refuse(const std::string& id, const PropertyValue& entered, const QString& reason);
  void setEmptyText(const QString& text);  // shown when there are no properties
  // Shows remarks on values in an area reserved below the form, instead of below their field: no field moves when one
  // comes or goes. To be called before setProperties().
  void reserveRemarkSpace();

  QSize sizeHint() const override;

 signals:
  void edited(const std::string& id, const handwheel::PropertyValue& value, bool stillDragging);
  // emitted for a number before it is entered
  void typed(const std::string& id, const handwheel::PropertyValue& value);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool fit(const std::vector<Property>& properties) const;
  void rebuild();
  void chainTab();
  PropertyRow* addRow(const Property& property);
  void addHeading(const Property& property);  // adds the heading of its group above the property
  QWidget* makeHeading(const std::string& group, const QString& text);
  void foldRows();
  void showRemarks();

  QWidget* m_page;
  QVBoxLayout* m_column;
  QLabel* m_empty;
  QLabel* m_remarks = nullptr;  // null: remarks are shown below their fields
  std::vector<PropertyRow*> m_rows;
  std::vector<QWidget*> m_headings;
  std::map<std::string, bool> m_openAtFirst, m_isOpen;  // by group
  std::vector<Property> m_properties;
  LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace handwheel
