// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramSetup.h"

#include "base/NumberText.h"
#include "machining/program/ProgramErrors.h"

#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr std::size_t kMostTools = 1000;
constexpr std::string_view kTurnedOver = "upside-down";  // in a comment
constexpr const char* kToolRemedy = "Write a line as T1 P1 X0 Z0 D0.8 Q2.";

// Reads the next word of a tool line; returns false at its end.
bool nextWord(std::string_view line, std::size_t& at, char& letter, double& number, const SourceLocation& start) {
  while (at < line.size() && (line[at] == ' ' || line[at] == '\t' || line[at] == '\r')) ++at;
  if (at == line.size() || line[at] == ';') return false;
  const std::size_t begin = at;
  letter = line[at++];
  while (at < line.size() && (isDigit(line[at]) || line[at] == '+' || line[at] == '-' || line[at] == '.')) ++at;
  ErrorCode why;
  // D0,8 is not D0 and another word
  if (!isLetter(letter) || !parseDecimal(line.substr(begin + 1, at - begin - 1), number, why) ||
      !std::isfinite(number) || std::abs(number) > 1e6)
    refuse({start.line, static_cast<std::uint32_t>(begin + 1)}, std::string(line.substr(begin, at - begin + 1)),
           "this is not a word of a tool table", kToolRemedy);
  return true;
}

// Returns the first word of the comment of a line; empty: none.
std::string_view commentWord(std::string_view line) {
  const std::size_t mark = line.find(';');
  if (mark == std::string_view::npos) return {};
  std::string_view comment = line.substr(mark + 1);
  comment.remove_prefix(std::min(comment.find_first_not_of(" \t"), comment.size()));
  return comment.substr(0, comment.find_first_of(" \t\r"));
}

// Returns the number of letters to change, add or leave out to make one word of the other.
std::size_t lettersBetween(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t other = std::min(row[j], row[j + 1]) + 1;
      diagonal = std::exchange(row[j + 1], std::min(other, diagonal + (a[i] == b[j] ? 0 : 1)));
    }
  }
  return row.back();
}

// Returns the tool whose id a word nearly is; null: it is not like an id.
std::shared_ptr<const LatheTool> nearlyNamed(std::string_view word, const LatheTools& bodies) {
  constexpr std::size_t kLongestWord = 40, kLeastWord = 5;
  if (word.size() < kLeastWord || word.size() > kLongestWord || word == kTurnedOver) return nullptr;
  std::string id(word);
  for (char& c : id) c = c == '_' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  std::size_t least = id.find('-') == std::string::npos ? 2 : 3;  // letters that make another word of it
  std::shared_ptr<const LatheTool> nearest;
  for (const auto& body : bodies) {
    const std::size_t letters = lettersBetween(id, body->id);
    if (letters >= least) continue;
    least = letters;
    nearest = body;
  }
  return nearest;
}

void readToolLine(std::string_view line, std::uint32_t number, ProgramTools& tools, const LatheTools& bodies,
                  ProgramDialect dialect, std::vector<ToolPath::Note>* notes) {
  ProgramTool tool;
  const std::string_view word = commentWord(line);
  if (auto body = toolNamed(bodies, word)) {
    tool = programToolOf(std::move(body), dialect);
  } else if (const auto nearest = notes ? nearlyNamed(word, bodies) : nullptr) {
    notes->push_back({number, "'" + std::string(word) +
                                  "' is no tool of the lathe, so only the nose of this one is known. "
                                  "Write " +
                                  nearest->id + " if that is meant."});
  }
  int name = -1;
  std::size_t at = 0;
  char letter = 0;
  double value = 0.0;
  bool isAny = false;
  while (nextWord(line, at, letter, value, {number, 1})) {
    isAny = true;
    switch (letter) {
      case 'T':
      case 't':
        name = static_cast<int>(value);
        break;
      case 'D':
      case 'd':
        tool.noseRadius = 0.5 * std::abs(value);
        break;
      case 'X':
      case 'x':
        tool.offset.x() = value;
        break;
      case 'Z':
      case 'z':
        tool.offset.y() = value;
        break;
      case 'Q':
      case 'q':
        tool.orientation = static_cast<int>(value);
        break;
      default:
        break;  // pocket, angles of the edges
    }
  }
  if (!isAny) return;
  const std::size_t comment = std::min(line.find(';'), line.size());
  tool.isTurnedOver = line.find(kTurnedOver, comment) != std::string_view::npos;
  if (name < 0 || tools.size() >= kMostTools)
    refuse({number, 1}, "T", name < 0 ? "the line has no tool number" : "there are too many tools", kToolRemedy);
  tools[name] = tool;
}

}  // namespace

