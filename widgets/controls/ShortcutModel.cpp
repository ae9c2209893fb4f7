// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ShortcutModel.h"

#include "controls/ActionText.h"
#include "controls/ContextAction.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QAction>
#include <QFont>
#include <QSettings>
#include <algorithm>

namespace handwheel {

namespace {

const auto kGroup = QStringLiteral("shortcuts/");

// Returns true if typing one of them starts, or begins, the other.
bool collide(const QKeySequence& a, const QKeySequence& b) {
  const int common = std::min(a.count(), b.count());
  for (int i = 0; i < common; ++i) {
    if (a[static_cast<uint>(i)] != b[static_cast<uint>(i)]) return false;
  }
  return common > 0;
}

// Returns true if a key collides with others. Ending keys do not count: they are assigned once, and stay so.
bool collides(const QKeySequence& key, const QList<QKeySequence>& others) {
  return !isEndingKey(key) &&
         std::any_of(others.begin(), others.end(), [&](const QKeySequence& other) { return collide(key, other); });
}

QStringList portable(const QList<QKeySequence>& keys) {
  QStringList texts;
  for (const QKeySequence& key : keys) texts << key.toString(QKeySequence::PortableText);
  return texts;
}

QList<QKeySequence> fromPortable(const QStringList& texts) {
  QList<QKeySequence> keys;
  for (const QString& text : texts) keys << QKeySequence::fromString(text, QKeySequence::PortableText);
  return keys;
}

bool isKey(const QKeySequence& keys) {
  for (int i = 0; i < keys.count(); ++i) {
    if (keys[static_cast<uint>(i)].key() == Qt::Key_unknown) return false;
  }
  return !keys.isEmpty();
}

}  // namespace

void ShortcutModel::setActions(const QList<QAction*>& actions, const QMenuBar* menus) {
  const QHash<const QAction*, QString> paths = menuPaths(menus);
  std::vector<Entry> entries;
  for (QAction* action : actions) {
    if (isCommand(*action)) entries.push_back(entryOf(action, pathOf(*action, paths)));
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.path.localeAwareCompare(b.path) < 0; });
  beginResetModel();
  m_entries = std::move(entries);
  endResetModel();
}

// Returns the entry of an action. An action that is known already has the user's keys: its defaults are those of its
// entry.
ShortcutModel::Entry ShortcutModel::entryOf(QAction* action, const QString& path) const {
  const auto* scoped = qobject_cast<const ContextAction*>(action);
  Entry entry{action,
              action->objectName(),
              withoutMnemonic(action->text()),
              path,
              scoped ? scoped->scope() : QString(),
              action->shortcuts()};
  const auto known =
      std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.action == action; });
  if (known != m_entries.end()) {
    entry.defaults = known->defaults;
    return entry;
  }
  const QSettings settings;
  const QString key = kGroup + entry.id;
  if (!settings.contains(key)) return entry;
  const QList<QKeySequence> kept = fromPortable(settings.value(key).toStringList());
  const QList<QKeySequence> possible = possibleOf(entry, kept);
  if (kept.isEmpty() || !possible.isEmpty()) action->setShortcuts(possible);
  return entry;
}

bool ShortcutModel::isFixed(const Entry& entry) {
  return !entry.scope.isEmpty() && std::any_of(entry.defaults.begin(), entry.defaults.end(), isEndingKey);
}

QString ShortcutModel::objection(const Entry& entry, const QKeySequence& key) {
  if (entry.defaults.contains(key)) return {};
  if (isFixed(entry)) return tr("In every tool Return finishes and Esc cancels: these keys cannot be changed.");
  if (isEndingKey(key)) return tr("Return, Enter and Esc end what a tool does. No other command can have them.");
  if (!isKey(key)) return tr("This key does not exist.");
  if (!entry.scope.isEmpty() && key.count() > 1) return tr("In a tool, a shortcut must be a single key press.");
  return {};
}

QString ShortcutModel::objection(int row, const QKeySequence& key) const {
  return objection(entry(row), key);
}

// Returns the keys that a row may have; a fixed row keeps its own.
QList<QKeySequence> ShortcutModel::possibleOf(const Entry& entry, QList<QKeySequence> keys) {
  if (isFixed(entry)) return entry.defaults;
  keys.removeIf([&](const QKeySequence& key) { return !objection(entry, key).isEmpty(); });
  return keys;
}

QList<QKeySequence> ShortcutModel::keys(int row) const {
  return entry(row).action ? entry(row).action->shortcuts() : QList<QKeySequence>();
}

void ShortcutModel::setKeys(int row, const QList<QKeySequence>& keys) {
  apply(entry(row), keys);
  announce();
}

void ShortcutModel::reset(int row) {
  setKeys(row, entry(row).defaults);
}

void ShortcutModel::resetAll() {
  for (const Entry& entry : m_entries) apply(entry, entry.defaults);
  announce();
}

void ShortcutModel::apply(const Entry& entry, const QList<QKeySequence>& wanted) {
  if (!entry.action) return;
  const QList<QKeySequence> keys = possibleOf(entry, wanted);
  entry.action->setShortcuts(keys);
  QSettings settings;
  if (keys == entry.defaults) {
    settings.remove(kGroup + entry.id);
  } else {
    settings.setValue(kGroup + entry.id, portable(keys));
  }
}

// Returns the name of a command. That of a tool includes the tool: several have a "Smaller brush".
QString ShortcutModel::nameOf(const Entry& entry) {
  return entry.scope.isEmpty() ? entry.title : entry.scope + QStringLiteral(" › ") + entry.title;
}

// Emits changes of all rows: a change of one row changes the conflicts of others.
void ShortcutModel::announce() {
  if (!m_entries.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

bool ShortcutModel::areTogether(const Entry& a, const Entry& b) {
  return a.scope == b.scope || a.scope.isEmpty() || b.scope.isEmpty();
}

QList<int> ShortcutModel::conflicts(int row) const {
  const QList<QKeySequence> mine = keys(row);
  QList<int> rows;
  for (int other = 0; other < rowCount(); ++other) {
    if (other == row || !areTogether(entry(row), entry(other))) continue;
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
    apply(entry(other), theirs);
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
  const Entry& entry = this->entry(index.row());
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
    case Qt::ForegroundRole:
      return isFixed(entry) ? QVariant(themeColours(currentTheme()).muted) : QVariant();
    case Qt::ToolTipRole:
      return isFixed(entry) ? objection(entry, {}) : QVariant();
    case ConflictRole: {
      QStringList names;
      for (int row : conflicts(index.row())) names << nameOf(this->entry(row));
      return names;
    }
    case AmbiguousRole: {
      const QList<int> rows = conflicts(index.row());
      return std::any_of(rows.begin(), rows.end(), [&](int row) { return this->entry(row).scope == entry.scope; });
    }
    case ChangedRole:
      return changed;
    case FixedRole:
      return isFixed(entry);
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
