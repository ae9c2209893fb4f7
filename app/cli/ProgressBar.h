// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handwheel {

// A line on stderr that grows; nothing when stderr is no terminal. It appears only for work that takes a while.
class ProgressBar {
 public:
  explicit ProgressBar(std::string_view label);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double fraction);  // 0…1
  void clear();

 private:
  std::string m_label;
  std::string m_shown;
  bool m_isTerminal;
};

}  // namespace handwheel
