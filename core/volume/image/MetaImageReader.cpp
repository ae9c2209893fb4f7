// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/MetaImageReader.h"

#include "volume/image/ImageHeader.h"
#include "volume/image/Inflate.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

using namespace imageHeader;

constexpr std::size_t kMostMetaHeader = std::size_t{1} << 20;  // bytes

Error metaUnsupported(const char* what) {
  return {ErrorCode::Unsupported, {what}, {}, {}};
}

// The fields of a header by their names, and the offset of the data after the last one.
struct MetaFields {
  std::map<std::string, std::string_view, std::less<>> values;
  std::size_t end = 0;

  std::string_view operator[](std::string_view name) const {
    const auto found = values.find(name);
    return found == values.end() ? std::string_view() : found->second;
  }
  bool isTrue(std::string_view name) const { return lowered((*this)[name]) == "true"; }
  bool has(std::string_view name) const { return values.contains(name); }
};

Result<MetaFields> metaFieldsOf(std::string_view bytes) {
  std::string_view rest = bytes.substr(0, kMostMetaHeader);
  MetaFields fields;
  while (!rest.empty()) {
    const std::string_view line = takeLine(rest);
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos) {
      if (trimmed(line).empty()) continue;
      return Error{ErrorCode::HeaderMalformed, {"a line \"Field = value\""}, {}, {}};
    }
    const std::string name(trimmed(line.substr(0, sign)));
    fields.values[name] = trimmed(line.substr(sign + 1));
    fields.end = static_cast<std::size_t>(rest.data() - bytes.data());
    if (name == "ElementDataFile") return fields;  // always the last
  }
  return malformed("ElementDataFile", "it is missing");
}

std::optional<SampleType> metaType(std::string_view name) {
  static const std::map<std::string_view, SampleType> kTypes = {
      {"MET_CHAR", SampleType::Int8},       {"MET_UCHAR", SampleType::UInt8},       {"MET_SHORT", SampleType::Int16},
      {"MET_USHORT", SampleType::UInt16},   {"MET_INT", SampleType::Int32},         {"MET_UINT", SampleType::UInt32},
      {"MET_LONG_LONG", SampleType::Int64}, {"MET_ULONG_LONG", SampleType::UInt64}, {"MET_FLOAT", SampleType::Float32},
      {"MET_DOUBLE", SampleType::Float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) return {};
  return found->second;
}

// Returns the first existing one of these fields, as numbers; the default if there is none.
Result<std::vector<double>> metaNumbers(const MetaFields& fields, std::initializer_list<const char*> names,
                                        std::vector<double> otherwise) {
  for (const char* const name : names) {
    if (!fields.has(name)) continue;
    const auto numbers = numbersOf(fields[name], otherwise.size());
    if (!numbers) return malformed(name, "there are not as many numbers as it takes");
    return *numbers;
  }
  return otherwise;
}

Result<ImageGrid> gridOf(const MetaFields& fields, std::size_t axes) {
  std::vector<double> one(axes, 1.0), none(axes, 0.0), turn(axes * axes, 0.0);
  for (std::size_t k = 0; k < axes; ++k) turn[k * axes + k] = 1.0;
  const auto size = numbersOf(fields["DimSize"], axes);
  if (!size) return malformed("DimSize", "there are not as many numbers as it takes");
  const auto spacing = metaNumbers(fields, {"ElementSpacing", "ElementSize"}, one);
  if (!spacing) return spacing.error();
  const auto origin = metaNumbers(fields, {"Offset", "Position", "Origin"}, none);
  if (!origin) return origin.error();
  const auto matrix = metaNumbers(fields, {"TransformMatrix", "Rotation", "Orientation"}, turn);
  if (!matrix) return matrix.error();
  ImageGrid grid{{1, 1, 1}, Vec3::Zero(), Eigen::Matrix3d::Identity()};
  for (std::size_t k = 0; k < std::min<std::size_t>(axes, 3); ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double n = (*size)[k];
    if (!(n >= 1.0 && n <= 1e9 && n == static_cast<double>(static_cast<int>(n))))
      return malformed("DimSize", "one is not a number of samples");
    grid.size[k] = static_cast<int>(n);
    grid.origin[axis] = (*origin)[k];
    for (std::size_t row = 0; row < std::min<std::size_t>(axes, 3); ++row)  // a row of the file is an axis
      grid.steps(static_cast<Eigen::Index>(row), axis) = (*spacing)[k] * (*matrix)[k * axes + row];
  }
  return grid;
}

Result<SampleLayout> layoutOf(const MetaFields& fields) {
  SampleLayout layout;
  const auto type = metaType(fields["ElementType"]);
  if (!type) return malformed("ElementType", "it is not a type of numbers");
  layout.type = *type;
  const bool isBig = fields.isTrue("BinaryDataByteOrderMSB") || fields.isTrue("ElementByteOrderMSB");
  layout.order = isBig ? std::endian::big : std::endian::little;
  if (fields.has("ElementNumberOfChannels")) {
    const auto count = countOf(fields["ElementNumberOfChannels"]);
    if (!count || *count < 1 || *count > 1000)
      return malformed("ElementNumberOfChannels", "it is not a number of values");
    layout.perSample = *count;
  }
  return layout;
}

Result<ImageFile> metaSamples(const MetaFields& fields, const ImageGrid& grid, const SampleLayout& layout,
                              std::string_view data) {
  const std::size_t needed = bytesOf(grid, layout);
  const std::string_view header = fields["HeaderSize"];
  if (header == "-1") {
    data = data.substr(data.size() - std::min(data.size(), needed));
  } else if (!header.empty()) {
    const auto count = countOf(header);
    if (!count || *count > data.size()) return malformed("HeaderSize", "it is more than the file contains");
    data.remove_prefix(*count);
  }
  if (fields.has("BinaryData") && !fields.isTrue("BinaryData")) return imageOfText(grid, layout, data);
  if (!fields.isTrue("CompressedData")) return imageOfBytes(grid, layout, data);
  const Result<std::string> plain = inflated(data, needed);
  return plain ? imageOfBytes(grid, layout, *plain) : plain.error();
}

}  // namespace

