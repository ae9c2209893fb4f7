// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace handwheel {

// Immutable value of a document at one moment. Any thread may read it: saves, autosaves and jobs work on one. Each kind
// of document derives its own.
class Snapshot {
 public:
  virtual ~Snapshot() = default;
};

using SnapshotPointer = std::shared_ptr<const Snapshot>;

}  // namespace handwheel
