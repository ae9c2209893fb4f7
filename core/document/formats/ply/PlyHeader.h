// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Number type of a PLY property.
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };
std::size_t sizeOf(PlyType type);  // bytes of a number

// A property of a PLY element.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;   // type of the items, for a list
  std::optional<PlyType> countType;  // for a list only
};

// An element declared in a PLY header.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

// Encoding of the body of a PLY file.
enum class PlyEncoding { Text, LittleEndian, BigEndian };

// The header of a PLY file.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Text;
  std::vector<PlyElement> elements;
  std::size_t bodyAt = 0;  // offset of the body, bytes
  std::uint64_t bodyLine = 0;
};

// Reads the header of a PLY file. Errors, with the line: HeaderMalformed, TypeUnknown, TokenUnexpected.
Result<PlyHeader> readPlyHeader(std::string_view bytes);

}  // namespace handwheel
