// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"

#include <QString>

namespace handwheel {

// Optional interface of a tool whose gestures take minutes, for autosave. An example is a pass with the automatic feed:
// an autosave must not wait for its end. The functions must be called on the window thread.
class UnfinishedGesture {
 public:
  virtual ~UnfinishedGesture() = default;

  // Returns the value that the document would have after Tool::settle(). Nothing changes, and the work continues.
  // Returns null if there is no unfinished work.
  virtual SnapshotPointer withGesture() = 0;
  // Returns the name, for the user, of the unfinished work that undo would revert now; empty if there is none.
  virtual QString underWay() const = 0;
};

}  // namespace handwheel
