// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/KeptLines.h"

#include "robot/posts/PostText.h"

#include <algorithm>

namespace handwheel {

void KeptLines::keep(ProgramLine::Kind kind, std::string_view text, std::size_t line, bool mayGrip) {
  keep(keptLine(kind, text, line, mayGrip));
}

Result<std::vector<ParsedMotion>> KeptLines::take() {
  if (m_motions.empty()) return std::vector<ParsedMotion>();
  ParsedMotion& first = m_motions.front();
  first.before = std::move(m_before);
  first.leftOut = std::move(m_leftOut);
  std::ranges::sort(first.leftOut);
  first.leftOut.erase(std::ranges::unique(first.leftOut).begin(), first.leftOut.end());
  const auto tooLong = [](const std::vector<ProgramLine>& lines) { return lines.size() > ProgramLine::kMost; };
  const auto refused = [](const std::vector<ProgramLine>& lines) {
    return LineReader({}, lines[ProgramLine::kMost].line).malformed("lines", "there are too many without a motion");
  };
  if (tooLong(first.before)) return refused(first.before);
  for (const ParsedMotion& motion : m_motions) {
    if (tooLong(motion.lines)) return refused(motion.lines);
  }
  return std::move(m_motions);
}

}  // namespace handwheel
