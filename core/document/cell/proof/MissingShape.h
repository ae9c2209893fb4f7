// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace handwheel {

// A link or body whose shape could not be read, and the decision about it.
struct MissingShape {
  // Open: nothing was decided, so no path is proven free. LeftOut: proofs leave it out. Replaced: a body that the link
  // carries has its place.
  enum class State { Open, LeftOut, Replaced };

  std::string part;  // Name of the link, or "body.3", as in CellPlans::missingAs
  std::string name;  // The name for the user
  std::string what;  // Files and elements that could not be read: "hand.stl, capsule"
  State state = State::Open;
  std::string by = {};  // Name of the body that replaces it

  bool operator==(const MissingShape&) const = default;
};

}  // namespace handwheel
