// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/DefectModel.h"

#include "panels/defects/DefectWords.h"
#include "text/RepairText.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QLocale>

namespace handwheel {

namespace {

DefectKind kindOfRow(const QModelIndex& index) {
  return static_cast<DefectKind>(index.internalId() - 1);
}

// Returns the outward normal of a face, not normalised.
Vec3 normalOf(const HalfEdgeMesh& mesh, Face f) {
  const Triangle& t = mesh.triangle(f);
  const Vec3& a = mesh.position(t[0]);
  return (mesh.position(t[1]) - a).cross(mesh.position(t[2]) - a);
}

}  // namespace

void DefectModel::setDefectList(const DefectList* defectList) {
  if (m_defectList) m_defectList->disconnect(this);
  beginResetModel();
  m_defectList = defectList;
  endResetModel();
  if (!m_defectList) return;
  connect(m_defectList, &DefectList::changed, this, [this] {
    beginResetModel();
    endResetModel();
  });
  connect(m_defectList, &DefectList::reasonsChanged, this, [this](DefectKind kind) {
    const QModelIndex group = groupIndex(kind);
    if (const int rows = rowCount(group); rows > 0)
      emit dataChanged(index(0, 0, group), index(rows - 1, 0, group), {NoteRole, Qt::ToolTipRole});
  });
}

QModelIndex DefectModel::groupIndex(DefectKind kind) const {
  return index(static_cast<int>(kind), 0);
}

QModelIndex DefectModel::loopIndex(int loop) const {
  if (!m_defectList || loop < 0) return {};
  for (DefectKind kind : {DefectKind::Hole, DefectKind::KeptOpen}) {
    const auto& ids = kind == DefectKind::Hole ? m_defectList->holes() : m_defectList->keptOpen();
    const auto found = std::lower_bound(ids.begin(), ids.end(), loop);  // ids ascend
    if (found != ids.end() && *found == loop) return index(static_cast<int>(found - ids.begin()), 0, groupIndex(kind));
  }
  return {};
}

void DefectModel::setShown(DefectKind kind, bool shown) {
  if (isShown(kind) == shown) return;
  if (shown) {
    m_hidden.erase(kind);
  } else {
    m_hidden.insert(kind);
  }
  const QModelIndex group = groupIndex(kind);
  emit dataChanged(group, group);
  emit shownChanged();
}

QModelIndex DefectModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row() + 1) : quintptr{0});
}

QModelIndex DefectModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == 0) return {};
  return createIndex(static_cast<int>(child.internalId()) - 1, 0, quintptr{0});
}

int DefectModel::rowCount(const QModelIndex& parent) const {
  if (!m_defectList) return 0;
  if (!parent.isValid()) return kDefectKinds;
  if (parent.internalId() != 0) return 0;
  return static_cast<int>(m_defectList->count(static_cast<DefectKind>(parent.row())));
}

int DefectModel::columnCount(const QModelIndex&) const {
  return 1;
}

QVariant DefectModel::data(const QModelIndex& index, int role) const {
  if (!m_defectList || !index.isValid()) return {};
  if (index.internalId() == 0) return groupData(static_cast<DefectKind>(index.row()), role);
  return rowData(kindOfRow(index), index.row(), role);
}

QString DefectModel::hint(DefectKind kind) const {
  const QString hint = defectKindHint(kind);
  if (kind != DefectKind::Debris || m_defectList->debris().empty()) return hint;
  std::size_t faces = 0;
  for (const std::size_t i : m_defectList->debris())
    faces += m_defectList->document().defects().components[i].faceCount;
  const double share =
      static_cast<double>(faces) / static_cast<double>(m_defectList->document().mesh().liveFaceCount());
  return hint + QLatin1Char(' ') +
         tr("Here that is %Ln triangle(s), %1 % of all.", nullptr, static_cast<int>(faces))
             .arg(QLocale().toString(100.0 * share, 'g', 2));
}

