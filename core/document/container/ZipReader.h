// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/container/UnpackLimits.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A reader of an untrusted ZIP archive in memory. If the archive's directory is lost or wrong, entries are found by
// their local headers. The bytes must outlive the reader. It must not be used on two threads at the same time. Its
// functions may throw std::bad_alloc.
class ZipReader {
 public:
  // Opens an archive. progress: used for cancelling only.
  ZipReader(std::string_view archive, const UnpackLimits& limits, Progress progress = {});
  ~ZipReader();

  // Returns the names of the entries, from the directory or else from the local headers. Each name is listed once, in
  // the order of the archive. The names are not validated.
  const std::vector<std::string>& names() const;

  // Returns the unpacked size of an entry as the directory or its header declares it, which may be wrong; 0 if the
  // entry does not exist.
  std::uint64_t announcedSize(const std::string& name) const;

  // Returns the bytes of an entry, complete and with the right checksum. Errors: EntryMissing {name}, EntryDamaged
  // {name}, FileTooLarge {"bytes", "", limit}, Cancelled.
  Result<std::string> read(const std::string& name);
  // Returns the first part of a damaged entry, as far as it can be unpacked; it may be empty.
  std::string readDamaged(const std::string& name);

  // Returns the reason why the directory cannot be used; empty if it can be used.
  const std::string& directoryProblem() const;
  // Returns the names that the directory lists more than once. The first entry of a name is the one that is read.
  const std::vector<std::string>& duplicates() const;
  // Returns true if an entry was read that is not in the directory.
  bool hasSalvaged() const;

 private:
  class Archive;
  std::unique_ptr<Archive> m_archive;
};

}  // namespace handwheel
