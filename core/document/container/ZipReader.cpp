// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/ZipReader.h"

#include "document/container/ArchiveErrors.h"
#include "document/container/LocalEntries.h"

#include <zip.h>
#include <algorithm>
#include <map>

namespace handwheel {

namespace {

constexpr std::size_t kUnpackBlock = 1 << 20;  // bytes between two looks at the cancel flag
constexpr std::uint64_t kDeflateRatio = 1032;  // the most that deflate can pack

struct DropArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};

Error cancelledError() {
  return {ErrorCode::Cancelled, {}, {}, {}};
}

Error damagedError(const std::string& name) {
  return {ArchiveError::EntryDamaged, {name}, {}, {}};
}

// Returns true if an entry is neither encrypted nor compressed by other methods, and its size is possible for the
// packed bytes.
bool isPossible(const zip_stat_t& entry) {
  if (entry.encryption_method != ZIP_EM_NONE) return false;
  if (entry.comp_method == ZIP_CM_STORE) return entry.size == entry.comp_size;
  return entry.comp_method == ZIP_CM_DEFLATE && entry.size / kDeflateRatio <= entry.comp_size;
}

}  // namespace

class ZipReader::Archive {
 public:
  Archive(std::string_view bytes, const UnpackLimits& limits, Progress progress)
      : m_bytes(bytes),
        m_limits(limits),
        m_progress(progress),
        m_budget(limits.budget(bytes.size())),
        m_work(2 * m_budget + 4 * bytes.size()) {
    openDirectory();
    if (m_zip) {
      listDirectory();
    } else {
      scanLocalEntries();
      for (const LocalEntry& entry : m_local) list(entry.name);
    }
  }

  std::uint64_t announcedSize(const std::string& name) const {
    zip_stat_t status;
    const auto listed = m_indices.find(name);
    if (m_zip && listed != m_indices.end() && zip_stat_index(m_zip.get(), listed->second, 0, &status) == 0)
      return status.size;
    const auto scanned = m_localByName.find(name);
    return scanned == m_localByName.end() || scanned->second.empty() ? 0 : scanned->second.front()->size;
  }

  Result<std::string> read(const std::string& name) {
    const auto listed = m_indices.find(name);
    if (m_zip && listed != m_indices.end()) {
      Result<std::string> content = readListed(listed->second, name);
      if (content || content.error().code != ArchiveError::EntryDamaged) return content;
    }
    return salvage(name);
  }

  std::string readDamaged(const std::string& name) {
    std::string longest;
    for (const LocalEntry* entry : localEntries(name)) {
      std::string bytes = unpackLocalEntry(m_bytes, *entry, m_budget, m_work, m_progress).bytes;
      if (bytes.size() > longest.size()) longest = std::move(bytes);
    }
    m_budget -= std::min<std::uint64_t>(m_budget, longest.size());
    return longest;
  }

  const std::vector<std::string>& names() const { return m_names; }
  const std::vector<std::string>& duplicates() const { return m_duplicates; }
  const std::string& problem() const { return m_problem; }
  bool hasSalvaged() const { return m_hasSalvaged; }

 private:
  void openDirectory() {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(m_bytes.data(), m_bytes.size(), 0, &error);
    if (source) m_zip.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
    if (m_zip) return;
    m_problem = zip_error_strerror(&error);
    zip_source_free(source);
    zip_error_fini(&error);
  }

  void listDirectory() {
    const auto count = static_cast<std::uint64_t>(zip_get_num_entries(m_zip.get(), 0));
    for (zip_uint64_t i = 0; i < std::min<std::uint64_t>(count, m_limits.entries); ++i) {
      const char* name = zip_get_name(m_zip.get(), i, 0);
      if (!name) continue;
      if (m_indices.try_emplace(name, i).second)
        m_names.emplace_back(name);
      else
        m_duplicates.emplace_back(name);
    }
  }

  void list(const std::string& name) {
    if (m_indices.try_emplace(name, 0).second) m_names.push_back(name);
  }

  void scanLocalEntries() {
    m_local = findLocalEntries(m_bytes, m_limits.entries);
    for (const LocalEntry& entry : m_local) m_localByName[entry.name].push_back(&entry);
    m_isScanned = true;
  }

  const std::vector<const LocalEntry*>& localEntries(const std::string& name) {
    if (!m_isScanned) scanLocalEntries();
    return m_localByName[name];
  }

