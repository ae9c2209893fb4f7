// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/FidelityRegistry.h"

#include <algorithm>
#include <cassert>

namespace handwheel {
namespace {

[[maybe_unused]] bool isSound(const FidelitySetting& s) {
  if (s.id.empty() || s.label.empty() || s.error.name.empty() || s.cost.unit.empty()) return false;
  if (!(s.least < s.largest) || (s.scale == FidelityScale::Logarithmic && !(s.least > 0.0))) return false;
  return checkValue(s, s.standard) &&
         std::all_of(s.presets.begin(), s.presets.end(), [&](double v) { return bool(checkValue(s, v)); });
}

std::string lowered(std::string_view word) {
  std::string text(word);
  text[0] = static_cast<char>(text[0] - 'A' + 'a');  // the words begin with a capital and are ASCII
  return text;
}

}  // namespace

void FidelityRegistry::add(FidelitySetting setting, std::vector<FidelityCase> cases) {
  assert(isSound(setting));
  assert(!find(setting.id));
  m_entries.push_back({std::move(setting), std::move(cases)});
}

const FidelityRegistry::Entry* FidelityRegistry::find(std::string_view id) const {
  const auto at = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.setting.id == id; });
  return at == m_entries.end() ? nullptr : &*at;
}

Result<FidelityValues> readValues(const FidelityRegistry& registry, std::string_view text) {
  FidelityValues values;
  for (bool isFirst = true; !text.empty(); isFirst = false) {
    const std::string_view word = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const auto preset = std::find_if(kFidelityPresets.begin(), kFidelityPresets.end(),
                                     [&](FidelityPreset p) { return lowered(wordFor(p)) == word; });
    if (isFirst && preset != kFidelityPresets.end()) {
      values = FidelityValues(*preset);
      continue;
    }
    const std::size_t equals = std::min(word.find('='), word.size());
    const FidelityRegistry::Entry* entry = registry.find(word.substr(0, equals));
    if (!entry) return Error{ErrorCode::ReferenceMissing, {"the setting", std::string(word.substr(0, equals))}, {}, {}};
    const Result<double> value = valueOf(entry->setting, word.substr(std::min(equals + 1, word.size())));
    if (!value) return value.error();
    const Status set = values.set(entry->setting, *value);
    if (!set) return set.error();
  }
  return values;
}

std::string textOf(const FidelityRegistry& registry, const FidelityValues& values) {
  std::string text = values.preset() ? lowered(wordFor(*values.preset())) : std::string();
  for (const auto& [id, value] : values.overrides()) {
    const FidelityRegistry::Entry* entry = registry.find(id);
    if (entry) text += (text.empty() ? "" : ",") + id + "=" + textOf(entry->setting, value);
  }
  return text;
}

}  // namespace handwheel
