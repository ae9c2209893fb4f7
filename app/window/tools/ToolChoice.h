// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/KindUi.h"

#include <QActionGroup>

namespace handwheel {

// The action group of all tools, one of which is active. Each document remembers its last tool; when a tool ends, the
// default tool of its kind is started.
class ToolChoice : public QObject {
  Q_OBJECT

 public:
  ToolChoice(ToolHost& host, QObject* parent);

  void add(KindUi& kind);
  QList<QAction*> actions(const KindUi& kind) const { return m_actions.at(&kind); }

  // Starts a tool of the current document for the user; id: empty: the default tool.
  void choose(const QString& id);
  // Stops the tool. To be called before another document becomes current, and before the current one is destroyed.
  void putAway();
  // Starts the tool of the new current document; null: no document is open.
  void takeUp(DocumentTab* document);

 signals:
  void defaultChosen();
  void otherChosen();  // the user chose a tool other than the default, whose settings are to be shown

 private:
  const ToolDescriptor* offer(const QString& id) const;  // descriptor of a tool of the current document's kind
  void start();
  void ended();

  ToolHost& m_host;
  QActionGroup m_group;
  std::map<const KindUi*, QList<QAction*>> m_actions;
  std::map<const KindUi*, std::vector<ToolDescriptor>> m_offers;
  DocumentTab* m_document = nullptr;
};

}  // namespace handwheel
