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

// Reads an untrusted ZIP archive from memory. If its directory is lost or wrong, entries are found by their local
// headers. The bytes must outlive it; one thread at a time. May throw bad_alloc.
class ZipReader {
 public:
  // progress: for cancelling only.
  ZipReader(std::string_view archive, const UnpackLimits& limits, Progress progress = {});
  ~ZipReader();

  // Returns the names of the entries, from the directory or else from the headers; each once, in their order. They are
  // not validated.
  const std::vector<std::string>& names() const;

  // Returns the size of the entry as declared in the directory or its header, correct or not; 0 if it does not exist.
  std::uint64_t announcedSize(const std::string& name) const;

  // Returns the entry, whole and with the right checksum. Errors: EntryMissing {name}, EntryDamaged {name},
  // FileTooLarge {"bytes", "", limit}, Cancelled.
  Result<std::string> read(const std::string& name);
  // Returns the part of a damaged entry that can be unpacked, from its beginning; possibly empty.
  std::string readDamaged(const std::string& name);

  // Returns the reason why the directory cannot be used; empty if it can.
  const std::string& directoryProblem() const;
  // Returns names that the directory lists more than once; the first is read.
  const std::vector<std::string>& duplicates() const;
  // Returns true if an entry was read that the directory does not lead to.
  bool hasSalvaged() const;

 private:
  class Archive;
  std::unique_ptr<Archive> m_archive;
};

}  // namespace handwheel
