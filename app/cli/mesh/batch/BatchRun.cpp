// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/batch/BatchRun.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/mesh/batch/ChildRepair.h"
#include "document/AtomicFile.h"

#include <algorithm>
#include <csignal>

namespace handwheel {

namespace {

using namespace std::chrono_literals;

constexpr auto kPoll = 5ms;
constexpr int kReportShare = 20;  // At most one part in this number of the time goes into writing the report
constexpr std::size_t kMostNotes = 20;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A file name may hold anything, and the line is to stay one.
std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, '?');
  return text;
}

}  // namespace

BatchRun::BatchRun(BatchRequest request) : m_request(std::move(request)), m_entries(m_request.plan.files.size()) {
  const auto& earlier = m_request.earlier;
  if (!earlier || earlier->program != HANDWHEEL_VERSION || earlier->options != m_request.repairOptions) return;
  for (const BatchEntry& entry : earlier->entries) m_earlier.emplace(entry.output, &entry);
}

int BatchRun::run() {
  const std::size_t count = m_entries.size();
  std::vector<std::size_t> todo;
  for (std::size_t file = 0; file < count; ++file) {
    if (!takeEarlier(file)) todo.push_back(file);
  }
  const auto begin = Clock::now();
  m_nextReport = begin;  // not before: until then the earlier report tells of more than a new one would
  std::size_t next = 0;
  while (!wasInterrupted() && (next < todo.size() || !m_children.empty())) {
    while (!wasInterrupted() && next < todo.size() && m_children.size() < m_request.jobs) start(todo[next++]);
    m_bar.show(static_cast<double>(m_finished) / static_cast<double>(count), static_cast<int>(secondsSince(begin)));
    ChildProcess::wait(m_children, kPoll);
    watchTimes();
    collect();
  }
  m_bar.clear();
  if (wasInterrupted()) {
    stop();
    const bool isSaved = saveReport();
    complain("Cancelled after " + std::to_string(m_finished) + " of " + std::to_string(count) + " files." +
             (isSaved ? " Run again with --resume to do the rest." : ""));
    return kExitInterrupted;
  }
  const bool isSaved = saveReport();
  if (!m_request.asJson) say(summaryTable(report()));
  return isSaved ? exitCode() : kExitError;
}

BatchEntry BatchRun::blankEntry(std::size_t file) const {
  BatchEntry entry;
  entry.input = planned(file).input.string();
  entry.output = planned(file).output.string();
  return entry;
}

// Takes the result of an earlier run if its output exists and nothing has changed on which it depends.
bool BatchRun::takeEarlier(std::size_t file) {
  const auto found = m_earlier.find(planned(file).output.string());
  if (found == m_earlier.end() || found->second->state == BatchState::Failed) return false;
  BatchEntry entry = *found->second;
  const auto input = timestampOf(planned(file).input), output = timestampOf(planned(file).output);
  if (!input || !output || entry.inputStamp != *input || entry.outputBytes != output->bytes) return false;
  entry.input = planned(file).input.string();
  finish(file, std::move(entry), " (done before)");
  return true;
}

void BatchRun::start(std::size_t file) {
  const FileTimestamp stamp = timestampOf(planned(file).input).value_or(FileTimestamp());
  StartedRepair started = startRepair(planned(file), m_request.repairOptions);
  if (!started.child) return fail(file, std::move(started.problem));
  m_children.push_back(std::move(started.child));
  m_running.push_back({file, stamp, Clock::now(), {}});
}

void BatchRun::fail(std::size_t file, std::string reason) {
  BatchEntry entry = blankEntry(file);
  entry.reason = std::move(reason);
  finish(file, std::move(entry));
}

void BatchRun::watchTimes() {
  const auto now = Clock::now();
  for (std::size_t i = 0; i < m_running.size(); ++i) {
    Running& running = m_running[i];
    if (running.askedToEnd && now - *running.askedToEnd > kChildGrace) m_children[i]->send(SIGKILL);
    if (running.askedToEnd || !m_request.timeLimit || secondsSince(running.start) < *m_request.timeLimit) continue;
    m_children[i]->send(SIGTERM);
    running.askedToEnd = now;
  }
}

