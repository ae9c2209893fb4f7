// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/OrphanedAutosaves.h"

#include "document/Container.h"
#include "document/FileBytes.h"
#include "document/container/ArchiveErrors.h"

#include <algorithm>
#include <chrono>

namespace handwheel {

namespace {

using namespace recovery;
namespace fs = std::filesystem;

constexpr std::size_t kLongestInfo = 64 << 10;  // a path has at most 4 KiB

std::vector<fs::path> childrenOf(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> children;
  for (fs::directory_iterator child(folder, failed), end; !failed && child != end; child.increment(failed))
    children.push_back(child->path());
  return children;
}

bool isRegular(const fs::path& file, const char* ending) {
  std::error_code ignored;
  return file.extension() == ending && fs::is_regular_file(fs::symlink_status(file, ignored));
}

bool isAutosave(const fs::path& file) {
  return isRegular(file, kAutosaveEnding);
}

bool isDamaged(const fs::path& file) {
  return isRegular(file, kDamagedEnding);
}

Error damagedEntry(const fs::path& file) {
  return {ArchiveError::EntryDamaged, {file.filename().string()}, {}, file.string()};
}

std::int64_t timeOf(const fs::path& file) {
  std::error_code ignored;
  const auto time = std::chrono::file_clock::to_sys(fs::last_write_time(file, ignored));
  return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

}  // namespace

namespace recovery {

void removeIfEmpty(const fs::path& session) {
  const std::vector<fs::path> files = childrenOf(session);
  if (std::any_of(files.begin(), files.end(), [](const fs::path& file) { return isAutosave(file) || isDamaged(file); }))
    return;
  std::error_code ignored;
  fs::remove_all(session, ignored);  // the lock, and what a killed write left half done
}

}  // namespace recovery

OrphanedAutosaves::OrphanedAutosaves(const fs::path& root) {
  list(childrenOf(root));
}

OrphanedAutosaves OrphanedAutosaves::of(const std::vector<fs::path>& sessions) {
  OrphanedAutosaves some{Nothing()};
  some.list(sessions);
  return some;
}

void OrphanedAutosaves::list(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    const bool isSession =
        fs::is_directory(fs::symlink_status(folder, ignored)) && folder.filename().string().front() != kHiddenPrefix;
    if (isSession) list(folder);
  }
  std::stable_sort(m_found.begin(), m_found.end(),
                   [](const OrphanedAutosave& a, const OrphanedAutosave& b) { return a.savedAt > b.savedAt; });
}

OrphanedAutosaves::~OrphanedAutosaves() {
  for (const Session& session : m_sessions) removeIfEmpty(session.folder);
}

void OrphanedAutosaves::list(const fs::path& folder) {
  std::optional<RecoveryLock> lock = RecoveryLock::tryLock(folder);
  if (!lock) return m_inUse.push_back(folder);
  for (const fs::path& file : childrenOf(folder)) {
    if (isAutosave(file)) look(file);
    if (isDamaged(file)) m_skipped.push_back(damagedEntry(file));
  }
  m_sessions.push_back({folder, std::move(*lock)});
}

void OrphanedAutosaves::look(const fs::path& file) {
  const Result<std::string> head = readFileHead(file);
  if (!head || !looksLikeContainer(*head)) {
    Error error = head ? damagedEntry(file) : head.error();
    error.subject = file.string();
    m_skipped.push_back(std::move(error));
    return;
  }
  OrphanedAutosave leftover;
  if (const Result<std::string> info = readFileHead(infoFile(file), kLongestInfo)) leftover.info = parseInfo(*info);
  leftover.file = file;
  std::error_code ignored;
  leftover.bytes = fs::file_size(file, ignored);
  leftover.savedAt = timeOf(file);
  if (const fs::path changes = changesFile(file); fs::exists(changes, ignored)) {
    leftover.bytes += fs::file_size(changes, ignored);
    leftover.savedAt = std::max(leftover.savedAt, timeOf(changes));
  }
  leftover.isOutdated = !leftover.info.path.empty() && fs::is_regular_file(leftover.info.path, ignored) &&
                        timeOf(leftover.info.path) > leftover.savedAt;
  m_found.push_back(std::move(leftover));
}

void OrphanedAutosaves::discard(const OrphanedAutosave& leftover) const {
  std::error_code ignored;
  removeAutosave(leftover.file);
  fs::remove(infoFile(leftover.file), ignored);
}

void OrphanedAutosaves::discardSkipped() const {
  for (const Error& error : m_skipped) removeAutosave(error.subject);
}

}  // namespace handwheel
