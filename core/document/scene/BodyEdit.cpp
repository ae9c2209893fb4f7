// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyEdit.h"

#include "document/Document.h"
#include "document/scene/BodyOwner.h"

#include <algorithm>

namespace handwheel {

void BodyEdit::exchange(Document& document) {
  auto& owner = dynamic_cast<BodyOwner&>(document);
  const BodyId freeBefore = owner.m_bodies.freeId();
  for (Change& change : m_changes) {
    BodyPointer before = owner.m_bodies.withId(change.id);
    owner.m_bodies = change.body ? owner.m_bodies.with(change.body) : owner.m_bodies.without(change.id);
    change.body = std::move(before);
  }
  if (m_freeId) owner.m_bodies = owner.m_bodies.withRestoredFreeId(*m_freeId);
  m_freeId = freeBefore;
  owner.bodiesChanged();
}

bool BodyEdit::absorb(const Edit& later) {
  const auto* edit = dynamic_cast<const BodyEdit*>(&later);
  return edit && std::equal(m_changes.begin(), m_changes.end(), edit->m_changes.begin(), edit->m_changes.end(),
                            [](const Change& a, const Change& b) { return a.id == b.id; });
}

// The shape counts where only this edit holds it.
std::size_t BodyEdit::bytes() const {
  std::size_t sum = sizeof *this + m_changes.size() * sizeof(Change);
  for (const Change& change : m_changes) {
    if (!change.body) continue;
    sum += change.body->bytes();
    if (change.body->geometry.use_count() == 1) sum += change.body->geometry->bytes();
  }
  return sum;
}

}  // namespace handwheel
