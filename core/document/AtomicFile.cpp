// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/AtomicFile.h"

#include <fcntl.h>
#include <unistd.h>
#include <QFile>
#include <QSaveFile>
#include <atomic>
#include <cerrno>
#include <cstring>

namespace handwheel {

namespace {

constexpr std::size_t kBlock = 1 << 20;

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

// The path itself, or what the link leads to, which need not exist.
std::filesystem::path linkTarget(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto resolved = std::filesystem::weakly_canonical(path, ignored);
  return ignored || resolved.empty() ? path : resolved;
}

// Straight to the descriptor: QSaveFile loses the reason ("Unknown error") when a disk fills up half-way through a
// block.
bool writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

// After the rename: without this the folder may still name the old file after a power cut.
bool syncFolderOf(const std::filesystem::path& target) {
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES;  // a folder one may write to but not list cannot be synchronised
  const bool synced = ::fsync(descriptor) == 0 || errno == EINVAL;  // EINVAL: the file system has no such thing
  ::close(descriptor);
  return synced;
}

}  // namespace

Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes, Progress progress) {
  const std::filesystem::path target = linkTarget(path);
  std::error_code ignored;
  const auto kind = std::filesystem::status(target, ignored).type();
  if (kind == std::filesystem::file_type::directory) return writeFailed(path, std::strerror(EISDIR));
  // A rename would put a file in the place of the device or pipe.
  if (kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found &&
      kind != std::filesystem::file_type::none) {
    return writeFailed(path, "Not a regular file");
  }
  const QString name = QFile::decodeName(target.c_str());
  if (QFile::encodeName(name) != target.c_str()) return writeFailed(path, "The name is not UTF-8");

  const BeingWritten counted;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  QSaveFile file(name);
  if (!file.open(QIODevice::WriteOnly)) return writeFailed(path, file.errorString().toStdString());
  for (std::size_t start = 0; start < bytes.size(); start += kBlock) {
    if (!writeAll(file.handle(), bytes.substr(start, kBlock))) return writeFailed(path, systemReason());
    progress.set(static_cast<double>(start) / static_cast<double>(bytes.size()));
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  }
  // QSaveFile synchronises too but keeps quiet about a failure, such as a disk quota found exceeded this late.
  if (::fsync(file.handle()) != 0 && errno != EINVAL) return writeFailed(path, systemReason());
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (!file.commit()) return writeFailed(path, file.errorString().toStdString());
  if (!syncFolderOf(target)) return writeFailed(path, systemReason());
  return Done{};
}

bool isWritingFile() {
  return filesBeingWritten != 0;
}

}  // namespace handwheel
