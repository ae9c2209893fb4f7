// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/PostProcessor.h"

namespace handwheel {

// Collects the motions of a program that is read, and the lines between them.
class KeptLines {
 public:
  void add(ParsedMotion motion) { m_motions.push_back(std::move(motion)); }
  // Keeps a line after the last motion, or before the first one.
  void keep(ProgramLine line) { (m_motions.empty() ? m_before : m_motions.back().lines).push_back(std::move(line)); }
  void keep(ProgramLine::Kind kind, std::string_view text, std::size_t line, bool mayGrip = false);
  // Notes a line of which something is read, and not kept.
  void leaveOut(std::size_t line) { m_leftOut.push_back(line); }

  std::vector<ParsedMotion>& motions() { return m_motions; }
  std::vector<ProgramLine>& before() { return m_before; }  // the lines before the first motion
  bool isFull() const { return m_motions.size() >= PostProcessor::kMostMotions; }
  // Returns the motions with their lines. Errors: ElementMalformed, if more than ProgramLine::kMost lines follow each
  // other.
  Result<std::vector<ParsedMotion>> take();

 private:
  std::vector<ParsedMotion> m_motions;
  std::vector<ProgramLine> m_before;
  std::vector<std::size_t> m_leftOut;
};

}  // namespace handwheel