bool looksLikeMetaImage(std::string_view bytes) {
  std::string_view rest = bytes.substr(0, 4096);
  const std::string_view first = trimmed(takeLine(rest));
  return (first.starts_with("ObjectType") || first.starts_with("NDims")) && first.find('=') != std::string_view::npos;
}

Result<ImageFile> readMetaImage(std::string_view bytes, const SiblingFile& sibling) {
  if (!looksLikeMetaImage(bytes)) return Error{ErrorCode::HeaderMalformed, {"ObjectType = Image"}, {}, {}};
  const Result<MetaFields> fields = metaFieldsOf(bytes);
  if (!fields) return fields.error();
  if (fields->has("ObjectType") && lowered((*fields)["ObjectType"]) != "image")
    return metaUnsupported("a MetaImage object other than an image");
  const auto axes = countOf((*fields)["NDims"]);
  if (!axes || *axes < 2 || *axes > 4) return metaUnsupported("an image of other than two to four axes");
  const Result<ImageGrid> grid = gridOf(*fields, *axes);
  if (!grid) return grid.error();
  if (const Status checked = checkGrid(*grid); !checked) return checked.error();
  const Result<SampleLayout> layout = layoutOf(*fields);
  if (!layout) return layout.error();
  const std::string name((*fields)["ElementDataFile"]);
  Result<ImageFile> read = Error{};
  if (lowered(name) == "local") {
    read = metaSamples(*fields, *grid, *layout, bytes.substr(fields->end));
  } else {
    if (name.starts_with("LIST") || name.find('%') != std::string::npos)
      return metaUnsupported("an image in several data files");
    const Result<std::string> data =
        sibling(name, 32 * bytesOf(*grid, *layout) + (std::size_t{1} << 20));  // packed it may be larger
    if (!data) return data.error();
    read = metaSamples(*fields, *grid, *layout, *data);
  }
  const auto sizes = numbersOf((*fields)["DimSize"], *axes);
  if (read && *axes == 4 && sizes && sizes->back() > 1.0)
    read->remarks.push_back({ImageRemark::Kind::FirstOfSeveral, {sizes->back()}});
  if (read && !fields->has("ElementSpacing") && !fields->has("ElementSize"))
    read->remarks.push_back({ImageRemark::Kind::NoSpacing, {}});
  return read;
}

}  // namespace handwheel
