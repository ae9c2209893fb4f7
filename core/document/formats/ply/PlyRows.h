// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFileErrors.h"
#include "document/formats/TextScanner.h"
#include "document/formats/ply/PlyHeader.h"

#include <bit>
#include <cstdint>
#include <string_view>

namespace handwheel {

// Result of reading part of a row. After Bad the rest of the row is unusable, but the next row can be read. After Ended
// no further row can be read. error() then returns the reason.
enum class RowState { Good, Bad, Ended };

// A reader of the rows of a PLY body in text, with one row per line. It has the same functions as PlyBinaryRows. Rows
// may also run on over lines, as their properties tell where they end.
class PlyTextRows {
 public:
  PlyTextRows(std::string_view bytes, const PlyHeader& header) : m_scanner(bytes, header.bodyAt, header.bodyLine) {}

  // Returns false if there is no further row.
  bool begin() { return m_scanner.findWord(); }
  // Reads a number and rounds it as a file of this type stores it.
  RowState number(PlyType type, double& value);
  RowState integer(PlyType type, std::int64_t& value);
  RowState skip(PlyType type, std::uint64_t numbers);
  RowState end();
  // Sets the error of a row with an impossible value.
  RowState refuse(Error error);
  // Skips the rest of a bad row.
  void abandon() { m_scanner.nextLine(); }
  // Returns true if the line of a bad row has more or fewer words than the row.
  bool isOfOtherLength() const {
    return m_error.code == MeshFileError::TokenUnexpected &&
           (m_error.arguments[0] == kEndOfLine || m_error.arguments[1].empty());
  }
  // Reads rows that run on over lines from here on.
  void runOn() { m_runsOn = true; }
  TextScanner mark() const { return m_scanner; }
  void returnTo(const TextScanner& mark) { m_scanner = mark; }

  const Error& error() const { return m_error; }
  InputPosition inputPosition() const { return m_scanner.inputPosition(); }
  std::size_t position() const { return m_scanner.position(); }
  // Returns true if anything other than white space follows.
  bool hasExcess() { return m_scanner.findWord(); }

 private:
  static constexpr const char* kEndOfLine = "the end of the line";

  RowState bad(ErrorCode why, std::string_view word);
  std::string_view word() { return m_runsOn ? m_scanner.wordOnAnyLine() : m_scanner.word(); }

  TextScanner m_scanner;
  Error m_error;
  bool m_runsOn = false;
};

// A reader of the rows of a binary PLY body, which has no gaps or separators.
class PlyBinaryRows {
 public:
  PlyBinaryRows(std::string_view bytes, const PlyHeader& header);

  bool begin() const { return m_at < m_bytes.size(); }
  RowState number(PlyType type, double& value);
  RowState integer(PlyType type, std::int64_t& value);
  RowState skip(PlyType type, std::uint64_t numbers);
  RowState end() { return RowState::Good; }
  RowState refuse(Error error);
  void abandon() {}
  bool isOfOtherLength() const { return false; }  // no lines
  void runOn() {}
  std::size_t mark() const { return m_at; }
  void returnTo(std::size_t mark) { m_at = mark; }

  const Error& error() const { return m_error; }
  InputPosition inputPosition() const { return InputPosition::byte(m_at); }
  std::size_t position() const { return m_at; }
  bool hasExcess() const;

 private:
  RowState ended();

  std::string_view m_bytes;
  std::size_t m_at;
  std::endian m_order;
  Error m_error;
};

}  // namespace handwheel
