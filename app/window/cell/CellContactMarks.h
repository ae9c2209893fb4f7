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

// Marks the contacts in the displayed cell, also while its objects move. A worker computes the marks, always for the
// latest display. The functions must be called on the window thread.
class CellContactMarks : public QObject {
  Q_OBJECT

 public:
  // The source of the displayed cell. A replay hides the display of a tool, which hides the document.
  enum class Source { Document, Tool, Replay };
  using Collisions = std::vector<CellCollision>;

  CellContactMarks(const WindowContext& parts, QObject* parent);
  ~CellContactMarks() override;

  QAction* action() { return &m_action; }
  void setVisible(bool isVisible);
  // Sets the collisions of the cell in the display of the source; empty: none.
  void show(Source source, Collisions collisions);
  // Removes the collisions of the source. Must be called when the source displays nothing any more.
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
  std::uint64_t m_cell = 0;  // Counts the cells that were shown
  bool m_isUnderWay = false;
  bool m_isStale = false;  // True if the display has changed since the present computation began
  JobRunner m_finding;
};

}  // namespace handwheel
