// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tbb {

template <class Value>
class blocked_range {
 public:
  blocked_range(Value begin, Value end, Value grain = 1) : m_begin(begin), m_end(end), m_grain(grain) {}

  Value begin() const { return m_begin; }
  Value end() const { return m_end; }
  Value grainsize() const { return m_grain; }
  Value size() const { return m_end - m_begin; }

 private:
  Value m_begin, m_end, m_grain;
};

}  // namespace tbb
