// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ProgressBar.h"

#include "base/JobClock.h"

#include <unistd.h>
#include <algorithm>
#include <cstdio>

namespace handwheel {

ProgressBar::ProgressBar(std::string_view label) : m_label(label), m_isTerminal(::isatty(STDERR_FILENO) != 0) {}

void ProgressBar::show(double fraction, int seconds) {
  if (!m_isTerminal) return;
  constexpr int kWidth = 30;
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kWidth);
  // One decimal, so that long jobs visibly progress.
  const int tenths = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 1000.0);
  const std::string number = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  const std::string line = m_label + " [" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] " +
                           std::string(5 - number.size(), ' ') + number + " %  " + elapsedText(seconds);
  if (line == m_shown) return;
  std::fprintf(stderr, "\r%s", line.c_str());
  std::fflush(stderr);
  m_shown = line;
}

void ProgressBar::clear() {
  if (m_shown.empty()) return;
  std::fprintf(stderr, "\r%s\r", std::string(m_shown.size(), ' ').c_str());
  std::fflush(stderr);
  m_shown.clear();
}

}  // namespace handwheel
