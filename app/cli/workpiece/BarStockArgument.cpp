// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/BarStockArgument.h"

#include "base/NumberText.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr std::string_view kCylinder = "cylinder:";

// Reads a size. Returns a problem of the text, or an empty string.
std::string readSize(const char* name, std::string_view text, double& value) {
  ErrorCode why;
  const std::string what = std::string("The ") + name + " of the bar ";
  if (text.empty()) return what + "is missing: give diameter and length in mm, such as cylinder:40x100.";
  const bool isNumber = parseDecimal(text, value, why);
  if (!isNumber && why != ErrorCode::NumberNotFinite)
    return what + "is not a number: " + std::string(text) + ". Write it with a point, such as 40.5.";
  if (isNumber && (std::isnan(value) || value <= 0.0)) return what + "has to be above 0.";
  if (!isNumber || value > StockCylinder::kLargestSize)
    return what + "has to be at most " + shortestText(StockCylinder::kLargestSize) + " mm.";
  if (value < StockCylinder::kLeastSize)
    return what + "has to be at least " + shortestText(StockCylinder::kLeastSize) + " mm.";
  return {};
}

}  // namespace

BarStockArgument readBar(const std::string& word) {
  if (!word.starts_with(kCylinder)) return {};
  const std::string_view size = std::string_view(word).substr(kCylinder.size());
  const std::size_t times = size.find('x');
  if (times == std::string_view::npos)
    return {{},
            "A bar needs diameter and length with an x between them, such as cylinder:40x100; " + word + " has none."};
  StockCylinder bar;
  std::string problem = readSize("diameter", size.substr(0, times), bar.diameter);
  if (problem.empty()) problem = readSize("length", size.substr(times + 1), bar.length);
  if (!problem.empty()) return {{}, std::move(problem)};
  bar.position = -bar.length;
  return {bar, {}};
}

}  // namespace handwheel
