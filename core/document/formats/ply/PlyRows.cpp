// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/ply/PlyRows.h"

#include "base/ByteOrder.h"
#include "document/formats/MeshFileErrors.h"
#include "document/formats/MeshTextValues.h"

#include <cmath>
#include <limits>

namespace handwheel {

namespace {

NumberType numberTypeFor(PlyType type) {
  return type == PlyType::Float32 ? NumberType::Float32 : NumberType::Float64;
}

double loadValue(const char* at, PlyType type, std::endian order) {
  switch (type) {
    case PlyType::Int8:
      return loadNumber<std::int8_t>(at, order);
    case PlyType::UInt8:
      return loadNumber<std::uint8_t>(at, order);
    case PlyType::Int16:
      return loadNumber<std::int16_t>(at, order);
    case PlyType::UInt16:
      return loadNumber<std::uint16_t>(at, order);
    case PlyType::Int32:
      return loadNumber<std::int32_t>(at, order);
    case PlyType::UInt32:
      return loadNumber<std::uint32_t>(at, order);
    case PlyType::Int64:
      return static_cast<double>(loadNumber<std::int64_t>(at, order));
    case PlyType::UInt64:
      return static_cast<double>(loadNumber<std::uint64_t>(at, order));
    case PlyType::Float32:
      return static_cast<double>(loadNumber<float>(at, order));
    case PlyType::Float64:
      break;
  }
  return loadNumber<double>(at, order);
}

}  // namespace

RowState PlyTextRows::number(PlyType type, double& value) {
  const std::string_view next = word();
  ErrorCode why = ErrorCode::NumberNotFinite;
  const bool isNumber = !next.empty() && parseNumber(next, value, why);
  value = isNumber ? rounded(value, numberTypeFor(type)) : std::numeric_limits<double>::quiet_NaN();
  if (std::isfinite(value)) return RowState::Good;
  // The next of rows that run on is found only by reading this one to its end.
  return m_runsOn && !next.empty() ? RowState::Good : bad(why, next);
}

RowState PlyTextRows::integer(PlyType, std::int64_t& value) {
  const std::string_view next = word();
  const auto parsed = parseInteger(next);
  if (!parsed) return refuse(unexpectedWord("a whole number", next, m_scanner.inputPosition()));
  value = *parsed;
  return RowState::Good;
}

RowState PlyTextRows::skip(PlyType, std::uint64_t numbers) {
  for (std::uint64_t i = 0; i < numbers; ++i)
    if (word().empty()) return refuse(unexpectedWord("a number", {}, m_scanner.inputPosition()));
  return RowState::Good;
}

RowState PlyTextRows::end() {
  if (m_runsOn) return RowState::Good;
  const std::string_view next = word();
  if (!next.empty()) return refuse(unexpectedWord(kEndOfLine, next, m_scanner.inputPosition()));
  m_scanner.nextLine();
  return RowState::Good;
}

RowState PlyTextRows::refuse(Error error) {
  m_error = std::move(error);
  return m_runsOn ? RowState::Ended : RowState::Bad;
}

RowState PlyTextRows::bad(ErrorCode why, std::string_view word) {
  m_error = word.empty() ? unexpectedWord("a number", word, m_scanner.inputPosition())
                         : wordError(why, word, m_scanner.inputPosition());
  return RowState::Bad;
}

PlyBinaryRows::PlyBinaryRows(std::string_view bytes, const PlyHeader& header)
    : m_bytes(bytes),
      m_at(header.bodyAt),
      m_order(header.encoding == PlyEncoding::BigEndian ? std::endian::big : std::endian::little) {}

RowState PlyBinaryRows::number(PlyType type, double& value) {
  if (m_bytes.size() - m_at < sizeOf(type)) return ended();
  const double loaded = loadValue(m_bytes.data() + m_at, type, m_order);
  value = loaded == 0.0 ? 0.0 : loaded;  // -0 becomes 0
  m_at += sizeOf(type);
  return RowState::Good;
}

RowState PlyBinaryRows::integer(PlyType type, std::int64_t& value) {
  const InputPosition start = inputPosition();
  double real = 0.0;
  if (number(type, real) != RowState::Good) return RowState::Ended;
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (!(std::abs(real) <= kExact) || real != std::trunc(real))
    return refuse({MeshFileError::TokenUnexpected, {"a whole number", std::to_string(real)}, start, {}});
  value = static_cast<std::int64_t>(real);
  return RowState::Good;
}

RowState PlyBinaryRows::skip(PlyType type, std::uint64_t numbers) {
  if (numbers > (m_bytes.size() - m_at) / sizeOf(type)) return ended();
  m_at += static_cast<std::size_t>(numbers) * sizeOf(type);
  return RowState::Good;
}

// The position of the next row is unknown from here on.
RowState PlyBinaryRows::refuse(Error error) {
  m_error = std::move(error);
  return RowState::Ended;
}

RowState PlyBinaryRows::ended() {
  return refuse({ErrorCode::DataTruncated,
                 {"bytes", "", std::to_string(m_bytes.size())},
                 InputPosition::byte(m_bytes.size()),
                 {}});
}

bool PlyBinaryRows::hasExcess() const {
  return m_bytes.find_first_not_of(" \t\r\n", m_at) != std::string_view::npos;
}

}  // namespace handwheel
