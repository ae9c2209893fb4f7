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
  // Groups whose fields can be folded away below their heading, and whether they are open at first. Of a group for
  // which that has not changed it stays as a person left it. To be called before setProperties().
  void setFolding(const std::map<std::string, bool>& open);
  void setLengthUnit(LengthUnit unit);
  // Says at its field why the document has not taken a value. Nothing happens when it is not shown any more.
  void refuse(const std::string& id, const PropertyValue& entered, const QString& reason);
  void setEmptyText(const QString& text);  // shown when there are no properties
  // Remarks on values stand in a place below the form that is kept for them, else below their field: no field moves
  // when one comes or goes. To be called before setProperties().
  void keepPlaceForRemarks();

  QSize sizeHint() const override;

 signals:
  void edited(const std::string& id, const handwheel::PropertyValue& value, bool stillDragging);
  void typed(const std::string& id, const handwheel::PropertyValue& value);  // a number, before it is entered

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool fit(const std::vector<Property>& properties) const;
  void rebuild();
  void chainTab();
  PropertyRow* addRow(const Property& property);
  void addHeading(const Property& property);  // above it: its group
  QWidget* makeHeading(const std::string& group, const QString& text);
  void foldRows();
  void showRemarks();

  QWidget* m_page;
  QVBoxLayout* m_column;
  QLabel* m_empty;
  QLabel* m_remarks = nullptr;  // null: they stand below their fields
  std::vector<PropertyRow*> m_rows;
  std::vector<QWidget*> m_headings;
  std::map<std::string, bool> m_openAtFirst, m_isOpen;  // by the group
  std::vector<Property> m_properties;
  LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace handwheel
