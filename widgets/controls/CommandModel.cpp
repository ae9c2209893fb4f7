// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/CommandModel.h"

#include "controls/ActionText.h"
#include "controls/ContextAction.h"

#include <QAction>
#include <algorithm>

namespace handwheel {

namespace {

// Actions without a tooltip of their own repeat their text in it.
QString hintOf(const QAction& action) {
  const QString hint = action.toolTip();
  return hint == action.iconText() || hint == withoutMnemonic(action.text()) ? QString() : hint;
}

QString reasonOf(const QAction& action) {
  const QString reason = action.property(kDisabledReason).toString();
  if (!reason.isEmpty()) return reason;
  return hintOf(action).isEmpty() ? CommandModel::tr("Not possible now") : hintOf(action);
}

// Returns true if an action of a tool is also a command of the window, which is listed.
bool isSaidBy(const QAction& action, const QList<QAction*>& all) {
  if (!qobject_cast<const ContextAction*>(&action)) return false;
  const QString title = withoutMnemonic(action.text());
  return std::any_of(all.begin(), all.end(), [&](const QAction* other) {
    return !qobject_cast<const ContextAction*>(other) && other->isVisible() && withoutMnemonic(other->text()) == title;
  });
}

}  // namespace

void CommandModel::setActions(const QList<QAction*>& actions, const QHash<const QAction*, QString>& paths) {
  m_commands.clear();
  std::vector<CommandText> texts;
  for (QAction* action : actions) {
    if (!action->isVisible() || isSaidBy(*action, actions)) continue;
    const QString path = pathOf(*action, paths);
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    texts.push_back({action->objectName(), withoutMnemonic(action->text()), path, hintOf(*action), keys});
    m_commands.push_back({action, path});
  }
  m_search.setCommands(texts);
}

void CommandModel::setQuery(const QString& query) {
  beginResetModel();
  m_found = m_search.find(query, m_recent);
  endResetModel();
}

QAction* CommandModel::action(const QModelIndex& index) const {
  if (!index.isValid() || !checkIndex(index)) return nullptr;  // nothing is selected if nothing was found
  return m_commands[static_cast<std::size_t>(m_found[static_cast<std::size_t>(index.row())])].action;
}

int CommandModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_found.size());
}

QVariant CommandModel::data(const QModelIndex& index, int role) const {
  const QAction* action = this->action(index);
  if (!action) return {};
  switch (role) {
    case Qt::DisplayRole:
      return withoutMnemonic(action->text());
    case Qt::DecorationRole:
      return action->icon();
    case Qt::ToolTipRole:
      return action->toolTip();
    case Qt::AccessibleDescriptionRole:
      return action->isEnabled() ? hintOf(*action) : data(index, ReasonRole);
    case PathRole:
      return m_commands[static_cast<std::size_t>(m_found[static_cast<std::size_t>(index.row())])].path;
    case ShortcutRole:
      return action->shortcut().toString(QKeySequence::NativeText);
    case ReasonRole:
      if (action->isEnabled()) return QString();
      return reasonOf(*action);
    default:
      return {};
  }
}

}  // namespace handwheel