ProfilePoint tipDirection(ProgramDialect dialect, int orientation) {
  // The positions of the point by LinuxCNC's numbers; Fanuc counts 1 to 4 and 5 to 8 from the other side (system A,
  // tool behind).
  static const ProfilePoint kLinuxCnc[10] = {{0, 0}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1},
                                             {0, 1}, {-1, 0}, {0, -1},  {1, 0},  {0, 0}};
  static const ProfilePoint kFanuc[10] = {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1},
                                          {0, 1}, {1, 0}, {0, -1}, {-1, 0},  {0, 0}};
  if (orientation < 0 || orientation > 9) return {0, 0};
  return dialect == ProgramDialect::Fanuc ? kFanuc[orientation] : kLinuxCnc[orientation];
}

int outsideOrientation(ProgramDialect dialect) {
  return dialect == ProgramDialect::Fanuc ? 3 : 2;
}

int boreOrientation(ProgramDialect dialect) {
  return dialect == ProgramDialect::Fanuc ? 2 : 3;
}

// Tools have the numbers of ISO, which are those of Fanuc.
int orientationOf(const LatheTool& tool, ProgramDialect dialect) {
  const ProfilePoint direction = tipDirection(ProgramDialect::Fanuc, tool.orientation);
  for (int i = 1; i <= 9; ++i)
    if (tipDirection(dialect, i) == direction) return i;
  return 0;
}

ProgramTool programToolOf(std::shared_ptr<const LatheTool> tool, ProgramDialect dialect) {
  ProgramTool made;
  made.noseRadius = tool->kind == LatheToolKind::Drill ? tool->reach() : tool->noseRadius;
  made.orientation = orientationOf(*tool, dialect);
  made.body = std::move(tool);
  return made;
}

ProgramTools inDialect(ProgramTools tools, ProgramDialect from, ProgramDialect to) {
  if (from == to) return tools;
  for (auto& [number, tool] : tools) {
    const ProfilePoint direction = tipDirection(from, tool.orientation);
    for (int i = 1; i <= 9 && !direction.isZero(); ++i)
      if (tipDirection(to, i) == direction) tool.orientation = i;
  }
  return tools;
}

ProgramSetup usualSetup(ProgramDialect dialect, const StockCylinder& stock, double grip, double nose,
                        double allowance) {
  constexpr double kHomeDistance = 100.0;  // mm, distance of machine zero from the corner of the bar
  ProgramSetup setup;
  setup.dialect = dialect;
  setup.standard = {nose, outsideOrientation(dialect), {0, 0}};
  setup.grip = grip;
  setup.allowance = allowance;
  setup.reference = {0.5 * stock.diameter + kHomeDistance, allowance + kHomeDistance};
  return setup;
}

const ProgramTool& ProgramSetup::tool(int number) const {
  const auto found = tools.find(number);
  return found == tools.end() ? standard : found->second;
}

Result<ProgramTools> readToolTable(std::string_view text, const LatheTools& bodies, ProgramDialect dialect,
                                   std::vector<ToolPath::Note>* notes) {
  ProgramTools tools;
  try {
    for (std::uint32_t line = 1; !text.empty(); ++line) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      readToolLine(text.substr(0, end), line, tools, bodies, dialect, notes);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
  return tools;
}

std::string toolTableText(const ProgramTools& tools) {
  std::string text;
  for (const auto& [number, tool] : tools) {
    const std::string name = std::to_string(number);
    text.append("T").append(name).append(" P").append(name);
    text.append(" X").append(shortestText(tool.offset.x())).append(" Z").append(shortestText(tool.offset.y()));
    text.append(" D").append(shortestText(2.0 * tool.noseRadius)).append(" Q");
    text.append(std::to_string(tool.orientation));
    if (tool.body || tool.isTurnedOver) text += " ;";
    if (tool.body) text += tool.body->id;
    if (tool.body && tool.isTurnedOver) text += ' ';
    if (tool.isTurnedOver) text += kTurnedOver;
    text += '\n';
  }
  return text;
}

}  // namespace handwheel
