// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshFormat.h"

#include "document/FileBytes.h"
#include "document/formats/MeshFormatTable.h"

#include <new>
#include <stdexcept>

namespace handwheel {

namespace {

Error outOfMemory() {
  return {ErrorCode::OutOfMemory, {}, {}, {}};
}

}  // namespace

Result<MeshFile> readMesh(std::string_view bytes, std::string_view nameHint, const ReadOptions& options,
                          Progress progress) {
  try {
    return meshFormatTable().read(bytes, nameHint, options, progress);
  } catch (const std::bad_alloc&) {
    return outOfMemory();
  } catch (const std::length_error&) {
    return outOfMemory();
  }
}

Result<MeshFile> readMeshFile(const std::filesystem::path& path, const ReadOptions& options, Progress progress) {
  const auto read = [&]() -> Result<MeshFile> {
    try {
      const Result<std::string> bytes = readFileBytes(path, progress.part(0.0, 0.2));
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
  return meshFormatTable().forName(name);
}

NumberType numberTypeOf(MeshFormat format, NumberType documentNumbers) {
  return meshFormatTable().row(format).numbers.value_or(documentNumbers);
}

std::string writeMesh(const TriangleSoup& soup, MeshFormat format, NumberType numbers, Progress progress) {
  return meshFormatTable().write(soup, format, numbers, progress);
}

}  // namespace handwheel
