// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/batch/BatchReport.h"

#include "base/JsonText.h"
#include "cli/ReportJson.h"
#include "cli/ReportText.h"
#include "cli/Wording.h"
#include "cli/mesh/RepairJson.h"
#include "document/FileBytes.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kStateWords{"closed", "left-open", "failed"};  // by BatchState
constexpr std::array<std::string_view, 3> kStateNames{"closed", "left open", "failed"};

// A value of the wrong type or none leaves what is there.
template <class T>
void take(const nlohmann::json& object, const char* key, T& value) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  try {
    value = found->get<T>();
  } catch (const nlohmann::json::exception&) {
  }
}

bool takeState(const nlohmann::json& object, BatchState& state) {
  std::string word;
  take(object, "state", word);
  const auto found = std::find(kStateWords.begin(), kStateWords.end(), word);
  if (found == kStateWords.end()) return false;
  state = static_cast<BatchState>(found - kStateWords.begin());
  return true;
}

bool takeEntry(const nlohmann::json& object, BatchEntry& entry) {
  if (!object.is_object() || !takeState(object, entry.state)) return false;
  take(object, "input", entry.input);
  take(object, "output", entry.output);
  entry.loops = loopCountsFrom(object);
  take(object, "left", entry.left);
  take(object, "reason", entry.reason);
  take(object, "notes", entry.notes);
  take(object, "seconds", entry.seconds);
  take(object, "input_bytes", entry.inputStamp.bytes);
  take(object, "input_modified_ns", entry.inputStamp.modifiedNs);
  take(object, "output_bytes", entry.outputBytes);
  return true;
}

Json toJson(const BatchEntry& entry) {
  Json json = {
      {"input", entry.input},
      {"output", entry.output},
      {"state", kStateWords[static_cast<std::size_t>(entry.state)]},
      {"left", entry.left},
      {"reason", entry.reason.empty() ? Json(nullptr) : Json(entry.reason)},
      {"notes", entry.notes},
      {"seconds", entry.seconds},
      {"input_bytes", entry.inputStamp.bytes},
      {"input_modified_ns", entry.inputStamp.modifiedNs},
      {"output_bytes", entry.outputBytes},
  };
  json.update(toJson(entry.loops));
  return json;
}

// The sums over the files in one state, or in any.
struct Total {
  std::size_t files = 0, filled = 0;
  double seconds = 0.0;
};
Total totalOf(const BatchReport& report, std::optional<BatchState> state) {
  Total total;
  for (const BatchEntry& entry : report.entries) {
    if (state && entry.state != *state) continue;
    ++total.files;
    total.filled += entry.loops.holes.closed;
    total.seconds += entry.seconds;
  }
  return total;
}

Json summaryOf(const BatchReport& report) {
  const Total all = totalOf(report, {});
  return {
      {"files", report.fileCount},
      {"closed", totalOf(report, BatchState::Closed).files},
      {"left_open", totalOf(report, BatchState::LeftOpen).files},
      {"failed", totalOf(report, BatchState::Failed).files},
      {"not_done", report.fileCount - std::min(report.fileCount, all.files)},
      {"holes_filled", all.filled},
      {"seconds", all.seconds},
  };
}

std::string oneDecimal(double value) {
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 1);
  return error == std::errc() ? std::string(text, end) : "?";
}

std::string row(std::string_view name, const Total& total) {
  return std::string(name) + std::string(12 - name.size(), ' ') + rightAligned(std::to_string(total.files), 8) +
         rightAligned(std::to_string(total.filled), 15) + rightAligned(oneDecimal(total.seconds), 12) + "\n";
}

// Options of the report of an earlier version, as Arguments names and orders them now.
void nameAsNow(std::vector<std::string>& options) {
  constexpr std::string_view kFormer = "--rims=", kNow = "--open-sheets=";
  for (std::string& option : options)
    if (option.starts_with(kFormer)) option.replace(0, kFormer.size(), kNow);
  std::stable_sort(options.begin(), options.end(), [](const std::string& a, const std::string& b) {
    return a.substr(0, a.find('=')) < b.substr(0, b.find('='));
  });
}

}  // namespace

std::string textOf(const BatchReport& report) {
  Json files = Json::array();
  for (const BatchEntry& entry : report.entries) files.push_back(toJson(entry));
  return textOf(Json{
      {"batch", report.program},
      {"options", report.options},
      {"unit", report.unit},
      {"summary", summaryOf(report)},
      {"files", files},
  });
}

Result<std::optional<BatchReport>> readBatchReport(const std::filesystem::path& path) {
  Result<std::string> bytes = readFileBytes(path);
  if (!bytes && bytes.error().code == ErrorCode::FileMissing) return std::optional<BatchReport>();
  if (!bytes) return bytes.error();
  Result<nlohmann::json> json = parseJson(*bytes, "report");
  if (!json) return json.error();
  const auto files = json->find("files");
  if (!json->is_object() || !json->contains("batch") || files == json->end() || !files->is_array()) {
    return Error{ErrorCode::ElementMalformed, {"report", "it is not that of a repair of many files"}, {}, {}};
  }
  BatchReport report;
  take(*json, "batch", report.program);
  take(*json, "options", report.options);
  nameAsNow(report.options);
  take(*json, "unit", report.unit);
  for (const nlohmann::json& file : *files) {
    BatchEntry entry;
    if (takeEntry(file, entry)) report.entries.push_back(std::move(entry));
  }
  report.fileCount = report.entries.size();
  return std::optional<BatchReport>(std::move(report));
}

bool readOutcome(std::string_view line, BatchEntry& entry) {
  const Result<nlohmann::json> json = parseJson(line, "outcome");
  BatchEntry said = entry;
  if (!json || !takeEntry(*json, said)) return false;
  // The paths and the start are known here, not to the child.
  said.input = entry.input;
  said.output = entry.output;
  said.inputStamp = entry.inputStamp;
  entry = std::move(said);
  return true;
}

std::string sentenceFor(const BatchEntry& entry) {
  std::string sentence(kStateNames[static_cast<std::size_t>(entry.state)]);
  if (entry.state == BatchState::Failed) return sentence + ": " + entry.reason;
  if (entry.state == BatchState::LeftOpen) {
    sentence += " at " + std::to_string(entry.left) + (entry.left == 1 ? " place, " : " places, ");
  } else {
    sentence += ", ";
  }
  std::string filled = outcomesText(entry.loops);
  filled.front() = static_cast<char>(std::tolower(filled.front()));
  sentence += filled + ", " + oneDecimal(entry.seconds) + " s";
  if (!entry.reason.empty()) sentence += ". " + entry.reason;
  return sentence;
}

std::string lineOf(const BatchEntry& entry) {
  return toJson(entry).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summaryTable(const BatchReport& report) {
  std::string table = "\n                  files   holes filled     seconds\n";
  for (BatchState state : kBatchStates) {
    table += row(kStateNames[static_cast<std::size_t>(state)], totalOf(report, state));
  }
  return table + row("together", totalOf(report, {}));
}

}  // namespace handwheel
