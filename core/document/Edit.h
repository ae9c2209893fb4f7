// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

namespace handwheel {

class Document;

// Base class of reversible changes of a document. Applying a change turns it into its own inverse, so undo and redo are
// the same exchange. Its memory and time are in proportion to the change.
class Edit {
 public:
  virtual ~Edit() = default;

  // Applies the edit, which becomes its inverse. Never fails: its creator has checked that it can be applied.
  virtual void exchange(Document& document) = 0;

  // For edits of one property, such as those of a slider: merges a later edit that was applied to the same property and
  // returns true; the first inverse is kept.
  virtual bool absorb(const Edit& later) {
    (void)later;
    return false;
  }

  virtual std::size_t bytes() const = 0;  // approximate; for the share of history in a document's memory
};

}  // namespace handwheel
