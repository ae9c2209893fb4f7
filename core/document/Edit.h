// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

namespace handwheel {

class Document;

// Base class of reversible changes of a document. Applying an edit turns it into its own inverse, so undo and redo call
// the same function. Its memory and time are proportional to the size of the change.
class Edit {
 public:
  virtual ~Edit() = default;

  // Applies the edit, which becomes its inverse. Cannot fail, because the creator of the edit has checked that it can
  // be applied.
  virtual void exchange(Document& document) = 0;

  // Merges a later edit of the same property, such as one of the same slider, and returns true; the first inverse is
  // kept. Returns false if the edits cannot be merged.
  virtual bool absorb(const Edit& later) {
    (void)later;
    return false;
  }

  virtual std::size_t bytes() const = 0;  // approximate; for the memory that the history takes
};

}  // namespace handwheel
