// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "volume/drilling/DrillBit.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A kind of drill bit, with its usual size.
struct DrillBitType {
  std::string id;  // stable id for files and the command line, such as "twist"
  DrillBit tool;

  static constexpr std::size_t kMost = 100;  // largest number of types in a table
};

// Reads a table of drill bits in the form of resources/drilling/tools.json. Errors: the errors of parseJson(),
// ElementMalformed {the table, the problem and its drill}.
Result<std::vector<DrillBitType>> drillBitsFromJson(std::string_view text);
// Returns the built-in drill bits; the first is the default.
const std::vector<DrillBitType>& drillBits();

// Returns the drill bit for a word such as "ball:6", "twist:6", "burr:4", "saw:30" or "saw:30:0.8". A word consists of
// the id, the diameter in mm, and the width of a saw. Returns nothing if the word is not valid.
std::optional<DrillBit> drillBitOf(std::string_view word);
// Returns the word for a drill bit; the inverse of drillBitOf().
std::string wordOf(const DrillBit& bit);

}  // namespace handwheel