QVariant DefectModel::groupData(DefectKind kind, int role) const {
  const bool searching = kind == DefectKind::SelfIntersection && !m_defectList->selfIntersections();
  const int count = searching ? -1 : static_cast<int>(m_defectList->count(kind));
  switch (role) {
    case Qt::DisplayRole:
      return defectKindName(kind);
    case Qt::ToolTipRole: {
      const QStringList outcomes = isLoopKind(kind) ? outcomeTexts(m_defectList->loopOutcomes()) : QStringList();
      QStringList lines{hint(kind)};
      if (!outcomes.isEmpty()) lines << tr("Last repair: %1.").arg(outcomes.join(QStringLiteral(", ")));
      if (kind == DefectKind::Hole) lines << m_defectList->patchWarnings();
      return lines.join(QLatin1Char('\n'));
    }
    case Qt::AccessibleTextRole: {
      if (searching) return tr("%1: searching").arg(defectKindName(kind));
      const auto before = m_defectList->countBefore(kind);
      return before ? tr("%1: %2, before the repair %3").arg(defectKindName(kind)).arg(count).arg(*before)
                    : tr("%1: %2").arg(defectKindName(kind)).arg(count);
    }
    case Qt::DecorationRole:
      if (kind == DefectKind::Hole && !m_defectList->patchWarnings().isEmpty())
        return icon(QStringLiteral("warning"), themeColours(currentTheme()).warning);
      return icon(defectIconName(kind), defectColour(kind));
    case KindRole:
      return static_cast<int>(kind);
    case LoopRole:
      return -1;
    case CountRole:
      return count;
    case BeforeRole: {
      const auto before = m_defectList->countBefore(kind);
      return before ? static_cast<int>(*before) : -1;
    }
    case ShownRole:
      return isShown(kind);
    default:
      return {};
  }
}

QVariant DefectModel::rowData(DefectKind kind, int row, int role) const {
  const int loop = loopOf(kind, row);
  switch (role) {
    case Qt::DisplayRole:
      return rowName(kind, row);
    case DetailRole:
      return rowDetail(kind, row);
    case BriefRole:
      return loop >= 0 ? m_defectList->loopLength(loop) : rowDetail(kind, row);
    case Qt::AccessibleTextRole: {
      const QString name = loop >= 0 ? m_defectList->loopTitle(loop) : rowName(kind, row);
      const QString reason = noteOf(kind, row);
      return reason.isEmpty() ? name : tr("%1; remains: %2").arg(name, reason);
    }
    case KindRole:
      return static_cast<int>(kind);
    case LoopRole:
      return loop;
    case NoteRole:
      return noteOf(kind, row);
    case Qt::ToolTipRole: {
      const QString reason = noteOf(kind, row);
      if (loop < 0) return reason.isEmpty() ? QVariant() : tr("Remains: %1.").arg(reason);
      const QString measures = m_defectList->loopMeasures(loop);
      return reason.isEmpty() ? measures : tr("Stayed open: %1.").arg(reason) + QLatin1Char('\n') + measures;
    }
    default:
      return {};
  }
}

QString DefectModel::noteOf(DefectKind kind, int row) const {
  const int loop = loopOf(kind, row);
  return loop >= 0 ? fillFailureReason(m_defectList->failure(loop)) : m_defectList->reason(kind, row);
}

int DefectModel::loopOf(DefectKind kind, int row) const {
  if (kind == DefectKind::Hole) return m_defectList->holes()[static_cast<std::size_t>(row)];
  if (kind == DefectKind::KeptOpen) return m_defectList->keptOpen()[static_cast<std::size_t>(row)];
  return -1;
}

QString DefectModel::rowName(DefectKind kind, int row) const {
  switch (kind) {
    case DefectKind::Hole:
    case DefectKind::KeptOpen:
      return m_defectList->loopName(loopOf(kind, row));
    case DefectKind::NonManifoldEdge:
    case DefectKind::OneSided:
      return tr("Edge %1").arg(row + 1);
    case DefectKind::NonManifoldVertex:
      return tr("Vertex %1").arg(row + 1);
    case DefectKind::NearVertex:
    case DefectKind::SelfIntersection:
      return tr("Pair %1").arg(row + 1);
    case DefectKind::Inconsistent:
    case DefectKind::Flipped:
    case DefectKind::Degenerate:
    case DefectKind::Duplicate:
      return tr("Triangle %1").arg(row + 1);
    case DefectKind::InsideOut:
      return tr("Body %1").arg(row + 1);
    case DefectKind::Debris:
      return tr("Piece %1").arg(row + 1);
  }
  return {};
}

