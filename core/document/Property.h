// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace handwheel {

// Value of a property: number, switch, or text. For a choice, its index as a number.
using PropertyValue = std::variant<double, bool, std::string>;

// A named value of a document or a tool. The Properties panel, the tool settings and the command line show it.
struct Property {
  std::string id;     // stable, for files, tests and the command line: "diameter"
  std::string group;  // English heading, translated for display (context "Property"): "Stock"
  std::string label;  // English, likewise translated: "Diameter"
  PropertyValue value;
  Quantity quantity = Quantity::Number;
  double least = -std::numeric_limits<double>::infinity();  // mm, radian
  double largest = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {};  // English, translated for display
  bool editable = true;
  bool translated = true;       // false: the label is a name from the file
  bool groupTranslated = true;  // false: the group is
  std::string prefix = {};      // shown before the number: "⌀", "R"
  std::string problem = {};     // English, context "Property": a remark on the value ("effort is not known")
  bool continuous = false;      // best changed with a slider between its limits; for a choice: with a list of all
  bool isNumbers = false;       // a text of numbers with decimal points, which users see and type in their own format
};

}  // namespace handwheel