void BatchRun::collect() {
  for (std::size_t i = 0; i < m_children.size();) {
    if (!m_children[i]->hasEnded()) {
      ++i;
      continue;
    }
    const Running running = m_running[i];
    const std::unique_ptr<ChildProcess> child = std::move(m_children[i]);
    m_running.erase(m_running.begin() + static_cast<std::ptrdiff_t>(i));
    m_children.erase(m_children.begin() + static_cast<std::ptrdiff_t>(i));
    conclude(running, *child);
  }
}

void BatchRun::conclude(const Running& running, const ChildProcess& child) {
  BatchEntry entry = blankEntry(running.file);
  entry.inputStamp = running.stamp;
  const bool isDone = child.code() == kExitDone || child.code() == kExitSomethingLeft;
  const bool hasSaid = isDone && readOutcome(child.output(), entry);
  if (!hasSaid && wasInterrupted()) return;  // so that the next run does it
  if (hasSaid) {
    entry.outputBytes = timestampOf(planned(running.file).output).value_or(FileTimestamp()).bytes;
    entry.notes = complaintsOf(child);
    if (entry.notes.size() > kMostNotes) entry.notes.resize(kMostNotes);
  } else {
    entry.reason = running.askedToEnd ? tooLong(*m_request.timeLimit) : failureOf(child, planned(running.file));
  }
  entry.seconds = secondsSince(running.start);
  finish(running.file, std::move(entry));
}

// The report first, so that what was said to be done is in it, unless it would take too much of the time.
void BatchRun::finish(std::size_t file, BatchEntry entry, std::string_view mark) {
  ++m_finished;
  const std::string number = std::to_string(m_finished), count = std::to_string(m_entries.size());
  const std::string line = "[" + std::string(count.size() - number.size(), ' ') + number + "/" + count + "] " +
                           entry.input + ": " + sentenceFor(entry) + std::string(mark);
  const std::string json = m_request.asJson ? lineOf(entry) : std::string();
  m_entries[file] = std::move(entry);
  m_isReported = false;
  if (Clock::now() >= m_nextReport) saveReport();
  m_bar.clear();
  say(m_request.asJson ? json : oneLine(line) + "\n");
}

// Ends all that is running; what has just come to its end still counts.
void BatchRun::stop() {
  for (std::size_t i = 0; i < m_children.size(); ++i) {
    m_children[i]->send(SIGTERM);
    m_running[i].askedToEnd = Clock::now();
  }
  while (!m_children.empty()) {
    ChildProcess::wait(m_children, kPoll);
    watchTimes();
    collect();
  }
}

void BatchRun::say(const std::string& line) {
  if (!m_isMute) m_isMute = print(line) != kExitDone;
}

bool BatchRun::saveReport() {
  if (m_isReported || m_finished == 0) return true;
  const auto start = Clock::now();
  const Status written = writeFileAtomically(m_request.report, textOf(report()));
  m_nextReport = Clock::now() + kReportShare * (Clock::now() - start);
  m_isReported = written.hasValue();
  if (!written && !m_isReportFailureKnown) complain(sentenceFor(written.error()));
  m_isReportFailureKnown = !written;
  return m_isReported;
}

BatchReport BatchRun::report() const {
  BatchReport report{HANDWHEEL_VERSION, m_request.repairOptions, m_request.unit, m_entries.size(), {}};
  for (const auto& entry : m_entries) {
    if (entry) report.entries.push_back(*entry);
  }
  return report;
}

int BatchRun::exitCode() const {
  if (m_isMute) return kExitError;
  BatchState worst = BatchState::Closed;
  for (const auto& entry : m_entries) worst = std::max(worst, entry->state);
  constexpr std::array kCodes{kExitDone, kExitSomethingLeft, kExitError};  // by BatchState
  return kCodes[static_cast<std::size_t>(worst)];
}

}  // namespace handwheel
