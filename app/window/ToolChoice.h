// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/KindUi.h"

#include <QActionGroup>

namespace handwheel {

// The tools of all kinds as actions, of which one is chosen. Each document keeps the tool that it was left with; one
// that ends gives way to the usual tool of its kind.
class ToolChoice : public QObject {
  Q_OBJECT

 public:
  ToolChoice(ToolHost& host, QObject* parent);

  void add(KindUi& kind);
  QList<QAction*> actions(const KindUi& kind) const { return m_actions.at(&kind); }

  // Before another document is made the present one, and before that one goes.
  void putAway();
  // After that; null: none is open.
  void takeUp(OpenDocument* document);

 signals:
  void usualChosen();
  void otherChosen();  // by the user, who will want its settings

 private:
  const ToolOffer* offer(const QString& id) const;  // of the kind of the present document
  void choose(const QString& id);
  void start();
  void ended();

  ToolHost& m_host;
  QActionGroup m_group;
  std::map<const KindUi*, QList<QAction*>> m_actions;
  std::map<const KindUi*, std::vector<ToolOffer>> m_offers;
  OpenDocument* m_document = nullptr;
};

}  // namespace handwheel
