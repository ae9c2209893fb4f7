// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "scene/Body.h"

#include <optional>
#include <vector>

namespace handwheel {

// Edit that adds, removes or replaces some bodies of a document. It holds only the other versions of these bodies and
// of the number for the next new body (BodySet::freeId()); the versions of a body share its shape.
class BodyEdit : public Edit {
 public:
  struct Change {
    BodyId id;
    BodyPointer body;  // Null: the body is removed
  };

  // changes: at least one change; no number may occur twice. The names of the bodies must be unique after the edit,
  // which BodyChanges.h checks.
  explicit BodyEdit(std::vector<Change> changes) : m_changes(std::move(changes)) {}

  // Exchanges the versions. The document must be a BodyOwner.
  void exchange(Document& document) override;
  bool absorb(const Edit& later) override;  // Absorbs only an edit of the same bodies
  std::size_t bytes() const override;

 private:
  std::vector<Change> m_changes;
  std::optional<BodyId> m_freeId;  // BodySet::freeId() of the other version; nothing before the first exchange
};

}  // namespace handwheel
