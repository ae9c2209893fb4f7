// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "scene/Body.h"

#include <optional>
#include <vector>

namespace handwheel {

// Edit that adds, removes or replaces some bodies of a document. Holds the other version of these and of the free
// number, and nothing else; versions of a body share its shape.
class BodyEdit : public Edit {
 public:
  struct Change {
    BodyId id;
    BodyPointer body;  // Null: the body is removed
  };

  // changes: at least one, no number twice. Names must be unique afterwards (BodyChanges.h checks that).
  explicit BodyEdit(std::vector<Change> changes) : m_changes(std::move(changes)) {}

  // The document must be a BodyOwner.
  void exchange(Document& document) override;
  bool absorb(const Edit& later) override;  // Only an edit of the same bodies
  std::size_t bytes() const override;

 private:
  std::vector<Change> m_changes;
  std::optional<BodyId> m_freeId;  // Free number of the other version; none before the first exchange
};

}  // namespace handwheel
