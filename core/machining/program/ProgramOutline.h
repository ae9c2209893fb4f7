// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramScanner.h"
#include "machining/program/ProgramSetup.h"

#include <map>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace handwheel {

// The structure of a program, which is read before the program runs. It consists of lines, O words, loops and line
// numbers. It refers to the text of the program, which must outlive it.
class ProgramOutline {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20, kMostLines = 2'000'000, kLongestLine = 4096;
  static constexpr std::uint32_t kNone = 0xffffffffu;
  enum class Keyword {
    Sub,
    EndSub,
    Call,
    Return,
    If,
    ElseIf,
    Else,
    EndIf,
    While,
    EndWhile,
    Do,
    DoWhile,
    Repeat,
    EndRepeat,
    Break,
    Continue,
    Program,  // program number of Fanuc
    FanucWhile,
    FanucEnd
  };

  // A line with an O word, or a loop of Fanuc. Lines count from 0.
  struct Statement {
    Keyword keyword;
    std::string label;
    std::size_t rest = 0;        // index of the byte after the keyword
    std::uint32_t head = kNone;  // first line of the loop or condition
    std::uint32_t next = kNone;  // next branch of a condition
    std::uint32_t end = kNone;   // last line of the loop or condition
  };

  // Reads the structure of a text. Throws ProgramRefusal if the structure is wrong or the text is too large.
  ProgramOutline(std::string_view text, ProgramDialect dialect);

  std::uint32_t size() const { return static_cast<std::uint32_t>(m_lines.size()); }
  std::string_view line(std::uint32_t i) const { return m_lines[i]; }
  const Statement* statement(std::uint32_t i) const;

  // Returns the first line of a subprogram, or kNone if there is no such subprogram.
  std::uint32_t subprogram(const std::string& label) const;
  // Returns the first line from `from` on that has this N number, or else the first line that has it, or kNone. In a
  // Fanuc file with several programs, only the program that contains `from` is searched.
  std::uint32_t numbered(int n, std::uint32_t from) const;

 private:
  void split(std::string_view text, ProgramDialect dialect);
  void readLine(std::uint32_t i, ProgramDialect dialect);
  void readO(ProgramScanner& scanner, std::uint32_t i, ProgramDialect dialect);
  void readFanucLoop(ProgramScanner& scanner, std::uint32_t i);
  void link();
  void close(std::uint32_t i, Statement& statement);
  Statement& add(std::uint32_t i, Keyword keyword, std::string label, std::size_t rest);

  std::vector<std::string_view> m_lines;
  std::map<std::uint32_t, Statement> m_statements;
  std::map<std::string, std::uint32_t> m_subs;
  std::unordered_map<int, std::vector<std::uint32_t>> m_numbered;
  std::vector<std::uint32_t> m_programs;                     // lines of Fanuc's O numbers, in ascending order
  std::map<std::string, std::vector<std::uint32_t>> m_open;  // open statements of each label, while linking
};

}  // namespace handwheel
