// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"

#include <QString>

namespace handwheel {

// Optional interface of a tool whose gestures take minutes, for autosave. A pass with the automatic feed takes so long;
// an autosave must not wait for its end. Window thread.
class UnfinishedGesture {
 public:
  virtual ~UnfinishedGesture() = default;

  // Returns the value of the document as Tool::settle() would leave it. Nothing changes by it, and the work continues.
  // Null: there is no unfinished work.
  virtual SnapshotPointer withGesture() = 0;
  // Returns the unfinished work that undo would revert now, in the user's words; empty: there is none.
  virtual QString underWay() const = 0;
};

}  // namespace handwheel
