// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/RecoveryLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace handwheel {

std::optional<RecoveryLock> RecoveryLock::tryLock(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kFileName;
  // The descriptor is closed in children, so that none of them keeps the lock of a dead parent.
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (descriptor < 0) return {};
  RecoveryLock lock(descriptor);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return {};
  // The previous owner of the lock may have removed the folder.
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || status.st_nlink == 0) return {};
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
