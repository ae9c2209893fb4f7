// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"
#include "document/OperationText.h"
#include "mesh/selection/FaceSelection.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace handwheel {

// Writes an edit of a document as a line of text (a step). A step is a verb, operands, and options "--name value",
// separated by blanks. Lists are separated by commas without blanks: "delete 1-20,33", "place --move 0,0,5". Numbers
// are written with the fewest digits that read back as the same, in any locale.
class ScriptLineWriter {
 public:
  explicit ScriptLineWriter(std::string_view verb) : m_text(verb) {}

  ScriptLineWriter& word(std::string_view word);
  // Adds the options that differ from the defaults.
  ScriptLineWriter& options(const OperationValues& values);
  const std::string& text() const { return m_text; }

 private:
  std::string m_text;
};

std::string listText(const std::vector<std::uint32_t>& numbers);                           // "1,5,7"
std::string rangesText(const FaceSelection& faces);                                        // "1-20,33"
std::string pairsText(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);  // "1:5,7:9"
std::string pointText(const Vec3& p);                                                      // "0,0,5"

// Parses an untrusted line of text as a step. A requested value that is missing or out of bounds is recorded as a
// problem, and the value returned for it is meaningless. Only the first problem is kept.
class ScriptLineReader {
 public:
  explicit ScriptLineReader(std::string_view text);

  const std::string& verb() const { return m_verb; }
  bool isGood() const { return m_problem.empty(); }
  void complain(std::string problem);
  // Returns the status of the whole line. Error: ScriptError::Malformed if there is a problem, including operands and
  // options that were not requested.
  Status status() const;

  bool hasWord() const { return m_next < m_words.size(); }
  std::string word(const char* what);  // returns the next operand
  std::string line(const char* what);  // returns the text after the verb, verbatim

  // Returns all options of the operation. Options that are not given have their default values.
  OperationValues values(const Operation& operation);

  // Returns an index. what: the noun for the message, such as "triangle"; count: the index must be less than this
  // number.
  std::uint32_t index(std::string_view word, const char* what, std::size_t count);
  std::vector<std::uint32_t> indices(std::string_view list, const char* what, std::size_t count);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(std::string_view list, const char* what,
                                                             std::size_t count);
  // slots: number of face slots of the mesh; the caller must remove faces that no longer exist.
  FaceSelection faces(std::string_view ranges, std::size_t slots);
  Vec3 point(std::string_view word);  // mm

 private:
  struct Option {
    std::string name;
    std::optional<std::string> value;
    bool isUsed = false;
  };
  Option* find(std::string_view name);
  double number(std::string_view word);

  std::string m_verb;
  std::string m_line;
  std::vector<std::string> m_words;
  std::vector<Option> m_options;
  std::size_t m_next = 0;
  std::string m_problem;
};

}  // namespace handwheel
