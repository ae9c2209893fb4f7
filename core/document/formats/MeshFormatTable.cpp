// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshFormatTable.h"

#include "document/DocumentErrors.h"
#include "document/formats/MeshFileErrors.h"
#include "document/formats/MeshTextValues.h"
#include "document/formats/MeshWriter.h"
#include "document/formats/ObjReader.h"
#include "document/formats/off/OffHeader.h"
#include "document/formats/off/OffReader.h"
#include "document/formats/ply/PlyReader.h"
#include "document/formats/step/StepReader.h"
#include "document/formats/stl/StlReader.h"
#include "document/formats/threemf/ThreeMfReader.h"
#include "document/formats/threemf/ThreeMfWriter.h"

#include <algorithm>

namespace handwheel {

namespace {

std::string writeAnyStl(const TriangleSoup& soup, NumberType, Progress progress) {
  return writeStl(soup, progress);
}

// Returns the encoding of a text in wide characters; empty for single bytes. Without a mark: ASCII characters with a
// NUL before or after each.
std::string_view wideEncoding(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv)) return "UTF-16";
  constexpr std::size_t kProbe = 32;
  if (bytes.size() < kProbe) return {};
  for (std::size_t nul : {0u, 1u}) {
    bool wide = true;
    for (std::size_t i = 0; i < kProbe; ++i) wide &= (bytes[i] == '\0') == (i % 2 == nul);
    if (wide) return "UTF-16";
  }
  return {};
}

// Returns true if the beginning has no control characters other than line ends.
bool isPlainText(std::string_view bytes) {
  constexpr std::size_t kProbe = 1024;
  return std::all_of(
      bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), kProbe)),
      [](char c) { return static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\r' || c == '\t'; });
}

}  // namespace

// The first rows are in the order of MeshFormat.
const MeshFormatTable& meshFormatTable() {
  static const MeshFormatTable table({
      {.name = "STL",
       .endings = {".stl"},
       .isBinary = isWholeBinaryStl,
       .isText = isTextStl,
       .hasAnyBytes = true,
       .read = readStl,
       .write = writeAnyStl,
       .numbers = NumberType::Float32},
      {.name = "PLY", .endings = {".ply"}, .isBinary = looksLikePly, .read = readPly, .write = writePly},
      {.name = "OBJ", .endings = {".obj"}, .isText = looksLikeObj, .read = readObj, .write = writeObj},
      {.name = "OFF", .endings = {".off"}, .isText = beginsWithOffKeyword, .read = readOff, .write = writeOff},
      {.name = "3MF", .endings = {".3mf"}, .isBinary = looksLikeThreeMf, .read = readThreeMf, .write = writeThreeMf},
      {.name = "STEP", .endings = {".step", ".stp"}, .isText = looksLikeStep, .read = readStep},
  });
  return table;
}

std::optional<MeshFormat> MeshFormatTable::forName(std::string_view name) const {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {};
  const auto has = [ending = name.substr(dot)](const MeshFormatRow& row) {
    return std::any_of(row.endings.begin(), row.endings.end(),
                       [&](std::string_view each) { return equalsIgnoringCase(ending, each); });
  };
  const auto found = std::find_if(m_rows.begin(), m_rows.end(), has);
  if (found == m_rows.end()) return {};
  return static_cast<MeshFormat>(found - m_rows.begin());
}

std::optional<MeshFormat> MeshFormatTable::find(bool (*MeshFormatRow::*is)(std::string_view),
                                                std::string_view bytes) const {
  const auto found =
      std::find_if(m_rows.begin(), m_rows.end(), [&](const MeshFormatRow& row) { return row.*is && (row.*is)(bytes); });
  if (found == m_rows.end()) return {};
  return static_cast<MeshFormat>(found - m_rows.begin());
}

Result<MeshFormat> MeshFormatTable::detect(std::string_view bytes, std::string_view name) const {
  if (bytes.empty()) return Error{ErrorCode::FileEmpty, {}, {}, {}};
  if (const auto format = find(&MeshFormatRow::isBinary, bytes)) return *format;
  const auto named = forName(name);
  if (const auto wide = wideEncoding(bytes); !wide.empty() && !(named && row(*named).hasAnyBytes))
    return Error{MeshFileError::TextEncoding, {std::string(wide)}, {}, {}};
  if (const auto format = find(&MeshFormatRow::isText, bytes)) return *format;
  // Plain text with the extension of a format of arbitrary bytes, such as a note, is of no format.
  if (named && !(row(*named).hasAnyBytes && isPlainText(bytes))) return *named;
  std::vector<std::string> known;
  for (const FileFormat& format : fileFormats())
    known.insert(known.end(), format.endings.begin(), format.endings.end());
  return Error{DocumentError::FormatUnknown, std::move(known), {}, {}};
}

Result<MeshFile> MeshFormatTable::read(std::string_view bytes, std::string_view nameHint, const ReadOptions& options,
                                       Progress progress) const {
  const Result<MeshFormat> format = detect(bytes, nameHint);
  if (!format) return format.error();
  Result<MeshFile> file = row(*format).read(bytes, options, progress);
  if (file) file->format = *format;
  return file;
}

std::string MeshFormatTable::write(const TriangleSoup& soup, MeshFormat format, NumberType numbers,
                                   Progress progress) const {
  return row(format).write(soup, numbers, progress);
}

std::vector<FileFormat> MeshFormatTable::fileFormats() const {
  std::vector<FileFormat> all;
  for (const MeshFormatRow& row : m_rows)
    all.push_back({std::string(row.name), {row.endings.begin(), row.endings.end()}, true, row.write != nullptr});
  return all;
}

}  // namespace handwheel
