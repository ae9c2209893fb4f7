// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace handwheel {

// The first word of an OFF file, which defines the attributes of vertices. Its syntax is [ST][C][N][4][n]OFF (Geomview
// manual, "OFF files"). Programs write ST, C and N in other orders, too, as MeshLab's NCOFF.
struct OffKeyword {
  bool texture = false;         // two numbers after each vertex
  bool colour = false;          // a colour after each vertex: four numbers in binary files
  bool normal = false;          // three numbers after each vertex
  bool otherDimension = false;  // 4OFF or nOFF: the vertices are not points in space
  std::size_t length = 0;       // number of characters; a count may follow without a blank

  bool hasAttributes() const { return texture || colour || normal; }
};

// Parses the first word of an OFF file. Returns nothing if the word is not a keyword.
std::optional<OffKeyword> parseOffKeyword(std::string_view word);

// Returns true if the first word outside comments is a keyword of OFF files.
bool beginsWithOffKeyword(std::string_view bytes);

}  // namespace handwheel
