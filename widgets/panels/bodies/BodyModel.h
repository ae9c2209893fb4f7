// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodySet.h"

#include <QAbstractTableModel>

namespace handwheel {

// The bodies of a document as rows, in the order in which they were added. A change of the document costs a comparison
// of pointers for each body.
class BodyModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Link, Eye, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  void setBodies(const BodySet& bodies);
  BodyPointer body(const QModelIndex& index) const;  // null for an invalid index
  QModelIndex indexOf(BodyId id) const;              // of the name; invalid when there is none; O(log n)

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;  // asks for a new name

 signals:
  void renameRequested(handwheel::BodyId body, const QString& name);

 private:
  QVariant nameData(const Body& body, int role) const;
  QVariant linkData(const Body& body, int role) const;
  QVariant eyeData(const Body& body, int role) const;

  std::vector<BodyPointer> m_bodies;
};

}  // namespace handwheel
