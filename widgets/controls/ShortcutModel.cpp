// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ShortcutModel.h"

#include "controls/ActionText.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QAction>
#include <QFont>
#include <QSettings>
#include <algorithm>

namespace handwheel {

namespace {

const auto kGroup = QStringLiteral("shortcuts/");

// Whether typing one of them starts, or begins, the other.
bool collide(const QKeySequence& a, const QKeySequence& b) {
  const int common = std::min(a.count(), b.count());
  for (int i = 0; i < common; ++i) {
    if (a[static_cast<uint>(i)] != b[static_cast<uint>(i)]) return false;
  }
  return common > 0;
}

bool collides(const QKeySequence& key, const QList<QKeySequence>& others) {
  return std::any_of(others.begin(), others.end(), [&](const QKeySequence& other) { return collide(key, other); });
}

QStringList portable(const QList<QKeySequence>& keys) {
  QStringList texts;
  for (const QKeySequence& key : keys) texts << key.toString(QKeySequence::PortableText);
  return texts;
}

QList<QKeySequence> fromPortable(const QStringList& texts) {
  QList<QKeySequence> keys;
  for (const QString& text : texts) {
    const QKeySequence key = QKeySequence::fromString(text, QKeySequence::PortableText);
    if (!key.isEmpty()) keys << key;
  }
  return keys;
}

}  // namespace

void ShortcutModel::setActions(const QList<QAction*>& actions, const QMenuBar* menus) {
  const QHash<const QAction*, QString> paths = menuPaths(menus);
  std::vector<Entry> entries;
  for (QAction* action : actions) {
    if (isCommand(*action)) entries.push_back(entryOf(action, paths.value(action)));
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.path.localeAwareCompare(b.path) < 0; });
  beginResetModel();
  m_entries = std::move(entries);
  endResetModel();
}

// An action that is known already has the user's keys: its defaults are those of its entry.
ShortcutModel::Entry ShortcutModel::entryOf(QAction* action, const QString& path) const {
  Entry entry{action, action->objectName(), withoutMnemonic(action->text()), path, action->shortcuts()};
  const auto known =
      std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.action == action; });
  if (known != m_entries.end()) {
    entry.defaults = known->defaults;
    return entry;
  }
  const QSettings settings;
  const QString key = kGroup + entry.id;
  if (settings.contains(key)) action->setShortcuts(fromPortable(settings.value(key).toStringList()));
  return entry;
}

QList<QKeySequence> ShortcutModel::keys(int row) const {
  const Entry& entry = m_entries[static_cast<std::size_t>(row)];
  return entry.action ? entry.action->shortcuts() : QList<QKeySequence>();
}

void ShortcutModel::setKeys(int row, const QList<QKeySequence>& keys) {
  apply(m_entries[static_cast<std::size_t>(row)], keys);
  announce();
}

void ShortcutModel::reset(int row) {
  setKeys(row, m_entries[static_cast<std::size_t>(row)].defaults);
}

void ShortcutModel::resetAll() {
  for (const Entry& entry : m_entries) apply(entry, entry.defaults);
  announce();
}

void ShortcutModel::apply(const Entry& entry, const QList<QKeySequence>& keys) {
  if (!entry.action) return;
  entry.action->setShortcuts(keys);
  QSettings settings;
  if (keys == entry.defaults) {
    settings.remove(kGroup + entry.id);
  } else {
    settings.setValue(kGroup + entry.id, portable(keys));
  }
}

// A change of one row changes the conflicts of others.
void ShortcutModel::announce() {
  if (!m_entries.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

QList<int> ShortcutModel::conflicts(int row) const {
  const QList<QKeySequence> mine = keys(row);
  QList<int> rows;
  for (int other = 0; other < rowCount(); ++other) {
    if (other == row) continue;
    const QList<QKeySequence> theirs = keys(other);
    if (std::any_of(mine.begin(), mine.end(), [&](const QKeySequence& key) { return collides(key, theirs); }))
      rows << other;
  }
  return rows;
}

void ShortcutModel::resolveInFavourOf(int row) {
  const QList<QKeySequence> mine = keys(row);
  for (int other : conflicts(row)) {
    QList<QKeySequence> theirs = keys(other);
    theirs.removeIf([&](const QKeySequence& key) { return collides(key, mine); });
    apply(m_entries[static_cast<std::size_t>(other)], theirs);
  }
  announce();
}

ShortcutChanges ShortcutModel::changes() const {
  ShortcutChanges changes;
  for (const Entry& entry : m_entries) {
    if (entry.action && entry.action->shortcuts() != entry.defaults)
      changes.insert(entry.id, portable(entry.action->shortcuts()));
  }
  return changes;
}

void ShortcutModel::setChanges(const ShortcutChanges& changes) {
  for (const Entry& entry : m_entries) {
    const auto change = changes.find(entry.id);
    apply(entry, change == changes.end() ? entry.defaults : fromPortable(*change));
  }
  announce();
}

int ShortcutModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int ShortcutModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant ShortcutModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Entry& entry = m_entries[static_cast<std::size_t>(index.row())];
  const bool changed = keys(index.row()) != entry.defaults;
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == Keys) return QKeySequence::listToString(keys(index.row()), QKeySequence::NativeText);
      return entry.path.isEmpty() ? entry.title : entry.path + QStringLiteral(" › ") + entry.title;
    case Qt::DecorationRole:
      if (index.column() != Keys || conflicts(index.row()).isEmpty()) return {};
      return icon(QStringLiteral("warning"), themeColours(currentTheme()).warning);
    case Qt::FontRole: {
      QFont font;
      font.setBold(index.column() == Keys && changed);
      return font;
    }
    case ConflictRole: {
      QStringList names;
      for (int row : conflicts(index.row())) names << m_entries[static_cast<std::size_t>(row)].title;
      return names;
    }
    case ChangedRole:
      return changed;
    case IdRole:
      return entry.id;
    case PathRole:
      return entry.path;
    default:
      return {};
  }
}

QVariant ShortcutModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == Command ? tr("Command") : tr("Keys");
}

}  // namespace handwheel
