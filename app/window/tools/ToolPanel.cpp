// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/tools/ToolPanel.h"

#include <QCoreApplication>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace handwheel {

namespace {

// Returns the actions that can be pressed, each effect once: Return and Esc may both mean "done". An action that had an
// effect of its own before keeps its position and title, disabled, so that no other button moves under the pointer.
std::vector<ToolAction> buttonsOf(const std::vector<ToolAction>& actions,
                                  const std::map<std::string, std::string>& effectsBefore) {
  std::vector<ToolAction> shown;
  for (ToolAction action : actions) {
    const auto same = [&action](const ToolAction& other) { return other.effect == action.effect; };
    if (action.id.empty() || action.isKeyOnly) continue;
    if (std::any_of(shown.begin(), shown.end(), same)) {
      const auto before = effectsBefore.find(action.id);
      if (before == effectsBefore.end()) continue;
      action.effect = before->second;
      action.enabled = false;
    }
    shown.push_back(std::move(action));
  }
  return shown;
}

}  // namespace

QString titleOf(const std::string& effect) {
  const QString text = QCoreApplication::translate("Tool", effect.c_str());
  return text.left(1).toUpper() + text.mid(1);
}

ToolPanel::ToolPanel(QWidget* parent) : QWidget(parent), m_settings(new PropertyList(this)), m_column(new QVBoxLayout) {
  setObjectName(QStringLiteral("toolPanel"));
  m_settings->setEmptyText(tr("This tool has no settings."));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(m_settings, 1);
  m_column->setContentsMargins(8, 0, 8, 8);
  m_column->setSpacing(4);
  all->addLayout(m_column);
}

void ToolPanel::setActions(const std::vector<ToolAction>& actions,
                           const std::function<QString(const ToolAction&)>& keyOf) {
  const std::vector<ToolAction> shown = buttonsOf(actions, m_effects);
  m_effects.clear();
  for (const ToolAction& action : shown) m_effects[action.id] = action.effect;
  const bool same = std::equal(shown.begin(), shown.end(), m_buttons.begin(), m_buttons.end(),
                               [](const ToolAction& action, const auto& button) { return action.id == button.first; });
  if (!same) {
    for (const auto& [id, button] : m_buttons) {  // one of them may be what led here
      m_column->removeWidget(button);             // old and new ones together may be higher than the window
      button->hide();
      button->deleteLater();
    }
    m_buttons.clear();
    for (const ToolAction& action : shown) {
      auto* button = new QPushButton(this);
      button->setObjectName(QStringLiteral("toolAction/") + QString::fromStdString(action.id));
      button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys with the view
      connect(button, &QPushButton::clicked, this, [this, id = action.id] { emit triggered(id); });
      m_column->addWidget(button);
      m_buttons.emplace_back(action.id, button);
    }
  }
  for (std::size_t i = 0; i < shown.size(); ++i) {
    QPushButton* button = m_buttons[i].second;
    const QString title = titleOf(shown[i].effect), key = keyOf(shown[i]);
    button->setText(title);
    button->setAccessibleName(title);
    QString tip = key.isEmpty() ? title : QStringLiteral("%1 (%2)").arg(title, key);
    if (!shown[i].enabled && !shown[i].reason.empty())
      tip = tr("Not now: %1.").arg(QCoreApplication::translate("Tool", shown[i].reason.c_str()));
    button->setToolTip(tip);
    button->setEnabled(shown[i].enabled);
  }
}

}  // namespace handwheel
