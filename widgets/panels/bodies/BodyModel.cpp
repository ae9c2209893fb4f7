// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/bodies/BodyModel.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <algorithm>

namespace handwheel {

namespace {

bool isSameBody(const BodyPointer& a, const BodyPointer& b) {
  return a->id == b->id;
}

QColor colourOf(const Body& body) {
  const auto level = [&](std::size_t i) { return std::clamp(body.look.colour[i], 0.0f, 1.0f); };
  return QColor::fromRgbF(level(0), level(1), level(2));
}

bool isLinkBroken(const BodyLink& link) {
  return link.state == LinkState::Missing || link.state == LinkState::Changed;
}

}  // namespace

// What stands before and after the change keeps its rows, with selection and place in the view.
void BodyModel::setBodies(const BodySet& bodies) {
  const std::vector<BodyPointer> next(bodies.begin(), bodies.end());
  const auto head = std::mismatch(m_bodies.begin(), m_bodies.end(), next.begin(), next.end(), isSameBody);
  const auto first = head.first - m_bodies.begin();
  const auto tail = std::mismatch(m_bodies.rbegin(), std::make_reverse_iterator(head.first), next.rbegin(),
                                  std::make_reverse_iterator(head.second), isSameBody);
  const auto removed = tail.first.base() - head.first, added = tail.second.base() - head.second;
  if (removed > 0) {
    beginRemoveRows({}, static_cast<int>(first), static_cast<int>(first + removed) - 1);
    m_bodies.erase(m_bodies.begin() + first, m_bodies.begin() + first + removed);
    endRemoveRows();
  }
  if (added > 0) {
    beginInsertRows({}, static_cast<int>(first), static_cast<int>(first + added) - 1);
    m_bodies.insert(m_bodies.begin() + first, next.begin() + first, next.begin() + first + added);
    endInsertRows();
  }
  for (std::size_t row = 0; row < next.size(); ++row) {
    if (m_bodies[row] == next[row]) continue;
    m_bodies[row] = next[row];
    emit dataChanged(index(static_cast<int>(row), 0), index(static_cast<int>(row), ColumnCount - 1));
  }
}

BodyPointer BodyModel::body(const QModelIndex& index) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return nullptr;
  return m_bodies[static_cast<std::size_t>(index.row())];
}

QModelIndex BodyModel::indexOf(BodyId id) const {
  const auto found = std::lower_bound(m_bodies.begin(), m_bodies.end(), id,
                                      [](const BodyPointer& body, BodyId wanted) { return body->id < wanted; });
  if (found == m_bodies.end() || (*found)->id != id) return {};
  return index(static_cast<int>(found - m_bodies.begin()), Name);
}

int BodyModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_bodies.size());
}

int BodyModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant BodyModel::data(const QModelIndex& index, int role) const {
  const BodyPointer body = this->body(index);
  if (!body) return {};
  switch (index.column()) {
    case Name:
      return nameData(*body, role);
    case Link:
      return linkData(*body, role);
    default:
      return eyeData(*body, role);
  }
}

QVariant BodyModel::nameData(const Body& body, int role) const {
  const QString name = QString::fromStdString(body.name);
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return name;
    case Qt::DecorationRole:
      return colourOf(body);
    case Qt::ForegroundRole:
      return body.visible ? QVariant() : themeColours(currentTheme()).muted;
    case Qt::AccessibleTextRole:
      return body.visible ? name : tr("%1, hidden").arg(name);
    default:
      return {};
  }
}

QVariant BodyModel::linkData(const Body& body, int role) const {
  if (!body.link) return {};
  const QString path = QString::fromStdString(body.link->path);
  switch (role) {
    case Qt::DecorationRole:
      return isLinkBroken(*body.link) ? icon(QStringLiteral("warning")) : icon(QStringLiteral("file"));
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      if (body.link->state == LinkState::Missing) return tr("Linked to %1, which is missing").arg(path);
      if (body.link->state == LinkState::Changed)
        return tr("Linked to %1, which has changed since it was read").arg(path);
      return tr("Linked to %1").arg(path);
    default:
      return {};
  }
}

QVariant BodyModel::eyeData(const Body& body, int role) const {
  switch (role) {
    case Qt::DecorationRole:
      return icon(body.visible ? QStringLiteral("eye") : QStringLiteral("eye-off"));
    case Qt::ToolTipRole:
      return body.visible ? tr("Hide the body") : tr("Show the body");
    case Qt::AccessibleTextRole:
      return body.visible ? tr("Shown") : tr("Hidden");
    default:
      return {};
  }
}

Qt::ItemFlags BodyModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  return index.column() == Name ? usual | Qt::ItemIsEditable : usual;
}

bool BodyModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const BodyPointer body = this->body(index);
  if (!body || index.column() != Name || role != Qt::EditRole) return false;
  if (value.toString() != QString::fromStdString(body->name)) emit renameRequested(body->id, value.toString());
  return true;
}

}  // namespace handwheel
