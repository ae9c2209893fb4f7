// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace handwheel {

// Immutable value of a document at one moment. It may be read on any thread; saves, autosaves and jobs work on
// snapshots. Each kind of document derives a class.
class Snapshot {
 public:
  virtual ~Snapshot() = default;
};

using SnapshotPointer = std::shared_ptr<const Snapshot>;

}  // namespace handwheel
