// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/SharedParameters.h"

#include "base/Tolerance.h"

#include <QtGlobal>
#include <cstdint>
#include <limits>

namespace handwheel {

Parameter flagParameter(const char* id, std::string meaning, const char* label) {
  return {.property = {.id = id, .group = {}, .label = label, .value = false}, .meaning = std::move(meaning)};
}

Parameter countParameter(const char* id, const char* word, std::string meaning, const char* label) {
  constexpr double kMost = std::numeric_limits<std::uint32_t>::max();
  return {.property = {.id = id, .group = {}, .label = label, .value = 0.0, .least = 0.0, .largest = kMost},
          .meaning = std::move(meaning),
          .word = word,
          .isWhole = true};
}

Parameter textParameter(const char* id, const char* word, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = ""},
          .meaning = std::move(meaning),
          .word = word,
          .hasDefault = false};
}

Parameter pointParameter(const char* id, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = "", .quantity = Quantity::Length},
          .meaning = std::move(meaning),
          .word = "X,Y,Z",
          .parts = {{"x"}, {"y"}, {"z"}},
          .hasDefault = false};
}

Parameter thicknessParameter() {
  return {
      .property = {.id = "thickness",
                   .group = {},
                   .label = QT_TRANSLATE_NOOP("Property", "Thickness"),
                   .value = 0.0,
                   .quantity = Quantity::Length,
                   .least = 1e-9,
                   .largest = 1e9},
      .meaning =
          "Thickness of thickened sheets, in mm, less where the sheet bends more or the part is nearer; it grows to "
          "the side opposite to the normals. Default: a thousandth of the model's diagonal",
      .word = "MM",
      .hasDefault = false};
}

Parameter nearWeldParameter(double standard) {
  return {.property = {.id = "near-weld", .group = {}, .label = {}, .value = standard, .least = 0.0, .largest = 1.0},
          .meaning = "Merge vertices of open edges that are nearer than this share of the diagonal",
          .word = "SHARE"};
}

}  // namespace handwheel
