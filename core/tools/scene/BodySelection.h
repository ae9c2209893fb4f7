// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodySet.h"

#include <functional>
#include <optional>
#include <set>

namespace handwheel {

// The selected bodies of a document, shared by tools, menus and panels. Its functions must be called on the window
// thread.
class BodySelection {
 public:
  const std::set<BodyId>& bodies() const { return m_bodies; }
  bool empty() const { return m_bodies.empty(); }
  // Returns the selected body, or nothing unless exactly one body is selected.
  std::optional<BodyId> body() const { return m_bodies.size() == 1 ? std::optional(*m_bodies.begin()) : std::nullopt; }

  void select(BodyId body) { selectAll({body}); }
  void clear() { selectAll({}); }
  void selectAll(std::set<BodyId> bodies) {
    if (bodies == m_bodies) return;
    m_bodies = std::move(bodies);
    if (m_listener) m_listener();
  }
  // Deselects the bodies that are no longer in the document.
  void keepOnly(const BodySet& present) {
    std::set<BodyId> kept = m_bodies;
    std::erase_if(kept, [&](BodyId id) { return !present.withId(id); });
    selectAll(std::move(kept));
  }
  // Sets the listener, which is called after each change.
  void whenChanged(std::function<void()> listener) { m_listener = std::move(listener); }

 private:
  std::set<BodyId> m_bodies;
  std::function<void()> m_listener;
};

}  // namespace handwheel
