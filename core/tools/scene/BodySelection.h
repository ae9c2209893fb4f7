// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Body.h"

#include <functional>
#include <optional>

namespace handwheel {

// The selected body of a document, shared by tools, menus and panels. Window thread.
class BodySelection {
 public:
  std::optional<BodyId> body() const { return m_body; }
  void select(std::optional<BodyId> body) {
    if (body == m_body) return;
    m_body = body;
    if (m_listener) m_listener();
  }
  // Sets the listener, which is called after each change.
  void whenChanged(std::function<void()> listener) { m_listener = std::move(listener); }

 private:
  std::optional<BodyId> m_body;
  std::function<void()> m_listener;
};

}  // namespace handwheel
