// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/FileTimestamp.h"
#include "mesh/repair/OutcomeCounts.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// The outcome for one file of a batch, from best to worst. Closed: the written mesh is sound (MeshState::isSound());
// LeftOpen: the mesh was written, but defects remain; Failed: nothing was written.
enum class BatchState { Closed, LeftOpen, Failed };
inline constexpr std::array kBatchStates{BatchState::Closed, BatchState::LeftOpen, BatchState::Failed};

// The result for one file of a batch.
struct BatchEntry {
  std::string input, output;
  FileTimestamp inputStamp;  // stamp of the input before the repair
  std::uintmax_t outputBytes = 0;
  BatchState state = BatchState::Failed;
  LoopCounts loops;
  std::size_t left = 0;  // number of remaining defects that keep the written file from being closed
  std::string reason;    // a sentence: the reason why the first of these defects remains, or why the file failed
  std::vector<std::string> notes;  // losses and damage
  double seconds = 0.0;
};

// The results of a batch repair, including the options with which it ran.
struct BatchReport {
  std::string program;               // version of the program
  std::vector<std::string> options;  // repair options, as command line words
  std::string unit;
  std::size_t fileCount = 0;  // number of files of the batch, including those without an entry yet
  std::vector<BatchEntry> entries;
};

// Returns the text of a report's file.
std::string textOf(const BatchReport& report);

// Reads a report from a file. Returns nothing if there is no file. Errors: those of reading the file; ElementMalformed
// if it is not such a report.
Result<std::optional<BatchReport>> readBatchReport(const std::filesystem::path& path);

// Parses the --json output of the child process that repaired one file. Returns false if it is not valid.
bool readOutcome(std::string_view line, BatchEntry& entry);

// Returns the result in words: "closed, 4 holes filled", "failed: ..."
std::string sentenceFor(const BatchEntry& entry);
// Returns the result as a line of JSON.
std::string lineOf(const BatchEntry& entry);

// Returns a table of files, filled holes and seconds by state, to be read by people.
std::string summaryTable(const BatchReport& report);

}  // namespace handwheel
