// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/Recovery.h"

#include "document/AtomicFile.h"
#include "document/recovery/AutosaveChanges.h"
#include "document/recovery/OrphanedAutosaves.h"

#include <QUuid>

namespace handwheel {

namespace {

using namespace recovery;

Error writeFailed(const std::filesystem::path& path, const std::error_code& reason) {
  return {ErrorCode::WriteFailed, {reason.message()}, {}, path.string()};
}

}  // namespace

RecoverySession::RecoverySession(std::filesystem::path root) : m_root(std::move(root)) {}

RecoverySession::~RecoverySession() {
  if (m_lock) removeIfEmpty(m_folder);
}

// The lock is held before others can see the folder, so that it does not look like that of a dead session.
Status RecoverySession::openFolder() {
  std::error_code failed;
  if (m_lock && std::filesystem::exists(m_folder, failed)) return Done{};
  for (auto& [key, slot] : m_slots) {
    slot.info.reset();
    slot.stored.reset();
  }
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

Status RecoverySession::store(std::uint64_t key, const AutosaveInfo& info, const Container& container,
                              Progress progress) {
  std::shared_ptr<const StoredAutosave> stored;
  {
    const std::lock_guard guard(m_mutex);
    Slot& slot = m_slots[key];
    if (slot.isClosed) return Done{};
    if (const Status open = openFolder(); !open) return open.error();
    // Changes beside an autosave that was removed belong to nothing.
    std::error_code ignored;
    if (std::filesystem::exists(autosaveFile(m_folder, key), ignored)) stored = slot.stored;
  }
  const std::optional<Container> changes = stored ? changesSince(*stored, container) : std::nullopt;
  const Result<std::string> bytes =
      writeContainer(changes ? *changes : container, Compression::None, progress.part(0.0, 0.4));
  if (!bytes) return bytes.error();
  if (!changes) stored = std::make_shared<const StoredAutosave>(storedAutosave(container, *bytes));
  return store(key, info, *bytes, stored, changes ? Part::Changes : Part::Whole, progress.part(0.4, 1.0));
}

Status RecoverySession::store(std::uint64_t key, const AutosaveInfo& info, std::string_view container,
                              Progress progress) {
  return store(key, info, container, nullptr, Part::Whole, progress);
}

Status RecoverySession::store(std::uint64_t key, const AutosaveInfo& info, std::string_view bytes,
                              std::shared_ptr<const StoredAutosave> stored, Part part, Progress progress) {
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
    // The autosave was removed since the changes were computed. The next store() writes a whole one.
    if (part == Part::Changes && slot.stored != stored) return Done{};
    slot.info.reset();
    if (part == Part::Whole) slot.stored.reset();
  }
  const Status written = write(autosave, info, infoIsThere, bytes, part, progress);
  const std::lock_guard guard(m_mutex);
  Slot& slot = m_slots[key];
  if (slot.removals != removals) {
    removeAutosave(autosave);
    stored.reset();
  }
  if (!written) return written;
  slot.info = info;
  slot.stored = std::move(stored);
  return written;
}

// The info is written first: an info without an autosave means nothing, and the autosave is useful without the info.
// Changes of the replaced autosave do not fit the new one, so the time of their removal does not matter.
Status RecoverySession::write(const std::filesystem::path& autosave, const AutosaveInfo& info, bool infoIsThere,
                              std::string_view bytes, Part part, Progress progress) const {
  if (!infoIsThere) {
    if (const Status done = writeFileAtomically(infoFile(autosave), infoText(info)); !done) return done.error();
  }
  if (part == Part::Changes) return writeFileAtomically(changesFile(autosave), bytes, progress);
  const Status written = writeFileAtomically(autosave, bytes, progress);
  std::error_code ignored;
  if (written) std::filesystem::remove(changesFile(autosave), ignored);
  return written;
}

void RecoverySession::remove(std::uint64_t key) {
  const std::lock_guard guard(m_mutex);
  ++m_slots[key].removals;
  m_slots[key].stored.reset();
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
