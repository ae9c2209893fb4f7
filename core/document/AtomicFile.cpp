// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/AtomicFile.h"

#include "document/AtomicSaveFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

namespace handwheel {

namespace {

constexpr std::size_t kBlock = 1 << 20;
constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

std::atomic<int> filesBeingWritten{0};

struct BeingWritten {
  BeingWritten() { ++filesBeingWritten; }
  ~BeingWritten() { --filesBeingWritten; }
};

Error writeFailed(const std::filesystem::path& path, std::string reason) {
  return {ErrorCode::WriteFailed, {std::move(reason)}, {}, path.string()};
}

std::string systemReason() {
  return std::strerror(errno);
}

// Returns the path itself, or the target of the link, which need not exist.
std::filesystem::path linkTarget(std::filesystem::path path) {
  constexpr int kMostLinks =
      40;  // the limit of Linux; for a cyclic link the result is a link, which cannot be written to
  std::error_code ignored;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(path, ignored); ++i)
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  return path;
}

bool writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

// Writes in blocks, between which it checks the cancel flag.
Status writeBlocks(const std::filesystem::path& path, int descriptor, std::string_view bytes, Progress progress) {
  for (std::size_t start = 0; start < bytes.size(); start += kBlock) {
    if (!writeAll(descriptor, bytes.substr(start, kBlock))) return writeFailed(path, systemReason());
    progress.set(static_cast<double>(start) / static_cast<double>(bytes.size()));
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  }
  return Done{};
}

// Writes to a device, which cannot be replaced and keeps no partial content.
Status writeToDevice(const std::filesystem::path& path, std::string_view bytes, Progress progress) {
  const int device = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (device < 0) return writeFailed(path, systemReason());
  const Status written = writeBlocks(path, device, bytes, progress);
  ::close(device);
  return written;
}

// Flushes to disk. EINVAL: the file system does not support it.
bool synchronise(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL;
}

// Takes over the permissions of the old file, which must be writable, though it is only replaced.
bool takeOver(const std::filesystem::path& target, int descriptor) {
  struct stat old {};
  if (::stat(target.c_str(), &old) != 0) return errno == ENOENT;
  (void)::fchmod(descriptor, old.st_mode & 0777);
  return ::access(target.c_str(), W_OK) == 0;
}

// The new content of a path, from the first byte until it has replaced the old one.
class Replacement {
 public:
  explicit Replacement(const std::filesystem::path& path) : m_path(path), m_target(linkTarget(path)) {}
  ~Replacement() {
    if (m_folder >= 0) ::close(m_folder);
  }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  // Writes it to the disk. A device is not replaced, and has all of it then.
  Status prepare(std::string_view bytes, Progress progress);
  // Replaces the target. Everything is ready by then, so that no lack of memory or descriptors can interrupt it.
  Status replaceTarget();

 private:
  std::filesystem::path m_path, m_target;
  std::optional<AtomicSaveFile> m_draft;
  int m_folder =
      -1;  // folder of the target; negative also if it may be written to but not listed, and so not synchronised
};

Status Replacement::prepare(std::string_view bytes, Progress progress) {
  std::error_code ignored;
  const auto kind = std::filesystem::status(m_target, ignored).type();
  if (kind == std::filesystem::file_type::directory) return writeFailed(m_path, std::strerror(EISDIR));
  if (kind == std::filesystem::file_type::character) return writeToDevice(m_path, bytes, progress);
  // A rename would replace the pipe or disk by a file.
  if (kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found &&
      kind != std::filesystem::file_type::none) {
    return writeFailed(m_path, "Not a regular file");
  }
  m_draft.emplace(m_target);
  const int file = m_draft->descriptor();
  if (file < 0 || !takeOver(m_target, file)) return writeFailed(m_path, systemReason());
  if (const Status written = writeBlocks(m_path, file, bytes, progress); !written) return written;
  if (!synchronise(file)) return writeFailed(m_path, systemReason());
  m_folder = ::open(folderOf(m_target).c_str(), kFolder);
  return m_folder >= 0 || errno == EACCES ? Status(Done{}) : Status(writeFailed(m_path, systemReason()));
}

Status Replacement::replaceTarget() {
  if (!m_draft) return Done{};
  if (!m_draft->replaceTarget()) return writeFailed(m_path, systemReason());
  return m_folder < 0 || synchronise(m_folder) ? Status(Done{}) : Status(writeFailed(m_path, systemReason()));
}

}  // namespace

Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes, Progress progress) {
  const FileContent file{path, bytes};
  return writeFilesAtomically({&file, 1}, progress);
}

Status writeFilesAtomically(std::span<const FileContent> files, Progress progress) {
  const BeingWritten counted;
  const Error cancelled{ErrorCode::Cancelled, {}, {}, {}};
  if (progress.cancelled()) return cancelled;
  std::vector<std::unique_ptr<Replacement>> replacements;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto at = static_cast<double>(i), count = static_cast<double>(files.size());
    replacements.push_back(std::make_unique<Replacement>(files[i].path));
    const Status prepared = replacements.back()->prepare(files[i].bytes, progress.part(at / count, (at + 1.0) / count));
    if (!prepared) return prepared;
  }
  if (progress.cancelled()) return cancelled;
  for (const auto& replacement : replacements) {
    if (const Status placed = replacement->replaceTarget(); !placed) return placed;
  }
  return Done{};
}

bool syncFolder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), kFolder);
  if (descriptor < 0) return errno == EACCES;  // a folder one may write to but not list cannot be synchronised
  const bool synced = synchronise(descriptor);
  ::close(descriptor);
  return synced;
}

bool isWritingFile() {
  return filesBeingWritten != 0;
}

}  // namespace handwheel
