// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/EndPiece.h"

namespace handwheel {

double EndPiece::length() const {
  return profile.spacing() * static_cast<double>(held.size() - 1);
}

std::optional<EndPiece> endPieceOf(const TurnedProfile& part) {
  std::size_t end = part.size();
  while (end > 0 && !part.hasMaterial(end - 1)) --end;
  std::size_t first = end;
  while (first > 0 && part.hasMaterial(first - 1)) --first;
  EndPiece piece{part, {first, end}};
  bool isParted = false;
  for (std::size_t i = 0; i < first; ++i) isParted = piece.profile.limitOuter(i, part.inner(i)) || isParted;
  return isParted ? std::optional(std::move(piece)) : std::nullopt;
}

}  // namespace handwheel
