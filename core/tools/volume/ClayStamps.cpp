// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ClayStamps.h"

#include <QtGlobal>
#include <algorithm>
#include <cassert>

namespace handwheel {
namespace {

constexpr std::array<const char*, 1 + kBuiltInStamps> kStampNames = {
    QT_TRANSLATE_NOOP("Property", "None"),    QT_TRANSLATE_NOOP("Property", "Dome"),
    QT_TRANSLATE_NOOP("Property", "Pyramid"), QT_TRANSLATE_NOOP("Property", "Ring"),
    QT_TRANSLATE_NOOP("Property", "Ridges"),  QT_TRANSLATE_NOOP("Property", "Pebbles"),
    QT_TRANSLATE_NOOP("Property", "Scales")};

}  // namespace

std::vector<std::string> ClayStamps::names() const {
  std::vector<std::string> names(kStampNames.begin(), kStampNames.end());
  for (const Loaded& loaded : m_loaded) names.push_back(loaded.name);
  return names;
}

std::shared_ptr<const ClayStamp> ClayStamps::at(std::size_t number) const {
  assert(number < count());
  if (number == 0) return nullptr;
  if (number > kBuiltInStamps) return m_loaded[number - 1 - kBuiltInStamps].stamp;
  std::shared_ptr<const ClayStamp>& made = m_builtIn[number - 1];
  if (!made) made = builtInStamp(static_cast<BuiltInStamp>(number - 1));
  return made;
}

std::size_t ClayStamps::add(const std::string& name, std::shared_ptr<const ClayStamp> stamp) {
  const auto known = std::find_if(m_loaded.begin(), m_loaded.end(), [&](const Loaded& l) { return l.name == name; });
  const auto number = 1 + kBuiltInStamps + static_cast<std::size_t>(known - m_loaded.begin());
  if (known != m_loaded.end()) {
    known->stamp = std::move(stamp);
  } else {
    m_loaded.push_back({name, std::move(stamp)});
  }
  return number;
}

}  // namespace handwheel
