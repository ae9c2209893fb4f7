// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/OperationText.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace handwheel {
namespace {

constexpr std::size_t kLongestWord = 40;  // characters of a word that a clause repeats
constexpr double kNoLimit = 1e9;          // larger bounds are not worth mentioning

std::string numberText(const Parameter& parameter, double value) {
  return parameter.property.quantity == Quantity::Angle ? angleText(value) : shortestText(value);
}

std::optional<double> numberIn(const Parameter& parameter, std::string_view word) {
  double unit = 1.0;
  if (parameter.property.quantity == Quantity::Angle) {
    const bool isRadian = word.ends_with("rad");
    if (isRadian || word.ends_with("deg")) word.remove_suffix(3);
    if (!isRadian) unit = kRadiansPerDegree;
  }
  double value = 0.0;
  ErrorCode why{};
  if (!parseDecimal(word, value, why) || !std::isfinite(value)) return std::nullopt;
  return value * unit;
}

// Returns the value of a word, which may be out of range.
std::optional<PropertyValue> valueIn(const Parameter& parameter, std::string_view word) {
  if (parameter.isFlag()) return true;
  if (std::holds_alternative<std::string>(parameter.property.value)) return std::string(word);
  if (parameter.words.empty()) return numberIn(parameter, word);
  const auto known = std::find(parameter.words.begin(), parameter.words.end(), word);
  if (known == parameter.words.end()) return std::nullopt;
  return static_cast<double>(known - parameter.words.begin());
}

// Converts a value to the unit of its words.
double inWords(const Parameter& parameter, double value) {
  return parameter.property.quantity == Quantity::Angle ? value / kRadiansPerDegree : value;
}

// Formats a bound for users: without an exponent if possible.
std::string boundText(const Parameter& parameter, double value) {
  return shownText(inWords(parameter, value));
}

// Formats a default with three digits: computed defaults, such as the root of two, have no last digit.
std::string defaultText(const Parameter& parameter, double value) {
  const double shown = inWords(parameter, value);
  if (parameter.isWhole || shown == 0.0) return shownText(shown);
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(shown))) - 2.0);
  return shownText(digit * std::round(shown / digit));
}

std::string rangeText(const Parameter& parameter) {
  const Property& p = parameter.property;
  return boundText(parameter, p.least) + " to " + boundText(parameter, p.largest);
}

// Returns "a length from 0 to 5 mm".
std::string numberWanted(const Parameter& parameter) {
  const Property& p = parameter.property;
  const bool isLength = p.quantity == Quantity::Length, isAngle = p.quantity == Quantity::Angle;
  std::string text = isLength ? "a length" : isAngle ? "an angle" : parameter.isWhole ? "a whole number" : "a number";
  if (std::isfinite(p.least) && std::isfinite(p.largest)) text += " from " + rangeText(parameter);
  return text + (isLength ? " mm" : isAngle ? " degrees" : "");
}

std::string wanted(const Parameter& parameter) {
  if (parameter.isFlag()) return "no value";
  if (!parameter.words.empty()) return choicesText(parameter.words);
  if (!parameter.parts.empty()) return parameter.word + ", each " + numberWanted(parameter);
  return std::holds_alternative<double>(parameter.property.value) ? numberWanted(parameter) : parameter.word;
}

std::string optionSyntax(const Parameter& parameter) {
  return "--" + parameter.id() + (parameter.word.empty() ? "" : " " + parameter.word);
}

}  // namespace

// One of the quotient and its neighbours nearly always converts back to the angle exactly, and the shortest is the
// intended one.
std::string angleText(double radian) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double degrees = radian / kRadiansPerDegree;
  std::string best;
  for (const double candidate : {degrees, std::nextafter(degrees, kInfinity), std::nextafter(degrees, -kInfinity)}) {
    if (candidate * kRadiansPerDegree != radian) continue;
    const std::string text = shortestText(candidate);
    if (best.empty() || text.size() < best.size()) best = text;
  }
  return best.empty() ? shortestText(radian) + "rad" : best;
}

std::vector<std::string_view> parted(std::string_view list, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = list.find(separator);
    parts.push_back(list.substr(0, end));
    if (end == std::string_view::npos) return parts;
    list.remove_prefix(end + 1);
  }
}

std::string textOf(const Parameter& parameter, const PropertyValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (std::holds_alternative<bool>(value)) return {};
  const double number = std::get<double>(value);
  const bool isChoice = number >= 0.0 && number < static_cast<double>(parameter.words.size());
  return isChoice ? parameter.words[static_cast<std::size_t>(number)] : numberText(parameter, number);
}

std::string readWord(OperationValues& values, const Parameter& parameter, std::string_view word) {
  if (parameter.isFlag() && !word.empty()) return "--" + parameter.id() + " takes no value";
  const auto value = valueIn(parameter, word);
  return value && values.set(parameter.id(), *value).empty() ? std::string() : refusal(parameter, word);
}

std::string listText(const Parameter& parameter, const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ",") + numberText(parameter, number);
  return text;
}

std::optional<std::vector<double>> numbersIn(const Parameter& parameter, std::string_view list) {
  std::vector<double> numbers;
  for (const std::string_view part : parted(list, ',')) {
    const auto number = numberIn(parameter, part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<std::pair<std::string, std::string>> writtenOptions(const OperationValues& values) {
  std::vector<std::pair<std::string, std::string>> options;
  for (const Parameter& parameter : values.operation().parameters) {
    if (!values.isSet(parameter.id()) && !(parameter.isAlwaysWritten && parameter.hasDefault)) continue;
    options.emplace_back(parameter.id(), textOf(parameter, *values.value(parameter.id())));
  }
  return options;
}

std::string optionLine(const OperationValues& values) {
  std::string line;
  for (const auto& [name, word] : writtenOptions(values))
    line += (line.empty() ? "--" : " --") + name + (word.empty() ? "" : " " + word);
  return line;
}

std::string refusal(const Parameter& parameter, std::string_view word) {
  return "--" + parameter.id() + " takes " + wanted(parameter) + ", not '" + std::string(word.substr(0, kLongestWord)) +
         (word.size() > kLongestWord ? "…'" : "'");
}

std::string choicesText(const std::vector<std::string>& words) {
  std::string all;
  for (std::size_t i = 0; i < words.size(); ++i)
    all += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return all;
}

std::string syntaxOf(const Operation& operation) {
  std::string line = operation.id + (operation.operands.empty() ? "" : " " + operation.operands);
  std::set<std::string> bundles;
  for (const Parameter& parameter : operation.parameters) {
    if (parameter.bundle.empty()) {
      line += " [" + optionSyntax(parameter) + "]";
    } else if (bundles.insert(parameter.bundle).second) {
      line += " [" + parameter.bundle + "]";
    }
  }
  return line;
}

std::string helpOf(const Parameter& parameter) {
  const Property& p = parameter.property;
  if (!parameter.words.empty()) {
    std::vector<std::string> words = parameter.words;
    if (parameter.hasDefault) words[static_cast<std::size_t>(std::get<double>(p.value))] += " (default)";
    return parameter.meaning + ": " + choicesText(words);
  }
  const auto* standard = std::get_if<double>(&p.value);
  std::string about;
  if (standard && std::abs(p.least) < kNoLimit && std::abs(p.largest) < kNoLimit) about = rangeText(parameter);
  if (standard && parameter.hasDefault)
    about += (about.empty() ? "default " : ", default ") + defaultText(parameter, *standard);
  return about.empty() ? parameter.meaning : parameter.meaning + " (" + about + ")";
}

}  // namespace handwheel
