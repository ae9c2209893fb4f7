// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Fidelity.h"

#include "base/NumberText.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace handwheel {
namespace {

bool isWhole(const FidelitySetting& setting) {
  return setting.whole || setting.scale == FidelityScale::Choices;
}

}  // namespace

std::string_view wordFor(FidelityPreset preset) {
  switch (preset) {
    case FidelityPreset::Draft:
      return "Draft";
    case FidelityPreset::Balanced:
      return "Balanced";
    case FidelityPreset::Exact:
      break;
  }
  return "Exact";
}

void setChoices(FidelitySetting& setting, std::vector<std::string> words) {
  setting.scale = FidelityScale::Choices;
  setting.least = 0.0;
  setting.largest = static_cast<double>(words.size()) - 1.0;
  setting.choices = std::move(words);
}

Status checkValue(const FidelitySetting& setting, double value) {
  const bool inside = value >= setting.least && value <= setting.largest;  // false for NaN
  if (inside && (!isWhole(setting) || value == std::round(value))) return Done{};
  return Error{ErrorCode::ValueOutOfRange,
               {setting.id, shortestText(value), textOf(setting, setting.least), textOf(setting, setting.largest)},
               {},
               {}};
}

std::string textOf(const FidelitySetting& setting, double value) {
  const bool isChoice = setting.scale == FidelityScale::Choices && value >= 0.0 &&
                        value < static_cast<double>(setting.choices.size()) && value == std::round(value);
  return isChoice ? setting.choices[static_cast<std::size_t>(value)] : shortestText(value);
}

Result<double> valueOf(const FidelitySetting& setting, std::string_view text) {
  const auto word = std::find(setting.choices.begin(), setting.choices.end(), text);
  if (word != setting.choices.end()) return static_cast<double>(word - setting.choices.begin());
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || setting.scale == FidelityScale::Choices) {
    return Error{ErrorCode::NumberMalformed, {std::string(text)}, {}, {}};
  }
  const Status checked = checkValue(setting, value);
  if (!checked) return checked.error();
  return value;
}

double scalePositionOf(const FidelitySetting& setting, double value) {
  if (setting.largest == setting.least) return 0.0;
  if (setting.scale != FidelityScale::Logarithmic) return (value - setting.least) / (setting.largest - setting.least);
  return std::log(value / setting.least) / std::log(setting.largest / setting.least);
}

double valueAt(const FidelitySetting& setting, double position) {
  if (position <= 0.0) return setting.least;
  if (position >= 1.0) return setting.largest;
  const double value = setting.scale == FidelityScale::Logarithmic
                           ? setting.least * std::pow(setting.largest / setting.least, position)
                           : setting.least + position * (setting.largest - setting.least);
  const double taken = isWhole(setting) ? std::round(value) : value;
  return std::clamp(taken, setting.least, setting.largest);
}

double FidelityValues::of(const FidelitySetting& setting) const {
  const auto own = m_overrides.find(setting.id);
  if (own != m_overrides.end()) return own->second;
  return m_preset ? setting.presetValue(*m_preset) : setting.standard;
}

Status FidelityValues::set(const FidelitySetting& setting, double value) {
  Status checked = checkValue(setting, value);
  if (checked) m_overrides[setting.id] = value;
  return checked;
}

}  // namespace handwheel
