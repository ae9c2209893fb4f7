// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handwheel {

// A progress bar on one line of stderr. It shows nothing if stderr is not a terminal, and appears only for work that
// takes a while.
class ProgressBar {
 public:
  explicit ProgressBar(std::string_view label);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // Draws the bar. fraction: the completed part of the work, 0…1. seconds: the elapsed time of the work.
  void show(double fraction, int seconds);
  void clear();

 private:
  std::string m_label;
  std::string m_shown;
  bool m_isTerminal;
};

}  // namespace handwheel
