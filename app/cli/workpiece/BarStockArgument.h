// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/StockCylinder.h"

#include <optional>
#include <string>

namespace handwheel {

// A bar as an argument of the command line, such as "cylinder:40x100". The example is a bar of 40 mm diameter and 100
// mm length, whose upper end is at z = 0.
struct BarStockArgument {
  std::optional<StockCylinder> bar;
  std::string problem;  // sentence about an invalid bar; empty: no problem
};

// Reads a word as a bar. Returns neither a bar nor a problem for words that do not begin with "cylinder:".
BarStockArgument readBar(const std::string& word);

}  // namespace handwheel
