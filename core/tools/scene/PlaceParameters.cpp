// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/scene/PlaceParameters.h"

namespace handwheel {

Parameter wordParameter(const char* id, const char* word, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = ""},
          .meaning = std::move(meaning),
          .word = word,
          .hasDefault = false};
}

Parameter threeNumbers(const char* id, const char* word, std::string meaning, Quantity quantity, double largest) {
  return {.property = {.id = id,
                       .group = {},
                       .label = {},
                       .value = "0,0,0",
                       .quantity = quantity,
                       .least = -largest,
                       .largest = largest},
          .meaning = std::move(meaning),
          .word = word,
          .parts = {{"x"}, {"y"}, {"z"}}};
}

Vec3 vectorIn(const OperationValues& values, std::string_view id) {
  const std::vector<double> numbers = values.numbers(id);
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace handwheel
