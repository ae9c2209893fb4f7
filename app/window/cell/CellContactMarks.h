// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/CellContacts.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <array>

namespace handwheel {

class ContactLayer;

// Marks where things in the shown cell touch, also while they move. The places are found by a worker, the latest of
// what is shown next. Window thread.
class CellContactMarks : public QObject {
  Q_OBJECT

 public:
  // Who shows the cell: what a replay shows hides what a tool does, and that the document.
  enum class Source { Document, Tool, Replay };
  using Collisions = std::vector<CellCollision>;

  CellContactMarks(const WindowContext& parts, QObject* parent);
  ~CellContactMarks() override;

  QAction* action() { return &m_action; }
  void setVisible(bool isVisible);
  // What collides in the cell as the source shows it; empty: nothing.
  void show(Source source, Collisions collisions);
  // The source shows nothing any more.
  void clear(Source source);
  void clearAll();

 private:
  const Collisions* shown() const;
  void look();
  void find();

  WindowContext m_parts;
  std::shared_ptr<ContactLayer> m_layer;
  QAction m_action;
  std::array<std::optional<Collisions>, 3> m_sources;
  std::uint64_t m_cell = 0;  // counts the cells that were shown
  bool m_isUnderWay = false;
  bool m_isStale = false;  // something else is shown than what is being looked at
  JobRunner m_finding;
};

}  // namespace handwheel
