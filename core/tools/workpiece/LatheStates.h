// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/lathe/LatheMachine.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

// The state of a lathe at each part of a document, for undo and redo. Keeps no part alive.
class LatheStates {
 public:
  using Part = std::shared_ptr<const TurnedPart>;

  // part: null for the uncut bar.
  void note(const Part& part, const LatheState& state);
  std::optional<LatheState> of(const Part& part) const;  // none: not noted. O(parts)

 private:
  std::optional<LatheState> m_ofBar;
  std::vector<std::pair<std::weak_ptr<const TurnedPart>, LatheState>> m_ofParts;
};

}  // namespace handwheel