QString DefectModel::rowDetail(DefectKind kind, int row) const {
  if (const int loop = loopOf(kind, row); loop >= 0) return m_defectList->loopDetail(loop);
  const HalfEdgeMesh& mesh = m_defectList->document().mesh();
  if (kind == DefectKind::NonManifoldEdge || kind == DefectKind::OneSided) {
    const std::vector<Vertex> ends = verticesOf(kind, row);
    return lengthText((mesh.position(ends[0]) - mesh.position(ends[1])).norm(), m_defectList->document().displayUnit());
  }
  if (kind == DefectKind::Debris || kind == DefectKind::InsideOut)
    return tr("%Ln triangle(s)", nullptr, static_cast<int>(facesOf(kind, row).size()));
  return {};
}

std::vector<Face> DefectModel::facesOf(DefectKind kind, int row) const {
  const auto i = static_cast<std::size_t>(row);
  const Defects& defects = m_defectList->document().defects();
  switch (kind) {
    case DefectKind::Flipped:
      return {m_defectList->document().reversedFaces()[i]};
    case DefectKind::InsideOut:
      return defects.insideOut[i];
    case DefectKind::Inconsistent:
      return {defects.inconsistentFaces[i]};
    case DefectKind::Degenerate:
      return {defects.degenerateFaces[i]};
    case DefectKind::Duplicate:
      return {defects.duplicateFaces[i]};
    case DefectKind::SelfIntersection: {
      const auto& pair = (*m_defectList->selfIntersections())[i];
      return {pair.first, pair.second};
    }
    case DefectKind::Debris:
      return defects.components[m_defectList->debris()[i]].faces;
    default:
      return {};
  }
}

std::vector<Face> DefectModel::facesOf(const QModelIndex& index) const {
  if (!m_defectList || !index.isValid() || index.internalId() == 0) return {};
  return facesOf(kindOfRow(index), index.row());
}

std::vector<Vertex> DefectModel::verticesOf(DefectKind kind, int row) const {
  const auto i = static_cast<std::size_t>(row);
  const Defects& defects = m_defectList->document().defects();
  if (kind == DefectKind::NonManifoldVertex) return {defects.nonManifoldVertices[i]};
  const auto ends = [](const auto& pair) { return std::vector<Vertex>{pair.first, pair.second}; };
  if (kind == DefectKind::NearVertex) return ends(defects.nearVertices[i]);
  if (kind == DefectKind::OneSided) return ends(defects.nonOrientableEdges[i]);
  if (kind == DefectKind::NonManifoldEdge) return ends(defects.nonManifoldEdges[i]);
  return {};
}

std::pair<Box, Vec3> DefectModel::viewTargetOf(const QModelIndex& index) const {
  Box box;
  Vec3 outward = Vec3::Zero();
  if (!m_defectList || !index.isValid() || index.internalId() == 0) return {box, outward};
  const HalfEdgeMesh& mesh = m_defectList->document().mesh();
  const DefectKind kind = kindOfRow(index);
  if (const int loop = loopOf(kind, index.row()); loop >= 0) {
    for (HalfEdge h : m_defectList->loop(loop).halfEdges) outward += normalOf(mesh, HalfEdgeMesh::face(h));
    return {m_defectList->loop(loop).box, outward};
  }
  for (Face f : facesOf(kind, index.row())) {
    for (Vertex v : mesh.triangle(f)) box.extend(mesh.position(v));
    outward += normalOf(mesh, f);
  }
  for (Vertex v : verticesOf(kind, index.row())) box.extend(mesh.position(v));
  return {box, outward};
}

}  // namespace handwheel
