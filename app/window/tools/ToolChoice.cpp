// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/tools/ToolChoice.h"

#include "controls/ActionText.h"
#include "theme/Icons.h"
#include "window/ActionToolTip.h"
#include "window/documents/DocumentTab.h"
#include "window/tools/ToolHost.h"
#include "window/tools/ToolKeys.h"

#include <algorithm>

namespace handwheel {

ToolChoice::ToolChoice(ToolHost& host, QObject* parent) : QObject(parent), m_host(host), m_group(this) {
  m_group.setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  // Later, when the tool is out of the way.
  connect(&m_host.runner(), &ToolRunner::ended, this, &ToolChoice::ended, Qt::QueuedConnection);
}

void ToolChoice::add(KindUi& kind) {
  m_offers[&kind] = kind.tools();
  for (const ToolDescriptor& offer : m_offers[&kind]) {
    m_host.keys().add(withoutMnemonic(offer.text), offer.tool, offer.keys);
    auto* action = m_group.findChild<QAction*>(offer.id);
    if (!action) {
      action = new QAction(icon(offer.icon), offer.text, &m_group);
      action->setObjectName(offer.id);
      action->setCheckable(true);
      action->setIconVisibleInMenu(false);
      action->setShortcut(offer.key);
      setActionToolTip(*action, offer.tip);
      m_group.addAction(action);
      connect(action, &QAction::triggered, this, [this, id = offer.id](bool on) { choose(on ? id : QString()); });
    }
    m_actions[&kind] << action;
  }
}

void ToolChoice::putAway() {
  m_document = nullptr;
  m_host.stop();
}

void ToolChoice::takeUp(DocumentTab* document) {
  m_document = document;
  const QList<QAction*> offered = document ? m_actions.at(&document->ui) : QList<QAction*>();
  for (QAction* action : m_group.actions()) action->setEnabled(offered.contains(action));
  if (document) start();
}

const ToolDescriptor* ToolChoice::offer(const QString& id) const {
  const std::vector<ToolDescriptor>& offers = m_offers.at(&m_document->ui);
  const auto wanted = std::find_if(offers.begin(), offers.end(), [&id](const ToolDescriptor& each) {
    return id.isEmpty() ? each.isDefault : each.id == id;
  });
  return wanted == offers.end() ? nullptr : &*wanted;
}

void ToolChoice::choose(const QString& id) {
  if (!m_document) return;
  m_document->tool = id;
  start();
  const ToolDescriptor* chosen = offer(id);
  emit !chosen || chosen->isDefault ? defaultChosen() : otherChosen();
}

void ToolChoice::start() {
  const ToolDescriptor* chosen = offer(m_document->tool);
  for (QAction* action : m_group.actions()) action->setChecked(chosen && action->objectName() == chosen->id);
  // First: what it commits in the end, the next one begins with; and as it ends it cancels jobs, which must not be
  // those of the next.
  m_host.stop();
  if (chosen) m_host.start(chosen->make(), m_document->document);
}

void ToolChoice::ended() {
  if (!m_document || m_host.runner().tool()) return;
  const ToolDescriptor* usual = offer({});
  const bool another = !m_document->tool.isEmpty();
  m_document->tool.clear();
  if (!usual && !another) return;  // it has been put away
  start();
  if (another) emit defaultChosen();
}

}  // namespace handwheel
