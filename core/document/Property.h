// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace handwheel {

// Value of a property: a number, a switch or a text. A choice is a number, the index of the choice.
using PropertyValue = std::variant<double, bool, std::string>;

// A named value of a document or a tool. The Properties panel, the tool settings and the command line show it.
struct Property {
  std::string id;     // for files, tests and the command line; never changes: "diameter"
  std::string group;  // English heading, translated for display (context "Property"): "Stock"
  std::string label;  // English, translated like the group: "Diameter"
  PropertyValue value;
  Quantity quantity = Quantity::Number;
  double least = -std::numeric_limits<double>::infinity();  // mm, rad
  double largest = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {};  // English, translated for display
  bool editable = true;
  bool translated = true;       // false: the label is a name from the file
  bool groupTranslated = true;  // false: the group is a name from the file
  std::string prefix = {};      // shown before the number: "⌀", "R"
  std::string problem = {};     // English, context "Property": a remark on the value ("effort is not known")
  bool continuous = false;      // shown with a slider between the limits; for a choice: with a list of all choices
  bool isNumbers = false;       // a text of numbers with decimal points; users see and type them in their own format
};

}  // namespace handwheel
