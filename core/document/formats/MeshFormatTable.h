// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/formats/MeshFormat.h"

namespace handwheel {

// A mesh file format with everything that the program has for it. To add one, write its reader and add its row to the
// table in MeshFormatTable.cpp: dialogs, help pages, errors and the command line follow.
struct MeshFormatRow {
  std::string_view name;                  // "STL"
  std::vector<std::string_view> endings;  // lower case with the dot: ".stl"; the first is that of new files
  // True if bytes are surely of this format, independently of their meaning as text.
  bool (*isBinary)(std::string_view bytes) = nullptr;
  bool (*isText)(std::string_view bytes) = nullptr;  // called after all isBinary, for text in single bytes
  bool hasAnyBytes = false;  // a file with this extension may be binary without a mark of its format
  Result<MeshFile> (*read)(std::string_view bytes, const ReadOptions& options, Progress progress);
  // Null: the format is only read.
  std::string (*write)(const TriangleSoup& soup, NumberType numbers, Progress progress) = nullptr;
  std::optional<NumberType> numbers = {};  // type of its coordinates; none: either
};

// The table of formats. A MeshFormat is the index of a row in it.
class MeshFormatTable {
 public:
  explicit MeshFormatTable(std::vector<MeshFormatRow> rows) : m_rows(std::move(rows)) {}

  std::span<const MeshFormatRow> rows() const { return m_rows; }
  const MeshFormatRow& row(MeshFormat format) const { return m_rows.at(static_cast<std::size_t>(format)); }

  // See the functions in MeshFormat.h and meshFileFormats().
  std::optional<MeshFormat> forName(std::string_view name) const;
  Result<MeshFile> read(std::string_view bytes, std::string_view nameHint, const ReadOptions& options,
                        Progress progress = {}) const;
  std::string write(const TriangleSoup& soup, MeshFormat format, NumberType numbers, Progress progress = {}) const;
  std::vector<FileFormat> fileFormats() const;

  // Returns the format of a file by its content, and by its name if that is ambiguous. Errors: FileEmpty, TextEncoding,
  // FormatUnknown.
  Result<MeshFormat> detect(std::string_view bytes, std::string_view name) const;

 private:
  std::optional<MeshFormat> find(bool (*MeshFormatRow::*is)(std::string_view), std::string_view bytes) const;

  std::vector<MeshFormatRow> m_rows;
};

// Returns the table of all mesh formats that the program knows.
const MeshFormatTable& meshFormatTable();

}  // namespace handwheel
