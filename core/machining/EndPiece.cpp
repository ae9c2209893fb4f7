// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/EndPiece.h"

namespace handwheel {

double EndPiece::length() const {
  return profile.spacing() * static_cast<double>(held.size() - 1);
}

std::vector<TurnedProfile::Range> piecesOf(const TurnedProfile& part) {
  std::vector<TurnedProfile::Range> pieces;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (!part.hasMaterial(i)) continue;
    if (pieces.empty() || pieces.back().last < i) pieces.push_back({i, i});
    pieces.back().last = i + 1;
  }
  return pieces;
}

EndPiece pieceAlone(const TurnedProfile& part, const TurnedProfile::Range& piece) {
  EndPiece alone{part, piece};
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (i < piece.first || i >= piece.last) alone.profile.limitOuter(i, part.inner(i));
  }
  return alone;
}

std::optional<EndPiece> endPieceOf(const TurnedProfile& part) {
  const std::vector<TurnedProfile::Range> pieces = piecesOf(part);
  return pieces.size() > 1 ? std::optional(pieceAlone(part, pieces.back())) : std::nullopt;
}

}  // namespace handwheel
