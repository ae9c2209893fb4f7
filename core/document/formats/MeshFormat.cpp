// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshFormat.h"

#include "document/formats/FormatDetection.h"
#include "document/formats/MeshWriter.h"
#include "document/formats/ObjReader.h"
#include "document/formats/OffReader.h"
#include "document/formats/PlyReader.h"
#include "document/formats/StlReader.h"
#include "document/formats/TextNumber.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

namespace handwheel {

namespace {

Result<MeshFile> readAs(MeshFormat format, std::string_view bytes, const ReadOptions& options, Progress progress) {
  switch (format) {
    case MeshFormat::Stl:
      return readStl(bytes, options, progress);
    case MeshFormat::Ply:
      return readPly(bytes, options, progress);
    case MeshFormat::Obj:
      return readObj(bytes, options, progress);
    case MeshFormat::Off:
      break;
  }
  return readOff(bytes, options, progress);
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Error unreadable(int number) {
  return {ErrorCode::FileUnreadable, {std::generic_category().message(number)}, {}, {}};
}

// In blocks, for progress and cancellation. Not memory-mapped: another program that cuts the file would kill us.
Result<std::string> readAll(const std::filesystem::path& path, Progress progress) {
  std::error_code failed;
  const auto status = std::filesystem::status(path, failed);
  if (std::filesystem::is_directory(status)) return unreadable(EISDIR);
  // A device or a pipe may never end.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return Error{ErrorCode::FileUnreadable, {"Not a regular file"}, {}, {}};
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file && errno == ENOENT) return Error{ErrorCode::FileMissing, {}, {}, {}};
  if (!file) return unreadable(errno);
  constexpr std::size_t kBlock = std::size_t{4} << 20;
  const auto expected = std::filesystem::file_size(path, failed);
  std::string bytes;
  if (!failed) bytes.reserve(static_cast<std::size_t>(expected) + kBlock);
  for (;;) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    const std::size_t before = bytes.size();
    bytes.resize(before + kBlock);
    const std::size_t got = std::fread(bytes.data() + before, 1, kBlock, file.get());
    bytes.resize(before + got);
    if (std::ferror(file.get())) return unreadable(errno);
    if (got < kBlock) return bytes;
    if (!failed && expected > 0)
      progress.set(std::min(1.0, static_cast<double>(bytes.size()) / static_cast<double>(expected)));
  }
}

Error outOfMemory() {
  return {ErrorCode::OutOfMemory, {}, {}, {}};
}

}  // namespace

Result<MeshFile> readMesh(std::string_view bytes, std::string_view nameHint, const ReadOptions& options,
                          Progress progress) {
  try {
    const Result<MeshFormat> format = detectFormat(bytes, nameHint);
    if (!format) return format.error();
    return readAs(*format, bytes, options, progress);
  } catch (const std::bad_alloc&) {
    return outOfMemory();
  } catch (const std::length_error&) {
    return outOfMemory();
  }
}

Result<MeshFile> readMeshFile(const std::filesystem::path& path, const ReadOptions& options, Progress progress) {
  const auto read = [&]() -> Result<MeshFile> {
    try {
      const Result<std::string> bytes = readAll(path, progress.part(0.0, 0.2));
      if (!bytes) return bytes.error();
      return readMesh(*bytes, path.filename().string(), options, progress.part(0.2, 1.0));
    } catch (const std::bad_alloc&) {
      return outOfMemory();
    } catch (const std::length_error&) {
      return outOfMemory();
    }
  };
  Result<MeshFile> file = read();
  if (file) return file;
  Error error = file.error();
  error.subject = path.string();
  return error;
}

std::optional<MeshFormat> formatForName(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {};
  const std::string_view extension = name.substr(dot + 1);
  if (equalsIgnoringCase(extension, "stl")) return MeshFormat::Stl;
  if (equalsIgnoringCase(extension, "ply")) return MeshFormat::Ply;
  if (equalsIgnoringCase(extension, "obj")) return MeshFormat::Obj;
  if (equalsIgnoringCase(extension, "off")) return MeshFormat::Off;
  return {};
}

NumberType numberTypeOf(MeshFormat format, NumberType documentNumbers) {
  return format == MeshFormat::Stl ? NumberType::Float32 : documentNumbers;
}

std::string writeMesh(const TriangleSoup& soup, MeshFormat format, NumberType numbers) {
  switch (format) {
    case MeshFormat::Stl:
      return writeStl(soup);
    case MeshFormat::Ply:
      return writePly(soup, numbers);
    case MeshFormat::Obj:
      return writeObj(soup, numbers);
    case MeshFormat::Off:
      break;
  }
  return writeOff(soup, numbers);
}

}  // namespace handwheel
