// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodySet.h"

#include <QAbstractItemModel>
#include <QStringList>
#include <set>

namespace handwheel {

// A tree model of the bodies of a document, in the order of their addition. If there are carriers, each has a row after
// the rows of the bodies without a carrier. The bodies that it carries are the children of this row. A change of the
// document costs a comparison of pointers for each body.
class BodyModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { Name, Link, Eye, ColumnCount };

  explicit BodyModel(QObject* parent = nullptr);

  // Sets the bodies to show. carriers: the names of objects that can carry bodies (Body::carrier).
  void setBodies(const BodySet& bodies, const QStringList& carriers = {});
  BodyPointer body(const QModelIndex& index) const;  // null for an invalid index, and for a carrier
  QModelIndex indexOf(BodyId id) const;  // index of the body's name; invalid if there is none; O(carriers · log n)
  QModelIndex indexOfCarrier(const QString& name) const;  // index of the name of a carrier; invalid if there is none

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& index) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;  // emits renameRequested()
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  QStringList mimeTypes() const override { return {m_mimeType}; }
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;  // emits carrierRequested()

 signals:
  void renameRequested(handwheel::BodyId body, const QString& name);
  // Emitted when bodies were dropped. carrier: the carrier that the bodies are to get: the one on which they were
  // dropped, or the carrier of the body on which they were dropped. The name is empty for a body without a carrier and
  // for empty space.
  void carrierRequested(const std::set<handwheel::BodyId>& bodies, const QString& carrier);

 private:
  using Bodies = std::vector<BodyPointer>;

  int standing() const { return static_cast<int>(m_bodies.front().size()); }
  std::size_t groupOf(const QModelIndex& index) const;
  const QString* carrier(const QModelIndex& index) const;
  void setGroup(std::size_t group, const Bodies& next);
  QVariant nameData(const Body& body, int role) const;
  QVariant linkData(const Body& body, int role) const;
  QVariant eyeData(const Body& body, int role) const;

  QStringList m_carriers;
  std::vector<Bodies> m_bodies{1};  // the bodies without a carrier, then those of each carrier
  QString m_mimeType;               // unique to this model, because body numbers are meaningless in other models
};

}  // namespace handwheel
