// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/defects/DefectList.h"

#include <QAbstractItemModel>
#include <QPointer>
#include <set>

namespace handwheel {

// A tree model of the defects of a document. It has one group for each kind and one row for each defect. Rows are
// created when they are shown, so hundreds of thousands of defects cost nothing.
class DefectModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Role {
    KindRole = Qt::UserRole,  // int of DefectKind
    LoopRole,                 // loop id for a row of a hole or kept-open loop, else -1
    DetailRole,               // secondary text at the right
    BriefRole,                // the most important part of the secondary text, for narrow rows
    CountRole,                // count of a group; -1 while still searching
    BeforeRole,               // the count of a group before the last repair; -1 when there is nothing to compare
    NoteRole,                 // the reason why the defect of a row remains after a repair or fix
    ShownRole,                // the marks of a group are drawn in the viewport
  };

  using QAbstractItemModel::QAbstractItemModel;

  void setDefectList(const DefectList* defectList);
  const DefectList* defectList() const { return m_defectList; }

  QModelIndex groupIndex(DefectKind kind) const;
  QModelIndex loopIndex(int loop) const;  // index of the row of a loop; invalid if there is none
  bool isShown(DefectKind kind) const { return !m_hidden.contains(kind); }
  void setShown(DefectKind kind, bool shown);

  // Returns an explanation of a kind, with the number of affected triangles of the mesh if this is relevant.
  QString hint(DefectKind kind) const;
  // Returns the bounding box of a row's defect and a direction from which the defect is visible, to move the camera.
  std::pair<Box, Vec3> viewTargetOf(const QModelIndex& index) const;
  // Returns the faces of a row's defect. The result is empty if the defect is a loop, an edge or a vertex, and for an
  // invalid index.
  std::vector<Face> facesOf(const QModelIndex& index) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 signals:
  void shownChanged();

 private:
  QVariant groupData(DefectKind kind, int role) const;
  QVariant rowData(DefectKind kind, int row, int role) const;
  QString rowName(DefectKind kind, int row) const;
  QString rowDetail(DefectKind kind, int row) const;
  QString noteOf(DefectKind kind, int row) const;
  int loopOf(DefectKind kind, int row) const;
  std::vector<Face> facesOf(DefectKind kind, int row) const;
  std::vector<Vertex> verticesOf(DefectKind kind, int row) const;

  QPointer<const DefectList> m_defectList;
  std::set<DefectKind> m_hidden = {DefectKind::Flipped};  // kinds whose marks are not drawn in the viewport
};

}  // namespace handwheel
