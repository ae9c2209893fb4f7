// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/Recovery.h"

#include "document/AtomicFile.h"
#include "document/OrphanedAutosaves.h"

#include <QUuid>

namespace handwheel {

namespace {

using namespace recovery;

Error writeFailed(const std::filesystem::path& path, const std::error_code& reason) {
  return {ErrorCode::WriteFailed, {reason.message()}, {}, path.string()};
}

// Its info stays: a store() that is under way may be about to put an autosave beside it.
void removeAutosave(const std::filesystem::path& autosave) {
  std::error_code ignored;
  std::filesystem::remove(autosave, ignored);
}

}  // namespace

RecoverySession::RecoverySession(std::filesystem::path root) : m_root(std::move(root)) {}

RecoverySession::~RecoverySession() {
  if (m_lock) removeIfEmpty(m_folder);
}

// The lock is held before others can see the folder, so that nobody takes it for a dead one's.
Status RecoverySession::openFolder() {
  std::error_code failed;
  if (m_lock && std::filesystem::exists(m_folder, failed)) return Done{};
  for (auto& [key, slot] : m_slots) slot.info.reset();
  const std::string name = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  const std::filesystem::path hidden = m_root / (kHiddenPrefix + name);
  std::filesystem::create_directories(hidden, failed);
  if (failed) return writeFailed(hidden, failed);
  std::filesystem::permissions(hidden, std::filesystem::perms::owner_all, failed);
  m_lock = RecoveryLock::tryLock(hidden);
  if (!m_lock) return writeFailed(hidden, std::make_error_code(std::errc::no_lock_available));
  m_folder = m_root / name;
  std::filesystem::rename(hidden, m_folder, failed);
  if (failed) return writeFailed(m_folder, failed);
  (void)syncFolder(m_root);
  return Done{};
}

Status RecoverySession::store(std::uint64_t key, const AutosaveInfo& info, std::string_view container,
                              Progress progress) {
  std::filesystem::path autosave;
  std::uint64_t removals = 0;
  bool infoIsThere = false;
  {
    const std::lock_guard guard(m_mutex);
    Slot& slot = m_slots[key];
    if (slot.isClosed) return Done{};
    if (const Status open = openFolder(); !open) return open.error();
    autosave = autosaveFile(m_folder, key);
    removals = slot.removals;
    infoIsThere = slot.info == info;
    slot.info.reset();
  }
  const Status written = write(autosave, info, infoIsThere, container, progress);
  const std::lock_guard guard(m_mutex);
  Slot& slot = m_slots[key];
  if (slot.removals != removals) removeAutosave(autosave);
  if (written) slot.info = info;
  return written;
}

// The info first: an info without an autosave says nothing, and the autosave keeps its worth without the info.
Status RecoverySession::write(const std::filesystem::path& autosave, const AutosaveInfo& info, bool infoIsThere,
                              std::string_view container, Progress progress) const {
  if (!infoIsThere) {
    if (const Status done = writeFileAtomically(infoFile(autosave), infoText(info)); !done) return done.error();
  }
  return writeFileAtomically(autosave, container, progress);
}

void RecoverySession::remove(std::uint64_t key) {
  const std::lock_guard guard(m_mutex);
  ++m_slots[key].removals;
  if (m_lock) removeAutosave(autosaveFile(m_folder, key));
}

void RecoverySession::close(std::uint64_t key) {
  remove(key);
  const std::lock_guard guard(m_mutex);
  m_slots[key].isClosed = true;
}

Status RecoverySession::adopt(const OrphanedAutosave& leftover, std::uint64_t key) {
  const std::lock_guard guard(m_mutex);
  if (const Status open = openFolder(); !open) return open.error();
  const std::filesystem::path autosave = autosaveFile(m_folder, key);
  if (const Status done = writeFileAtomically(infoFile(autosave), infoText(leftover.info)); !done) return done.error();
  std::error_code failed;
  std::filesystem::rename(leftover.file, autosave, failed);
  if (failed) return writeFailed(autosave, failed);
  (void)syncFolder(m_folder);
  return Done{};
}

}  // namespace handwheel
