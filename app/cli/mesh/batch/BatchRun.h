// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/ProgressBar.h"
#include "cli/mesh/batch/BatchFiles.h"
#include "cli/mesh/batch/BatchReport.h"
#include "process/ChildProcess.h"

#include <chrono>
#include <map>

namespace handwheel {

// The parameters of a batch repair.
struct BatchRequest {
  BatchPlan plan;
  std::vector<std::string> repairOptions;  // command line words for the child process that repairs a file
  std::string unit;
  std::filesystem::path report;
  std::size_t jobs = 1;
  std::optional<double> timeLimit;     // seconds
  std::optional<BatchReport> earlier;  // report of the run that this one resumes
  bool asJson = false;
};

// Repairs many files, each in a child process. Several children run in parallel; if one fails, the others continue. The
// class prints the result of each file and keeps the report up to date, so that a killed run loses only its last
// moments.
class BatchRun {
 public:
  explicit BatchRun(BatchRequest request);

  // Repairs all files. Returns the exit code.
  int run();

 private:
  using Clock = std::chrono::steady_clock;
  struct Running {
    std::size_t file;  // index of the file in the plan
    FileTimestamp stamp;
    Clock::time_point start;
    std::optional<Clock::time_point> askedToEnd;  // time of the request to end
  };

  const BatchFile& planned(std::size_t file) const { return m_request.plan.files[file]; }
  BatchEntry blankEntry(std::size_t file) const;
  bool takeEarlier(std::size_t file);
  void start(std::size_t file);
  void fail(std::size_t file, std::string reason);
  void watchTimes();
  void collect();
  void conclude(const Running& running, const ChildProcess& child);
  void finish(std::size_t file, BatchEntry entry, std::string_view mark = {});
  void stop();
  void say(const std::string& line);
  bool saveReport();
  BatchReport report() const;
  int exitCode() const;

  BatchRequest m_request;
  std::map<std::string, const BatchEntry*>
      m_earlier;                                     // entries of an earlier run with the same options, by output path
  std::vector<std::optional<BatchEntry>> m_entries;  // index: the file in the plan
  std::size_t m_finished = 0;
  std::vector<Running> m_running;
  std::vector<std::unique_ptr<ChildProcess>> m_children;  // child processes of m_running, in the same order
  ProgressBar m_bar{"Repairing"};
  Clock::time_point m_nextReport = Clock::time_point::max();
  bool m_isMute = false;                // stdout cannot be written any more
  bool m_isReported = false;            // the report on disk contains all finished files
  bool m_isReportFailureKnown = false;  // the failure to write the report was reported
};

}  // namespace handwheel
