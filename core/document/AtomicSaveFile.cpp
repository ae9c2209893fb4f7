// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/AtomicSaveFile.h"

#include "document/container/ContainerLayout.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>

namespace handwheel {

namespace {

constexpr mode_t kMode = 0666;  // less the umask
constexpr int kMostDraftNames = 100;

// Removes an existing file of this name that no process has locked.
void removeAbandoned(const std::filesystem::path& name) {
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat held {
  }, there{};
  const bool isAbandoned = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &held) == 0 &&
                           ::lstat(name.c_str(), &there) == 0 && held.st_ino == there.st_ino;
  if (isAbandoned) ::unlink(name.c_str());
  ::close(descriptor);
}

}  // namespace

std::filesystem::path folderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

AtomicSaveFile::AtomicSaveFile(const std::filesystem::path& target) : m_target(target) {
  // The file gets its name through /proc.
  if (::access("/proc/self/fd", X_OK) == 0)
    m_descriptor = ::open(folderOf(target).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kMode);
  if (m_descriptor >= 0)
    (void)::flock(m_descriptor, LOCK_EX | LOCK_NB);  // nobody else can have it
  else
    withHiddenName(&AtomicSaveFile::create);
}

AtomicSaveFile::~AtomicSaveFile() {
  if (!m_name.empty()) ::unlink(m_name.c_str());
  if (m_descriptor >= 0) ::close(m_descriptor);
}

// Only rename() replaces a file, and it needs a name, so the file has one for that moment.
bool AtomicSaveFile::replaceTarget() {
  if (m_name.empty()) {
    if (link(m_target)) return true;  // there was no old file
    if (errno != EEXIST || !withHiddenName(&AtomicSaveFile::link)) return false;
  }
  if (::rename(m_name.c_str(), m_target.c_str()) != 0) return false;
  m_name.clear();
  return true;
}

bool AtomicSaveFile::create(const std::filesystem::path& name) {
  m_descriptor = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, kMode);
  if (m_descriptor >= 0) (void)::flock(m_descriptor, LOCK_EX | LOCK_NB);
  return m_descriptor >= 0;
}

bool AtomicSaveFile::link(const std::filesystem::path& name) {
  const std::string open = "/proc/self/fd/" + std::to_string(m_descriptor);
  return ::linkat(AT_FDCWD, open.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

bool AtomicSaveFile::withHiddenName(bool (AtomicSaveFile::*make)(const std::filesystem::path&)) {
  for (int i = 0; i < kMostDraftNames; ++i) {
    std::filesystem::path name = hiddenName(m_target, i);
    removeAbandoned(name);
    const bool isMade = (this->*make)(name);
    if (isMade) m_name = std::move(name);
    if (isMade || errno != EEXIST) return isMade;
  }
  return false;
}

std::filesystem::path AtomicSaveFile::hiddenName(const std::filesystem::path& target, int number) {
  const std::string digits = layout::checksumText(target.filename().string());
  return folderOf(target) / (".handwheel-" + digits + "-" + std::to_string(number));
}

}  // namespace handwheel
