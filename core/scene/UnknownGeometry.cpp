// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/UnknownGeometry.h"

namespace handwheel {

std::size_t UnknownGeometry::bytes() const {
  std::size_t sum = m_kind.size() + m_description.size();
  for (const auto& [name, part] : m_parts) sum += name.size() + part.size();
  return sum;
}

}  // namespace handwheel
