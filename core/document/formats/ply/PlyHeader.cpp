// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/ply/PlyHeader.h"

#include "document/formats/MeshFileErrors.h"
#include "document/formats/MeshTextValues.h"

#include <algorithm>

namespace handwheel {

namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr TypeName kTypeNames[] = {
    {"char", PlyType::Int8},       {"int8", PlyType::Int8},      {"uchar", PlyType::UInt8},
    {"uint8", PlyType::UInt8},     {"short", PlyType::Int16},    {"int16", PlyType::Int16},
    {"ushort", PlyType::UInt16},   {"uint16", PlyType::UInt16},  {"int", PlyType::Int32},
    {"int32", PlyType::Int32},     {"uint", PlyType::UInt32},    {"uint32", PlyType::UInt32},
    {"int64", PlyType::Int64},     {"uint64", PlyType::UInt64},  {"float", PlyType::Float32},
    {"float32", PlyType::Float32}, {"double", PlyType::Float64}, {"float64", PlyType::Float64},
};

class HeaderParser {
 public:
  explicit HeaderParser(std::string_view bytes) : m_bytes(bytes), m_scanner(bytes) {}

  Result<PlyHeader> read() {
    if (m_scanner.wordOnAnyLine() != "ply") return malformed("ply");
    // Files for old Macs end their lines with CR; then a line feed after the header belongs to the body.
    const std::size_t end = m_scanner.position();
    m_carriageReturnOnly = m_bytes.substr(end, 1) == "\r" && m_bytes.substr(end, 2) != "\r\n";
    while (!m_done && m_scanner.nextLine())
      if (!readLine()) return m_error;
    if (!m_done) return malformed("end_header");
    if (!m_formatKnown) return malformed("format");
    return std::move(m_header);
  }

 private:
  bool readLine() {
    const std::string_view word = m_scanner.word();
    if (word == "format") return readFormat();
    if (word == "element") return readElement();
    if (word == "property") return readProperty();
    if (word == "end_header") return endHeader();
    if (word.empty() || word == "comment" || word == "obj_info") return true;
    m_error = unexpectedWord("end_header", word, m_scanner.inputPosition());
    return false;
  }

  bool readFormat() {
    const std::string_view word = m_scanner.word();
    if (word == "ascii")
      m_header.encoding = PlyEncoding::Text;
    else if (word == "binary_little_endian")
      m_header.encoding = PlyEncoding::LittleEndian;
    else if (word == "binary_big_endian")
      m_header.encoding = PlyEncoding::BigEndian;
    else
      return fail(wordError(MeshFileError::TypeUnknown, word, m_scanner.inputPosition()));
    m_formatKnown = true;
    return true;
  }

  bool readElement() {
    const std::string_view name = m_scanner.word(), count = m_scanner.word();
    const auto value = parseInteger(count);
    if (!value || *value < 0) return fail(unexpectedWord("a count", count, m_scanner.inputPosition()));
    m_header.elements.push_back({std::string(name), static_cast<std::uint64_t>(*value), {}});
    return true;
  }

  bool readProperty() {
    if (m_header.elements.empty()) return fail(malformed("element"));
    PlyProperty property;
    std::string_view type = m_scanner.word();
    if (type == "list") {
      PlyType countType;
      if (!readType(m_scanner.word(), countType)) return false;
      property.countType = countType;
      type = m_scanner.word();
    }
    if (!readType(type, property.type)) return false;
    property.name = std::string(m_scanner.word());
    m_header.elements.back().properties.push_back(std::move(property));
    return true;
  }

  bool readType(std::string_view word, PlyType& type) {
    const auto* found = std::find_if(std::begin(kTypeNames), std::end(kTypeNames),
                                     [&](const TypeName& known) { return known.name == word; });
    if (found == std::end(kTypeNames))
      return fail(wordError(MeshFileError::TypeUnknown, word, m_scanner.inputPosition()));
    type = found->type;
    return true;
  }

  bool endHeader() {
    m_done = true;
    m_header.bodyLine = m_scanner.inputPosition().value + 1;
    while (!m_scanner.word().empty()) {
    }
    std::size_t at = m_scanner.position();
    if (m_bytes.substr(at, 2) == "\r\n" && !m_carriageReturnOnly) ++at;
    m_header.bodyAt = std::min(at + 1, m_bytes.size());
    return true;
  }

  Error malformed(const char* expected) const {
    return {ErrorCode::HeaderMalformed, {expected}, m_scanner.inputPosition(), {}};
  }

  bool fail(Error error) {
    m_error = std::move(error);
    return false;
  }

  std::string_view m_bytes;
  TextScanner m_scanner;
  PlyHeader m_header;
  Error m_error;
  bool m_carriageReturnOnly = false;
  bool m_formatKnown = false;
  bool m_done = false;
};

}  // namespace

std::size_t sizeOf(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> readPlyHeader(std::string_view bytes) {
  return HeaderParser(bytes).read();
}

}  // namespace handwheel
