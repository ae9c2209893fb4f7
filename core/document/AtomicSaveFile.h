// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace handwheel {

// Returns the folder of a file; "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

// A temporary file that replaces another file when it is complete. If the system supports it, it has no name until it
// is complete, so that a program killed while writing leaves nothing; otherwise (network and foreign file systems) it
// is a hidden file next to the other. Removed with this object unless it replaced the target. A file left by a killed
// program is removed by the next one for the same target: running programs hold a lock on theirs. One thread at a time.
class AtomicSaveFile {
 public:
  explicit AtomicSaveFile(const std::filesystem::path& target);
  ~AtomicSaveFile();
  AtomicSaveFile(const AtomicSaveFile&) = delete;
  AtomicSaveFile& operator=(const AtomicSaveFile&) = delete;

  int descriptor() const { return m_descriptor; }  // for writing; negative: none, errno is the reason

  // Replaces the target, which at every moment is completely the old file or this one. Returns false on failure: errno
  // is the reason, and the target is the old file.
  bool replaceTarget();

  // Returns ".handwheel-", eight hexadecimal digits that hash the target's name, which may have the maximal length, and
  // a number.
  static std::filesystem::path hiddenName(const std::filesystem::path& target, int number);

 private:
  bool create(const std::filesystem::path& name);
  bool link(const std::filesystem::path& name);
  // Calls `make` with the first hidden name that no existing file has.
  bool withHiddenName(bool (AtomicSaveFile::*make)(const std::filesystem::path&));

  std::filesystem::path m_target;
  std::filesystem::path m_name;  // empty while it has no name
  int m_descriptor = -1;
};

}  // namespace handwheel
