// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/RepairMethodTable.h"

#include "base/NumberText.h"

#include <QString>
#include <algorithm>
#include <array>
#include <string_view>

namespace handwheel {
namespace {

constexpr std::size_t kColumns = 10;
using Cells = std::array<std::string, kColumns>;

const Cells& header() {
  static const Cells cells{"file",          "way",         "sound",   "state",   "triangles",
                           "99% within mm", "farthest mm", "seconds", "written", "reason"};
  return cells;
}

// digits: of numbers.
Cells cellsOf(const MethodRow& row, int digits) {
  Cells cells;
  cells[0] = row.file;
  cells[1] = row.method;
  cells[2] = row.figures && row.figures->isSound ? "yes" : "no";
  cells[3] = row.figures ? row.figures->state : "no result";
  if (row.figures) {
    cells[4] = std::to_string(row.figures->triangles);
    cells[5] = roundedText(row.figures->near99, digits);
    cells[6] = roundedText(row.figures->farthest, digits);
    cells[7] = roundedText(row.figures->seconds, digits);
  }
  cells[8] = row.isWritten ? "yes" : "no";
  cells[9] = row.reason;
  return cells;
}

std::size_t lengthOf(const std::string& text) {
  return static_cast<std::size_t>(QString::fromUtf8(text.c_str()).size());
}

// A field as RFC 4180 has it. What a spreadsheet would take for a formula gets an apostrophe.
std::string csvField(std::string text) {
  constexpr std::string_view kFormula = "=+-@\t\r";
  if (!text.empty() && kFormula.find(text.front()) != std::string_view::npos) text.insert(0, "'");
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string htmlRow(const Cells& cells, const char* tag) {
  std::string text = "<tr>";
  for (const std::string& cell : cells)
    text +=
        std::string("<") + tag + ">" + QString::fromUtf8(cell.c_str()).toHtmlEscaped().toStdString() + "</" + tag + ">";
  return text + "</tr>\n";
}

}  // namespace

std::string alignedText(const std::vector<MethodRow>& rows) {
  std::vector<Cells> table{header()};
  for (const MethodRow& row : rows) table.push_back(cellsOf(row, 3));
  std::array<std::size_t, kColumns> widths{};
  for (const Cells& cells : table)
    for (std::size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], lengthOf(cells[i]));
  std::string text;
  for (const Cells& cells : table) {
    std::string line;
    for (std::size_t i = 0; i < kColumns; ++i) line += cells[i] + std::string(widths[i] - lengthOf(cells[i]) + 2, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string csvText(const std::vector<MethodRow>& rows) {
  std::string text = "file,way,sound,state,triangles,scan_distance_99_mm,scan_distance_mm,seconds,written,reason\n";
  for (const MethodRow& row : rows) {
    const Cells cells = cellsOf(row, 9);
    for (std::size_t i = 0; i < kColumns; ++i) text += csvField(cells[i]) + (i + 1 < kColumns ? "," : "\n");
  }
  return text;
}

std::string htmlText(const std::vector<MethodRow>& rows) {
  std::string text =
      "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>Repair by triangles and by volume</title>\n"
      "<style>body{font-family:sans-serif}table{border-collapse:collapse}"
      "th,td{border:1px solid #999;padding:2px 8px;text-align:left}</style></head>\n"
      "<body><h1>Repair by triangles and by volume</h1>\n<table>\n" +
      htmlRow(header(), "th");
  for (const MethodRow& row : rows) text += htmlRow(cellsOf(row, 4), "td");
  return text + "</table>\n<p>Distances are those of the input from the result.</p></body></html>\n";
}

}  // namespace handwheel
