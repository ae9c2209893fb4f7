// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"

#include <optional>
#include <vector>

namespace handwheel {

// The piece at the free end of a part that was parted off. The rest of the material stays in the chuck.
struct EndPiece {
  TurnedProfile profile;      // profile of this piece alone, at its position along the axis of the part
  TurnedProfile::Range held;  // the samples that have material; not empty
  double length() const;      // mm
};

// Returns the end piece. Returns nothing if the part is in one piece or no material is left. O(samples).
std::optional<EndPiece> endPieceOf(const TurnedProfile& part);

// Returns the samples of each piece of a part, from the one in the chuck to the free end. O(samples).
std::vector<TurnedProfile::Range> piecesOf(const TurnedProfile& part);

// Returns one piece of a part alone. piece: a range of piecesOf(). O(samples).
EndPiece pieceAlone(const TurnedProfile& part, const TurnedProfile::Range& piece);

}  // namespace handwheel
