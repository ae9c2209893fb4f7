// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshFormat.h"

#include "document/FileBytes.h"
#include "document/formats/FormatDetection.h"
#include "document/formats/MeshWriter.h"
#include "document/formats/ObjReader.h"
#include "document/formats/TextNumber.h"
#include "document/formats/off/OffReader.h"
#include "document/formats/ply/PlyReader.h"
#include "document/formats/stl/StlReader.h"
#include "document/formats/threemf/ThreeMfReader.h"
#include "document/formats/threemf/ThreeMfWriter.h"

#include <new>
#include <stdexcept>

namespace handwheel {

namespace {

constexpr std::pair<std::string_view, MeshFormat> kEndings[] = {{".stl", MeshFormat::Stl},
                                                                {".ply", MeshFormat::Ply},
                                                                {".obj", MeshFormat::Obj},
                                                                {".off", MeshFormat::Off},
                                                                {".3mf", MeshFormat::ThreeMf}};

Result<MeshFile> readAs(MeshFormat format, std::string_view bytes, const ReadOptions& options, Progress progress) {
  switch (format) {
    case MeshFormat::Stl:
      return readStl(bytes, options, progress);
    case MeshFormat::Ply:
      return readPly(bytes, options, progress);
    case MeshFormat::Obj:
      return readObj(bytes, options, progress);
    case MeshFormat::ThreeMf:
      return readThreeMf(bytes, options, progress);
    case MeshFormat::Off:
      break;
  }
  return readOff(bytes, options, progress);
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

std::vector<std::string> meshEndings() {
  std::vector<std::string> all;
  for (const auto& [ending, format] : kEndings) all.emplace_back(ending);
  return all;
}

std::optional<MeshFormat> formatForName(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {};
  for (const auto& [ending, format] : kEndings) {
    if (equalsIgnoringCase(name.substr(dot), ending)) return format;
  }
  return {};
}

NumberType numberTypeOf(MeshFormat format, NumberType documentNumbers) {
  return format == MeshFormat::Stl ? NumberType::Float32 : documentNumbers;
}

std::string writeMesh(const TriangleSoup& soup, MeshFormat format, NumberType numbers, Progress progress) {
  switch (format) {
    case MeshFormat::Stl:
      return writeStl(soup, progress);
    case MeshFormat::Ply:
      return writePly(soup, numbers, progress);
    case MeshFormat::Obj:
      return writeObj(soup, numbers, progress);
    case MeshFormat::ThreeMf:
      return writeThreeMf(soup, numbers, progress);
    case MeshFormat::Off:
      break;
  }
  return writeOff(soup, numbers, progress);
}

}  // namespace handwheel
