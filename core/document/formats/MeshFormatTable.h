// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/formats/MeshFormat.h"

namespace handwheel {

// A mesh file format with its reader and writer. To add a format, write its reader and add its row to the table in
// MeshFormatTable.cpp. Dialogs, help pages, errors and the command line use this table.
struct MeshFormatRow {
  std::string_view name;                  // "STL"
  std::vector<std::string_view> endings;  // lower case with the dot: ".stl"; new files get the first
  // Returns true if bytes are certainly of this format, whether they are text or not.
  bool (*isBinary)(std::string_view bytes) = nullptr;
  // Returns true if bytes are text of this format. It is called after isBinary of all formats, and not for UTF-16 or
  // UTF-32.
  bool (*isText)(std::string_view bytes) = nullptr;
  bool hasAnyBytes = false;  // a file with this extension may be binary without a signature of the format
  Result<MeshFile> (*read)(std::string_view bytes, const ReadOptions& options, Progress progress);
  // Function that encodes triangles; null: the format is only read.
  std::string (*write)(const TriangleSoup& soup, NumberType numbers, Progress progress) = nullptr;
  std::optional<NumberType> numbers = {};  // number type of its coordinates; nothing: any
};

// The table of formats. A MeshFormat is the index of a row in it.
class MeshFormatTable {
 public:
  explicit MeshFormatTable(std::vector<MeshFormatRow> rows) : m_rows(std::move(rows)) {}

  std::span<const MeshFormatRow> rows() const { return m_rows; }
  const MeshFormatRow& row(MeshFormat format) const { return m_rows.at(static_cast<std::size_t>(format)); }

  // Implements formatForName(). read(), write() and fileFormats() implement readMesh(), writeMesh() and
  // meshFileFormats().
  std::optional<MeshFormat> forName(std::string_view name) const;
  Result<MeshFile> read(std::string_view bytes, std::string_view nameHint, const ReadOptions& options,
                        Progress progress = {}) const;
  std::string write(const TriangleSoup& soup, MeshFormat format, NumberType numbers, Progress progress = {}) const;
  std::vector<FileFormat> fileFormats() const;

  // Returns the format of a file according to its content, or to its name if the content is ambiguous. Errors:
  // FileEmpty, TextEncoding, FormatUnknown.
  Result<MeshFormat> detect(std::string_view bytes, std::string_view name) const;

 private:
  std::optional<MeshFormat> find(bool (*MeshFormatRow::*is)(std::string_view), std::string_view bytes) const;

  std::vector<MeshFormatRow> m_rows;
};

// Returns the table of all mesh formats that the program knows.
const MeshFormatTable& meshFormatTable();

}  // namespace handwheel
