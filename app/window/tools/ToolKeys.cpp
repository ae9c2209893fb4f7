// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/tools/ToolKeys.h"

#include "controls/ContextAction.h"
#include "window/tools/ToolPanel.h"

#include <QKeyEvent>
#include <QWidget>
#include <algorithm>

namespace handwheel {

namespace {

QKeySequence keyOf(const std::string& input) {
  return {QString::fromStdString(input), QKeySequence::PortableText};
}

bool isSign(int key) {
  const bool letterOrDigit = (key >= Qt::Key_A && key <= Qt::Key_Z) || (key >= Qt::Key_0 && key <= Qt::Key_9);
  return key > Qt::Key_Space && key < Qt::Key_Escape && !letterOrDigit;
}

// Returns the possible meanings of a press. A sign may need Shift or not, depending on the keyboard: "Ctrl++".
QList<QKeySequence> meaningsOf(const QKeyEvent& event) {
  const Qt::KeyboardModifiers modifiers =
      event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
  const Qt::Key key = event.key() == Qt::Key_Enter ? Qt::Key_Return : static_cast<Qt::Key>(event.key());
  QList<QKeySequence> meanings{QKeyCombination(modifiers, key)};
  if (modifiers.testFlag(Qt::ShiftModifier) && isSign(key))
    meanings << QKeySequence(QKeyCombination(modifiers & ~Qt::ShiftModifier, key));
  return meanings;
}

}  // namespace

ToolKeys::ToolKeys(QWidget& view, QObject* parent) : QObject(parent), m_view(view) {}

void ToolKeys::add(const QString& title, const std::string& tool, std::span<const ToolKey> keys) {
  auto& actions = m_actions[tool];
  for (const ToolKey& key : keys) {
    if (*key.command || actions.count(key.action) != 0) continue;
    auto* action = new ContextAction(titleOf(key.effect), title, tr("Tools") + QStringLiteral(" › ") + title, this);
    action->setObjectName(QStringLiteral("tool/%1/%2").arg(QString::fromStdString(tool), QLatin1String(key.action)));
    action->setShortcut(keyOf(key.input));
    action->setVisible(false);
    connect(action, &QAction::triggered, this, [this, id = std::string(key.action)] { emit triggered(id); });
    watch(*action);
    actions[key.action] = action;
  }
}

void ToolKeys::follow(const Tool* tool, const std::vector<ToolAction>& declared) {
  for (const auto& [id, actions] : m_actions) {
    for (const auto& [name, action] : actions) {
      const auto now =
          std::find_if(declared.begin(), declared.end(), [&name = name](const ToolAction& a) { return a.id == name; });
      const bool isThere = tool && id == tool->id() && now != declared.end();
      action->setVisible(isThere);
      action->setEnabled(isThere && now->enabled);
    }
  }
}

QString ToolKeys::text(const Tool& tool, const ToolAction& action) {
  const QList<QKeySequence> keys = keysOf(tool, action);
  return keys.isEmpty() ? QString() : keys.first().toString(QKeySequence::NativeText);
}

std::optional<ToolAction> ToolKeys::actionFor(const Tool& tool, const QKeyEvent& event) {
  const QList<QKeySequence> meanings = meaningsOf(event);
  std::optional<ToolAction> found;
  for (const ToolAction& action : tool.actions()) {
    if (!action.enabled || action.id.empty()) continue;
    const QList<QKeySequence> keys = keysOf(tool, action);
    if (std::none_of(keys.begin(), keys.end(), [&](const QKeySequence& key) { return meanings.contains(key); }))
      continue;
    if (found) return std::nullopt;
    found = action;
  }
  return found;
}

bool ToolKeys::isReserved(const Tool& tool, const QKeyEvent& event) {
  const QList<QKeySequence> meanings = meaningsOf(event);
  if (std::none_of(meanings.begin(), meanings.end(), isEndingKey)) return false;
  const std::vector<ToolAction> actions = tool.actions();
  return std::any_of(actions.begin(), actions.end(), [&](const ToolAction& action) {
    const QList<QKeySequence> keys = action.id.empty() ? QList<QKeySequence>() : keysOf(tool, action);
    return std::any_of(keys.begin(), keys.end(), [&](const QKeySequence& key) { return meanings.contains(key); });
  });
}

// A gesture of the pointer has none, whatever its words would be as keys.
QList<QKeySequence> ToolKeys::keysOf(const Tool& tool, const ToolAction& action) {
  if (!action.command.empty()) {
    if (const QAction* same = command(action.command)) return same->shortcuts();
    return {keyOf(action.input)};
  }
  if (action.id.empty()) return {};
  const auto& known = m_actions[tool.id()];
  const auto own = known.find(action.id);
  return own == known.end() ? QList<QKeySequence>{keyOf(action.input)} : own->second->shortcuts();
}

QAction* ToolKeys::command(const std::string& name) {
  QPointer<QAction>& known = m_commands[name];
  if (!known) {
    known = m_view.window()->findChild<QAction*>(QString::fromStdString(name));
    if (known) watch(*known);
  }
  return known;
}

void ToolKeys::watch(QAction& action) {
  connect(&action, &QAction::changed, this, [this, &action, keys = action.shortcuts()]() mutable {
    if (action.shortcuts() == keys) return;
    keys = action.shortcuts();
    emit changed();
  });
}

}  // namespace handwheel
