// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"

#include <optional>

namespace handwheel {

// The piece at the free end of a part that was parted off. What is behind it stays in the chuck.
struct EndPiece {
  TurnedProfile profile;      // without the other pieces; in the same place
  TurnedProfile::Range held;  // the samples that have material; not empty
  double length() const;      // mm
};

// None: the part is in one piece, or nothing is left of it. O(samples).
std::optional<EndPiece> endPieceOf(const TurnedProfile& part);

}  // namespace handwheel
