// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Of one file of a batch, from best to worst: closed, manifold and oriented; written, but something is left; not
// written.
enum class BatchState { Closed, LeftOpen, Failed };
inline constexpr std::array kBatchStates{BatchState::Closed, BatchState::LeftOpen, BatchState::Failed};

// A file by what changes when it is written.
struct FileStamp {
  std::uintmax_t bytes = 0;
  std::int64_t modifiedNs = 0;  // since 1970
  bool operator==(const FileStamp&) const = default;
};
std::optional<FileStamp> stampOf(const std::filesystem::path& file);  // none where there is no regular file

// What became of one file.
struct BatchEntry {
  std::string input, output;
  FileStamp inputStamp;  // before the repair
  std::uintmax_t outputBytes = 0;
  BatchState state = BatchState::Failed;
  std::size_t holes = 0, filled = 0;
  std::size_t left = 0;            // places that keep the written file from being closed
  std::string reason;              // of the first of them, or why it failed, as a sentence
  std::vector<std::string> notes;  // what was lost or damaged
  double seconds = 0.0;
};

struct BatchReport {
  std::string program;               // its version
  std::vector<std::string> options;  // of the repair, as words
  std::string unit;
  std::size_t fileCount = 0;  // also those that no entry tells of yet
  std::vector<BatchEntry> entries;
};

std::string textOf(const BatchReport& report);

// None where no file is. Errors: those of reading it; ElementMalformed where it is no such report.
Result<std::optional<BatchReport>> readBatchReport(const std::filesystem::path& path);

// What the program that repaired one file (--json) said. False: it did not say it.
bool readOutcome(std::string_view line, BatchEntry& entry);

// "closed, 4 holes filled", "failed: ..."
std::string sentenceFor(const BatchEntry& entry);
// The same as a line of JSON.
std::string lineOf(const BatchEntry& entry);

// Files, holes filled and seconds by state, aligned for people.
std::string summaryTable(const BatchReport& report);

}  // namespace handwheel