  bool isAnnouncedLocally(const std::string& name, std::uint64_t size) {
    const auto& local = localEntries(name);
    return std::any_of(local.begin(), local.end(), [&](const LocalEntry* entry) { return entry->size == size; });
  }

  Result<std::string> readListed(zip_uint64_t index, const std::string& name) {
    zip_stat_t status;
    if (zip_stat_index(m_zip.get(), index, 0, &status) != 0) return damagedError(name);
    if (!isPossible(status)) return damagedError(name);
    // One wrong bit makes any size huge; a decompression bomb is one by its own header, too.
    if (status.size > m_budget) return isAnnouncedLocally(name, status.size) ? tooLarge() : damagedError(name);
    const std::unique_ptr<zip_file_t, CloseEntry> entry(zip_fopen_index(m_zip.get(), index, 0));
    if (!entry) return damagedError(name);
    return readToEnd(entry.get(), status);
  }

  Result<std::string> readToEnd(zip_file_t* entry, const zip_stat_t& announced) {
    std::string bytes;
    bytes.reserve(std::min(announced.size, kDeflateRatio * announced.comp_size));
    for (;;) {
      if (m_progress.cancelled()) return cancelledError();
      const std::size_t before = bytes.size();
      // One byte more than announced: only reading to the very end compares the checksum.
      const std::size_t room =
          before < announced.size ? std::min<std::size_t>(kUnpackBlock, announced.size - before) : 1;
      bytes.resize(before + room);
      const zip_int64_t got = zip_fread(entry, bytes.data() + before, room);
      if (got < 0) return damagedError(announced.name);
      bytes.resize(before + static_cast<std::size_t>(got));
      m_work -= std::min(m_work, static_cast<std::uint64_t>(got));
      if (bytes.size() > m_budget || m_work == 0) return tooLarge();
      if (got == 0) break;
    }
    m_budget -= bytes.size();
    bytes.shrink_to_fit();
    return bytes;
  }

  Result<std::string> salvage(const std::string& name) {
    bool isThere = m_indices.contains(name);
    for (const LocalEntry* entry : localEntries(name)) {
      isThere = true;
      UnpackedEntry unpacked = unpackLocalEntry(m_bytes, *entry, m_budget, m_work, m_progress);
      if (m_progress.cancelled()) return cancelledError();
      if (!unpacked.isWhole) continue;
      m_hasSalvaged = true;
      m_budget -= unpacked.bytes.size();
      unpacked.bytes.shrink_to_fit();
      return std::move(unpacked.bytes);
    }
    if (isThere) return damagedError(name);
    return Error{ArchiveError::EntryMissing, {name}, {}, {}};
  }

  Error tooLarge() const {
    return {ErrorCode::FileTooLarge, {"bytes", "", std::to_string(m_limits.budget(m_bytes.size()))}, {}, {}};
  }

  std::string_view m_bytes;
  UnpackLimits m_limits;
  Progress m_progress;
  std::uint64_t m_budget;  // bytes that may still be unpacked
  std::uint64_t m_work;    // bytes that may still be unpacked without a result, see unpackLocalEntry()
  std::unique_ptr<zip_t, DropArchive> m_zip;
  std::string m_problem;
  std::vector<std::string> m_names;
  std::vector<std::string> m_duplicates;
  std::map<std::string, zip_uint64_t> m_indices;
  std::vector<LocalEntry> m_local;
  std::map<std::string, std::vector<const LocalEntry*>> m_localByName;
  bool m_isScanned = false;
  bool m_hasSalvaged = false;
};

ZipReader::ZipReader(std::string_view archive, const UnpackLimits& limits, Progress progress)
    : m_archive(std::make_unique<Archive>(archive, limits, progress)) {}
ZipReader::~ZipReader() = default;

const std::vector<std::string>& ZipReader::names() const {
  return m_archive->names();
}

std::uint64_t ZipReader::announcedSize(const std::string& name) const {
  return m_archive->announcedSize(name);
}

Result<std::string> ZipReader::read(const std::string& name) {
  return m_archive->read(name);
}

std::string ZipReader::readDamaged(const std::string& name) {
  return m_archive->readDamaged(name);
}

const std::string& ZipReader::directoryProblem() const {
  return m_archive->problem();
}

const std::vector<std::string>& ZipReader::duplicates() const {
  return m_archive->duplicates();
}

bool ZipReader::hasSalvaged() const {
  return m_archive->hasSalvaged();
}

}  // namespace handwheel
