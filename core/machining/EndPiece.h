// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"

#include <optional>
#include <vector>

namespace handwheel {

// The piece at the free end of a part that was parted off. What is behind it stays in the chuck.
struct EndPiece {
  TurnedProfile profile;      // without the other pieces; in the same place
  TurnedProfile::Range held;  // the samples that have material; not empty
  double length() const;      // mm
};

// None: the part is in one piece, or nothing is left of it. O(samples).
std::optional<EndPiece> endPieceOf(const TurnedProfile& part);

// The samples of each piece of a part, from the one in the chuck to the free end. O(samples).
std::vector<TurnedProfile::Range> piecesOf(const TurnedProfile& part);

// One of these pieces alone. O(samples).
EndPiece pieceAlone(const TurnedProfile& part, const TurnedProfile::Range& piece);

}  // namespace handwheel
