// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/bodies/BodyModel.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QMimeData>
#include <QUuid>
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

BodyModel::BodyModel(QObject* parent)
    : QAbstractItemModel(parent),
      m_mimeType(QStringLiteral("application/x-handwheel-bodies-") + QUuid::createUuid().toString(QUuid::Id128)) {}

void BodyModel::setBodies(const BodySet& bodies, const QStringList& carriers) {
  if (carriers != m_carriers) {
    beginResetModel();
    m_carriers = carriers;
    m_bodies.assign(1 + static_cast<std::size_t>(carriers.size()), {});
    endResetModel();
  }
  std::vector<Bodies> next(m_bodies.size());
  for (const BodyPointer& body : bodies) {
    // -1, for a body without a known carrier, gives the group of bodies without one.
    const auto carrier = body->carrier.empty() ? -1 : m_carriers.indexOf(QString::fromStdString(body->carrier));
    next[static_cast<std::size_t>(carrier + 1)].push_back(body);
  }
  for (std::size_t group = 0; group < next.size(); ++group) setGroup(group, next[group]);
}

// Unchanged bodies before and after the change keep their rows, with selection and scroll position.
void BodyModel::setGroup(std::size_t group, const Bodies& next) {
  Bodies& bodies = m_bodies[group];
  const auto head = std::mismatch(bodies.begin(), bodies.end(), next.begin(), next.end(), isSameBody);
  const auto first = head.first - bodies.begin();
  const auto tail = std::mismatch(bodies.rbegin(), std::make_reverse_iterator(head.first), next.rbegin(),
                                  std::make_reverse_iterator(head.second), isSameBody);
  const auto removed = tail.first.base() - head.first, added = tail.second.base() - head.second;
  const auto above = [&] { return group == 0 ? QModelIndex() : index(standing() + static_cast<int>(group) - 1, 0); };
  if (removed > 0) {
    beginRemoveRows(above(), static_cast<int>(first), static_cast<int>(first + removed) - 1);
    bodies.erase(bodies.begin() + first, bodies.begin() + first + removed);
    endRemoveRows();
  }
  if (added > 0) {
    beginInsertRows(above(), static_cast<int>(first), static_cast<int>(first + added) - 1);
    bodies.insert(bodies.begin() + first, next.begin() + first, next.begin() + first + added);
    endInsertRows();
  }
  for (std::size_t row = 0; row < next.size(); ++row) {
    if (bodies[row] == next[row]) continue;
    bodies[row] = next[row];
    const auto at = static_cast<int>(row);
    emit dataChanged(index(at, 0, above()), index(at, ColumnCount - 1, above()));
  }
}

// An index holds the number of its group of bodies.
std::size_t BodyModel::groupOf(const QModelIndex& index) const {
  return static_cast<std::size_t>(index.internalId());
}

const QString* BodyModel::carrier(const QModelIndex& index) const {
  const bool isCarrier = index.isValid() && groupOf(index) == 0 && index.row() >= standing();
  return isCarrier ? &m_carriers[index.row() - standing()] : nullptr;
}

BodyPointer BodyModel::body(const QModelIndex& index) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid) || carrier(index)) return nullptr;
  return m_bodies[groupOf(index)][static_cast<std::size_t>(index.row())];
}

QModelIndex BodyModel::indexOf(BodyId id) const {
  for (std::size_t group = 0; group < m_bodies.size(); ++group) {
    const Bodies& bodies = m_bodies[group];
    const auto found = std::lower_bound(bodies.begin(), bodies.end(), id,
                                        [](const BodyPointer& body, BodyId wanted) { return body->id < wanted; });
    if (found != bodies.end() && (*found)->id == id)
      return createIndex(static_cast<int>(found - bodies.begin()), Name, static_cast<quintptr>(group));
  }
  return {};
}

QModelIndex BodyModel::indexOfCarrier(const QString& name) const {
  const auto number = static_cast<int>(m_carriers.indexOf(name));
  return number < 0 ? QModelIndex() : index(standing() + number, Name);
}

QModelIndex BodyModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  const int group = parent.isValid() ? parent.row() - standing() + 1 : 0;
  return createIndex(row, column, static_cast<quintptr>(group));
}

QModelIndex BodyModel::parent(const QModelIndex& index) const {
  const std::size_t group = index.isValid() ? groupOf(index) : 0;
  return group == 0 ? QModelIndex() : this->index(standing() + static_cast<int>(group) - 1, 0);
}

int BodyModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return standing() + static_cast<int>(m_carriers.size());
  if (!carrier(parent) || parent.column() != 0) return 0;
  return static_cast<int>(m_bodies[static_cast<std::size_t>(parent.row() - standing() + 1)].size());
}

int BodyModel::columnCount(const QModelIndex&) const {
  return ColumnCount;
}

QVariant BodyModel::data(const QModelIndex& index, int role) const {
  if (const QString* const name = carrier(index)) {
    if (role == Qt::ToolTipRole) return tr("Drop bodies here for %1 to carry them").arg(*name);
    if (role == Qt::ForegroundRole) return themeColours(currentTheme()).muted;
    return role == Qt::DisplayRole && index.column() == Name ? QVariant(*name) : QVariant();
  }
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

// Bodies can be dropped on everything, also beside the rows, if there is a carrier.
Qt::ItemFlags BodyModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags dropping = m_carriers.empty() ? Qt::NoItemFlags : Qt::ItemIsDropEnabled;
  if (!index.isValid()) return dropping;
  if (carrier(index)) return Qt::ItemIsEnabled | dropping;
  const Qt::ItemFlags dragging = m_carriers.empty() ? Qt::NoItemFlags : Qt::ItemIsDragEnabled;
  const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren | dropping | dragging;
  return index.column() == Name ? usual | Qt::ItemIsEditable : usual;
}

bool BodyModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const BodyPointer body = this->body(index);
  if (!body || index.column() != Name || role != Qt::EditRole) return false;
  if (value.toString() != QString::fromStdString(body->name)) emit renameRequested(body->id, value.toString());
  return true;
}

QMimeData* BodyModel::mimeData(const QModelIndexList& indexes) const {
  QByteArrayList numbers;
  for (const QModelIndex& each : indexes) {
    const BodyPointer dragged = each.column() == Name ? body(each) : nullptr;
    if (dragged) numbers += QByteArray::number(dragged->id);
  }
  if (numbers.empty()) return nullptr;
  auto* data = new QMimeData;
  data->setData(m_mimeType, numbers.join(','));
  return data;
}

// The rows stay as they are until the document has changed.
bool BodyModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                             const QModelIndex& parent) {
  if (!canDropMimeData(data, action, row, column, parent)) return false;
  std::set<BodyId> dropped;
  for (const QByteArray& number : data->data(m_mimeType).split(',')) dropped.insert(number.toUInt());
  const QModelIndex onto = carrier(parent) ? parent : this->parent(parent);
  const QString* const name = carrier(onto);
  emit carrierRequested(dropped, name ? *name : QString());
  return true;
}

}  // namespace handwheel
