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
// values: focus, unfinished texts and sliders being dragged are kept.
class PropertyList : public QScrollArea {
  Q_OBJECT

 public:
  explicit PropertyList(QWidget* parent = nullptr);
  ~PropertyList() override;

  // Shows the properties, grouped in the given order. Ids must be unique.
  void setProperties(const std::vector<Property>& properties);
  // Sets the groups whose fields can be folded below their heading, and whether they are open at first. A group with
  // the same entry as before stays as the user left it. To be called before setProperties().
  void setFolding(const std::map<std::string, bool>& open);
  void setLengthUnit(LengthUnit unit);
  // Shows the reason why the document has refused a value, at the field of the property. Nothing happens if the
  // property is no longer shown.
  void refuse(const std::string& id, const PropertyValue& entered, const QString& reason);
  void setEmptyText(const QString& text);  // shown when there are no properties
  // Shows remarks on values in an area reserved below the form, instead of below their fields, so that no field moves
  // when a remark appears or disappears. To be called before setProperties().
  void reserveRemarkSpace();

  QSize sizeHint() const override;

 signals:
  void edited(const std::string& id, const handwheel::PropertyValue& value, bool stillDragging);
  // emitted for a number while it is being typed, before it is entered
  void typed(const std::string& id, const handwheel::PropertyValue& value);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool fit(const std::vector<Property>& properties) const;
  void rebuild();
  void chainTab();
  PropertyRow* addRow(const Property& property);
  void addHeading(const Property& property);  // adds the heading of the property's group
  QWidget* makeHeading(const std::string& group, const QString& text);
  void foldRows();
  void showRemarks();

  QWidget* m_page;
  QVBoxLayout* m_column;
  QLabel* m_empty;
  QLabel* m_remarks = nullptr;  // null: remarks are shown below their fields
  std::vector<PropertyRow*> m_rows;
  std::vector<QWidget*> m_headings;
  std::map<std::string, bool> m_openAtFirst, m_isOpen;  // keys: groups
  std::vector<Property> m_properties;
  LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace handwheel
