// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace handwheel {

// The first word of an OFF file, which defines the attributes of vertices. [ST][C][N][4][n]OFF (Geomview manual, "OFF
// files").
struct OffKeyword {
  bool texture = false;         // two numbers after each vertex
  bool colour = false;          // in binary files four numbers
  bool normal = false;          // three numbers
  bool otherDimension = false;  // 4OFF, nOFF: no points in space
  std::size_t length = 0;       // characters; a count may follow without a blank

  bool hasAttributes() const { return texture || colour || normal; }
};

// Parses the first word of an OFF file. Returns none if it is not a keyword.
std::optional<OffKeyword> parseOffKeyword(std::string_view word);

// Returns true if the first word outside comments is the keyword.
bool beginsWithOffKeyword(std::string_view bytes);

}  // namespace handwheel
