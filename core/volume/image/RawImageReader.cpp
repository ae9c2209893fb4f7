// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/RawImageReader.h"

#include "base/JsonText.h"
#include "volume/image/ImageHeader.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

using nlohmann::json;

Error rawMalformed(const char* key, const char* why) {
  return imageHeader::malformed(key, why);
}

// Three numbers under a key; the others where it is missing.
Result<Vec3> threeAt(const json& object, const char* key, const Vec3& otherwise) {
  if (!object.contains(key)) return otherwise;
  const std::vector<double> numbers = numbersAt(object, key, 4);
  if (numbers.size() != 3) return rawMalformed(key, "it is not three numbers");
  return Vec3(numbers[0], numbers[1], numbers[2]);
}

Result<double> oneAt(const json& object, const char* key, double otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_number()) return rawMalformed(key, "it is not a number");
  return found->get<double>();
}

Result<ImageGrid> rawGrid(const json& object) {
  ImageGrid grid;
  const Result<Vec3> size = threeAt(object, "size", Vec3::Zero());
  if (!size) return size.error();
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = (*size)[static_cast<Eigen::Index>(k)];
    if (!(n >= 1.0 && n <= 1e9 && n == std::floor(n)))
      return rawMalformed("size", "it is not three numbers of samples");
    grid.size[k] = static_cast<int>(n);
  }
  const Result<Vec3> spacing = threeAt(object, "spacing", Vec3::Ones());
  if (!spacing) return spacing.error();
  const Result<Vec3> origin = threeAt(object, "origin", Vec3::Zero());
  if (!origin) return origin.error();
  grid.origin = *origin;
  if (const auto found = object.find("directions"); found != object.end()) {
    if (!found->is_array() || found->size() != 3) return rawMalformed("directions", "it is not three vectors");
    for (std::size_t k = 0; k < 3; ++k) {
      const Result<Vec3> one = threeAt(json{{"directions", (*found)[k]}}, "directions", Vec3::Zero());
      if (!one) return one.error();
      grid.steps.col(static_cast<Eigen::Index>(k)) = *one;
    }
  }
  grid.steps = grid.steps * spacing->asDiagonal();
  return grid;
}

Result<SampleLayout> rawLayout(const json& object) {
  static const std::map<std::string, SampleType, std::less<>> kTypes = {
      {"int8", SampleType::Int8},      {"uint8", SampleType::UInt8},   {"int16", SampleType::Int16},
      {"uint16", SampleType::UInt16},  {"int32", SampleType::Int32},   {"uint32", SampleType::UInt32},
      {"int64", SampleType::Int64},    {"uint64", SampleType::UInt64}, {"float32", SampleType::Float32},
      {"float64", SampleType::Float64}};
  const auto type = kTypes.find(stringAt(object, "type"));
  if (type == kTypes.end()) return rawMalformed("type", "it is not a type of numbers");
  SampleLayout layout;
  layout.type = type->second;
  const std::string endian = stringAt(object, "endian", "little");
  if (endian != "little" && endian != "big") return rawMalformed("endian", "it is neither little nor big");
  layout.order = endian == "big" ? std::endian::big : std::endian::little;
  const Result<double> slope = oneAt(object, "slope", 1.0), intercept = oneAt(object, "intercept", 0.0);
  if (!slope) return slope.error();
  if (!intercept) return intercept.error();
  layout.slope = *slope;
  layout.intercept = *intercept;
  return layout;
}

}  // namespace

bool looksLikeRawImage(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || bytes[first] != '{') return false;
  const std::string_view start = bytes.substr(0, 1024);
  const auto has = [&](std::string_view key) { return start.find(key) != std::string_view::npos; };
  return has("\"raw\"") && has("\"size\"") && has("\"type\"");
}

Result<ImageFile> readRawImage(std::string_view description, const SiblingFile& sibling) {
  const Result<json> object = parseJson(description, "description");
  if (!object) return object.error();
  if (!object->is_object()) return rawMalformed("description", "it is not an object");
  const std::string name = stringAt(*object, "raw");
  if (name.empty()) return rawMalformed("raw", "it names no file");
  const Result<ImageGrid> grid = rawGrid(*object);
  if (!grid) return grid.error();
  if (const Status checked = checkGrid(*grid); !checked) return checked.error();
  const Result<SampleLayout> layout = rawLayout(*object);
  if (!layout) return layout.error();
  constexpr std::uint64_t kMostSkipped = std::uint64_t{1} << 30;
  const std::uint64_t skip = countAt(*object, "skip");
  if (skip > kMostSkipped) return rawMalformed("skip", "it is more than the file contains");
  const Result<std::string> data = sibling(name, skip + bytesOf(*grid, *layout));
  if (!data) return data.error();
  const std::string_view all = *data;
  Result<ImageFile> read = imageOfBytes(*grid, *layout, all.substr(std::min<std::size_t>(skip, all.size())));
  if (read && !object->contains("spacing")) read->remarks.push_back({ImageRemark::Kind::NoSpacing, {}});
  return read;
}

}  // namespace handwheel
