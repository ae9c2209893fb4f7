// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/RecoveryLock.h"

#include "document/recovery/ProcessMark.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <string>
#include <utility>

namespace handwheel {

namespace {

constexpr std::size_t kLongestMark = 200;  // bytes; of who holds a lock

// Closed in children, so that none of them keeps the lock of a dead parent.
constexpr int kOpening = O_CLOEXEC | O_NOFOLLOW;

// Of what a lock file says, as long as its holder has it: it is written once.
bool isHolderOver(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | kOpening);
  if (descriptor < 0) return false;
  char mark[kLongestMark];
  const ssize_t size = ::read(descriptor, mark, sizeof mark);
  ::close(descriptor);
  return size > 0 && isProcessOver(std::string(mark, static_cast<std::size_t>(size)));
}

}  // namespace

std::optional<RecoveryLock> RecoveryLock::lockFile(const std::filesystem::path& file, int flags) {
  const int descriptor = ::open(file.c_str(), O_RDWR | kOpening | flags, 0600);
  if (descriptor < 0) return {};
  RecoveryLock lock(descriptor);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return {};
  // Whoever held it before may have removed the folder, or the file was taken from it meanwhile.
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || status.st_nlink == 0) return {};
  // A lock without the mark is one all the same: on a full disk nobody can tell early that its holder is over.
  const std::string mark = ownProcessMark();
  if (::ftruncate(descriptor, 0) == 0) (void)!::pwrite(descriptor, mark.data(), mark.size(), 0);
  return lock;
}

std::optional<RecoveryLock> RecoveryLock::tryLock(const std::filesystem::path& folder) {
  // One at a time looks at a folder, so that none of two takes a lock from the other: the folder is the guard. Where
  // the file system has no such locks of folders, none is taken from the dead.
  const int guard = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | kOpening);
  if (guard < 0) return {};
  const bool isGuarded = ::flock(guard, LOCK_EX | LOCK_NB) == 0, isLookedAt = !isGuarded && errno == EWOULDBLOCK;
  std::optional<RecoveryLock> lock;
  if (!isLookedAt) lock = lockFile(folder / kFileName, O_CREAT);
  if (!lock && isGuarded && isHolderOver(folder / kFileName)) {
    std::error_code failed;
    std::filesystem::remove(folder / kFileName, failed);
    if (!failed) lock = lockFile(folder / kFileName, O_CREAT | O_EXCL);
  }
  ::close(guard);
  return lock;
}

RecoveryLock::RecoveryLock(RecoveryLock&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}

RecoveryLock& RecoveryLock::operator=(RecoveryLock&& other) noexcept {
  std::swap(m_descriptor, other.m_descriptor);
  return *this;
}

RecoveryLock::~RecoveryLock() {
  if (m_descriptor >= 0) ::close(m_descriptor);
}

}  // namespace handwheel
