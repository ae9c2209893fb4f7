// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace handwheel {

// "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

// A file that is written to take the place of another. Where the system can, it has no name until it is complete, so
// that a program killed while it writes leaves nothing; elsewhere (network and foreign file systems) it is hidden
// beside the other. Gone with this object unless it took its place. A draft that a killed program did leave is removed
// by the next one for the same file: whoever lives holds a lock on his. One thread at a time.
class DraftFile {
 public:
  explicit DraftFile(const std::filesystem::path& target);
  ~DraftFile();
  DraftFile(const DraftFile&) = delete;
  DraftFile& operator=(const DraftFile&) = delete;

  int descriptor() const { return m_descriptor; }  // for writing; negative: errno says why there is none

  // At every moment the target is the old file or this one, whole. False: errno says why, and it is the old one.
  bool takePlace();

  // ".handwheel-", eight hexadecimal digits made of the target's name, which may be as long as names can be, and a
  // number.
  static std::filesystem::path hiddenName(const std::filesystem::path& target, int number);

 private:
  bool create(const std::filesystem::path& name);
  bool link(const std::filesystem::path& name);
  // With the first hidden name for which it does not fail because there is such a file.
  bool withHiddenName(bool (DraftFile::*make)(const std::filesystem::path&));

  std::filesystem::path m_target;
  std::filesystem::path m_name;  // empty while it has none
  int m_descriptor = -1;
};

}  // namespace handwheel
