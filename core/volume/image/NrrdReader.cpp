// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NrrdReader.h"

#include "base/NumberText.h"
#include "volume/image/ImageHeader.h"
#include "volume/image/ImageLabels.h"
#include "volume/image/Inflate.h"
#include "volume/image/LabelLayers.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace handwheel {
namespace {

using namespace imageHeader;

constexpr std::size_t kMostHeader = std::size_t{1} << 20;  // bytes

Error nrrdUnsupported(const char* what) {
  return {ErrorCode::Unsupported, {what}, {}, {}};
}

// The fields of a header by their names in lower case, and the offset of the data after it.
struct NrrdFields {
  std::map<std::string, std::string, std::less<>> values;
  std::map<std::string, std::string, std::less<>> keys;  // those that programs add ("key:=value")
  std::size_t end = 0;

  std::string_view operator[](std::string_view name) const {
    const auto found = values.find(name);
    return found == values.end() ? std::string_view() : std::string_view(found->second);
  }
  // Returns the value of a field that has two spellings.
  std::string_view either(std::string_view name, std::string_view other) const {
    return (*this)[name].empty() ? (*this)[other] : (*this)[name];
  }
};

Result<NrrdFields> fieldsOf(std::string_view bytes) {
  std::string_view rest = bytes.substr(0, kMostHeader);
  takeLine(rest);
  NrrdFields fields;
  while (!rest.empty()) {
    const std::string_view line = takeLine(rest);
    if (line.empty()) break;
    fields.end = static_cast<std::size_t>(rest.data() - bytes.data());
    if (line.front() == '#') continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return Error{ErrorCode::HeaderMalformed, {"a line \"field: value\""}, {}, {}};
    if (line.substr(colon).starts_with(":=")) {
      fields.keys[std::string(line.substr(0, colon))] = line.substr(colon + 2);
      continue;
    }
    fields.values[lowered(trimmed(line.substr(0, colon)))] = trimmed(line.substr(colon + 1));
  }
  fields.end = static_cast<std::size_t>(rest.data() - bytes.data());
  return fields;
}

std::optional<SampleType> typeNamed(std::string name) {
  for (const std::string_view filler : {"signed ", " int", "_t"}) {  // "signed short int" is "short"
    const std::size_t at = name.find(filler);
    const bool isPartOfAnother = filler == "signed " && at != 0;
    if (at != std::string::npos && !isPartOfAnother) name.erase(at, filler.size());
  }
  static const std::map<std::string, SampleType, std::less<>> kTypes = {{"char", SampleType::Int8},
                                                                        {"int8", SampleType::Int8},
                                                                        {"uchar", SampleType::UInt8},
                                                                        {"unsigned char", SampleType::UInt8},
                                                                        {"uint8", SampleType::UInt8},
                                                                        {"short", SampleType::Int16},
                                                                        {"int16", SampleType::Int16},
                                                                        {"ushort", SampleType::UInt16},
                                                                        {"unsigned short", SampleType::UInt16},
                                                                        {"uint16", SampleType::UInt16},
                                                                        {"int", SampleType::Int32},
                                                                        {"int32", SampleType::Int32},
                                                                        {"uint", SampleType::UInt32},
                                                                        {"unsigned", SampleType::UInt32},
                                                                        {"uint32", SampleType::UInt32},
                                                                        {"longlong", SampleType::Int64},
                                                                        {"long long", SampleType::Int64},
                                                                        {"int64", SampleType::Int64},
                                                                        {"ulonglong", SampleType::UInt64},
                                                                        {"unsigned long long", SampleType::UInt64},
                                                                        {"uint64", SampleType::UInt64},
                                                                        {"float", SampleType::Float32},
                                                                        {"double", SampleType::Float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) return {};
  return found->second;
}

// An axis of the file: its samples and the step along it, where it has one in space.
struct NrrdAxis {
  std::size_t size = 0;
  std::optional<Vec3> step;
};

std::optional<Vec3> vectorIn(std::string_view word) {
  if (!word.starts_with('(') || !word.ends_with(')')) return {};
  std::string inside(word.substr(1, word.size() - 2));
  std::replace(inside.begin(), inside.end(), ',', ' ');
  const auto numbers = numbersOf(inside, 3);
  if (!numbers) return {};
  return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

// Vectors may have blanks within; words between brackets are put together.
std::string withoutInnerBlanks(std::string_view text) {
  std::string packed;
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (depth > 0 && (c == ' ' || c == '\t')) continue;
    packed += c;
  }
  return packed;
}

Result<std::vector<NrrdAxis>> axesOf(const NrrdFields& fields) {
  const auto dimension = countOf(fields["dimension"]);
  if (!dimension || *dimension < 1) return malformed("dimension", "it is not a number of axes");
  if (*dimension < 2 || *dimension > 4) return nrrdUnsupported("an image of other than two to four axes");
  const std::vector<std::string_view> sizes = wordsOf(fields["sizes"]);
  const std::string directions = withoutInnerBlanks(fields["space directions"]);
  const std::vector<std::string_view> steps = wordsOf(directions), spacings = wordsOf(fields["spacings"]);
  const bool isInSpace = !steps.empty();
  if (sizes.size() != *dimension) return malformed("sizes", "there is not one for each axis");
  if (isInSpace && steps.size() != *dimension) return malformed("space directions", "there is not one for each axis");
  std::vector<NrrdAxis> axes(*dimension);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto size = countOf(sizes[k]);
    if (!size || *size < 1) return malformed("sizes", "one is not a number of samples");
    axes[k].size = *size;
    if (isInSpace && lowered(steps[k]) != "none") {
      axes[k].step = vectorIn(steps[k]);
      if (!axes[k].step) return malformed("space directions", "one is not a vector in space");
    }
  }
  if (isInSpace || spacings.size() != *dimension) return axes;
  Eigen::Index along = 0;
  for (std::size_t k = 0; k < axes.size() && along < 3; ++k) {
    const auto spacing = numbersOf(spacings[k], 1);  // "nan" for axes without a spacing
    if (spacing) axes[k].step = spacing->front() * Vec3::Unit(along++);
  }
  return axes;
}

// mm to a unit of the space; 1 where it is another, or none.
double unitOf(const NrrdFields& fields) {
  const std::vector<std::string_view> units = wordsOf(fields.either("space units", "units"));
  if (units.empty()) return 1.0;
  const std::string unit = lowered(units.back());
  if (unit.find("\"m\"") != std::string::npos) return 1000.0;
  if (unit.find("\"cm\"") != std::string::npos) return 10.0;
  if (unit.find("\"um\"") != std::string::npos) return 1e-3;
  return 1.0;
}

// From the space of the file to ours.
Vec3 turnOf(const NrrdFields& fields) {
  const std::string space = lowered(fields["space"]);
  if (space == "right-anterior-superior" || space == "ras") return {-1, -1, 1};
  if (space == "left-anterior-superior" || space == "las") return {1, -1, 1};
  return Vec3::Ones();
}

// Returns true if the first axis is stated to be that of the values of a sample.
bool hasComponents(const NrrdFields& fields) {
  const std::vector<std::string_view> kinds = wordsOf(fields["kinds"]);
  const std::string first = kinds.empty() ? std::string() : lowered(kinds.front());
  return first == "list" || first == "vector" || first.find("-color") != std::string::npos;
}

struct NrrdImage {
  ImageGrid grid;
  SampleLayout layout;
  bool hasSpacing = false;
  std::size_t images = 1;  // one after the other
};

Result<NrrdImage> imageOf(const NrrdFields& fields) {
  Result<std::vector<NrrdAxis>> axes = axesOf(fields);
  if (!axes) return axes.error();
  NrrdImage image;
  // If the first of four axes is not in space, while others are, it has the components of a sample; otherwise the last
  // axis is a sequence of images.
  const bool isAnyInSpace =
      std::any_of(axes->begin(), axes->end(), [](const NrrdAxis& axis) { return axis.step.has_value(); });
  if (axes->size() == 4 && (isAnyInSpace ? !axes->front().step : hasComponents(fields))) {
    if (axes->front().size > 1000) return nrrdUnsupported("a sample of more than 1000 values");
    image.layout.perSample = axes->front().size;
    axes->erase(axes->begin());
  }
  if (axes->size() == 4) image.images = axes->back().size;
  const bool hasOrigin = !fields["space origin"].empty();
  const auto origin = vectorIn(withoutInnerBlanks(fields["space origin"]));
  if (hasOrigin && !origin) return malformed("space origin", "it is no place");
  image.hasSpacing = axes->front().step.has_value();
  const double unit = unitOf(fields);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    image.grid.size[k] = 1;
    if (k >= axes->size()) continue;
    if ((*axes)[k].size > ImageGrid::kMostAlong)
      image.grid.size[k] = ImageGrid::kMostAlong + 1;
    else
      image.grid.size[k] = static_cast<int>((*axes)[k].size);
    image.grid.steps.col(axis) = unit * (*axes)[k].step.value_or(Vec3::Unit(axis));
  }
  image.grid.origin = unit * origin.value_or(Vec3::Zero());
  const Vec3 turn = turnOf(fields);
  image.grid.origin = turn.cwiseProduct(image.grid.origin);
  image.grid.steps = turn.asDiagonal() * image.grid.steps;
  const auto type = typeNamed(lowered(fields["type"]));
  if (!type) return malformed("type", "it is not a type of numbers");
  image.layout.type = *type;
  image.layout.order = lowered(fields["endian"]) == "big" ? std::endian::big : std::endian::little;
  return image;
}

// Returns the data after a number of lines and bytes; for bytes = -1 the data are at the end.
Result<std::string_view> skipped(std::string_view data, const NrrdFields& fields, std::size_t needed) {
  const std::string_view bytes = fields.either("byte skip", "byteskip");
  if (bytes == "-1") return data.substr(data.size() - std::min(data.size(), needed));
  const std::size_t count = bytes.empty() ? 0 : countOf(bytes).value_or(data.size() + 1);
  if (count > data.size()) return malformed("byte skip", "it is more than the file contains");
  return data.substr(count);
}

Result<ImageFile> samplesOf(const NrrdFields& fields, const NrrdImage& image, std::string_view data) {
  const std::string_view lines = fields.either("line skip", "lineskip");
  const auto lineCount = lines.empty() ? std::size_t{0} : countOf(lines);
  if (!lineCount) return malformed("line skip", "it is not a number of lines");
  for (std::size_t i = 0; i < *lineCount && !data.empty(); ++i) takeLine(data);
  const std::string encoding = lowered(fields["encoding"]);
  const std::size_t needed = bytesOf(image.grid, image.layout);
  const bool isText = encoding == "txt" || encoding == "text" || encoding == "ascii";
  if (encoding == "gz" || encoding == "gzip") {
    const std::size_t before = countOf(fields.either("byte skip", "byteskip")).value_or(0);
    const Result<std::string> plain = inflated(data, needed + std::min<std::size_t>(before, 1 << 20));
    if (!plain) return plain.error();
    const Result<std::string_view> wanted = skipped(*plain, fields, needed);
    return wanted ? imageOfBytes(image.grid, image.layout, *wanted) : wanted.error();
  }
  if (encoding != "raw" && !isText) return nrrdUnsupported("an encoding other than raw, gzip or text");
  const Result<std::string_view> wanted = skipped(data, fields, needed);
  if (!wanted) return wanted.error();
  return isText ? imageOfText(image.grid, image.layout, *wanted) : imageOfBytes(image.grid, image.layout, *wanted);
}

// Returns the segments of a segmentation by 3D Slicer: the keys Segment0_LabelValue, Segment0_Name and Segment0_Layer,
// and so on.
std::vector<LayerSegment> segmentsOf(const NrrdFields& fields) {
  std::vector<LayerSegment> segments;
  for (std::size_t i = 0; i < kMostLabels; ++i) {
    const std::string prefix = "Segment" + std::to_string(i) + "_";
    const auto key = [&](const char* name) -> std::string_view {
      const auto found = fields.keys.find(prefix + name);
      return found == fields.keys.end() ? std::string_view() : std::string_view(found->second);
    };
    const std::string_view name = key("Name"), value = key("LabelValue"), layer = key("Layer");
    if (name.empty() && value.empty()) break;
    const auto number = numbersOf(value.empty() ? "1" : value, 1);
    const auto index = layer.empty() ? std::size_t{0} : countOf(trimmed(layer));
    if (number && index) segments.push_back({number->front(), *index, std::string(trimmed(name))});
  }
  return segments;
}

// Reads a file of labels in several layers, which are values of a sample or images one after the other.
Result<ImageFile> layersOf(const NrrdFields& fields, const NrrdImage& image, std::string_view data,
                           std::vector<LayerSegment> segments) {
  NrrdImage all = image;
  const std::size_t layers = image.layout.perSample * image.images;
  all.layout.perSample = 1;
  const std::size_t slices = static_cast<std::size_t>(image.grid.size[2]) * layers;
  all.grid.size[2] = static_cast<int>(std::min<std::size_t>(slices, ImageGrid::kMostAlong + 1));
  if (const Status checked = checkGrid(all.grid); !checked) return checked.error();
  const Result<ImageFile> read = samplesOf(fields, all, data);
  if (!read) return read.error();
  std::optional<ImageFile> made =
      imageOfLayers(image.grid, read->image, layers, image.images == 1, std::move(segments));
  return made ? Result<ImageFile>(std::move(*made)) : samplesOf(fields, image, data);
}

// Reads the samples: those of labels in several layers, or of the first image.
Result<ImageFile> readSamples(const NrrdFields& fields, const NrrdImage& image, std::string_view data) {
  std::vector<LayerSegment> segments = segmentsOf(fields);
  const bool isLayered = image.layout.perSample == 1 || image.images == 1;
  if (!segments.empty() && isLayered && image.layout.perSample * image.images > 1)
    return layersOf(fields, image, data, std::move(segments));
  Result<ImageFile> read = samplesOf(fields, image, data);
  if (!read) return read.error();
  read->hasLabels = !segments.empty();
  for (LayerSegment& segment : segments)
    if (segment.layer == 0) read->labels.push_back({segment.value, std::move(segment.name)});
  if (image.images > 1)
    read->remarks.push_back({ImageRemark::Kind::FirstOfSeveral, {static_cast<double>(image.images)}});
  return read;
}

}  // namespace

bool looksLikeNrrd(std::string_view bytes) {
  return bytes.starts_with("NRRD000");
}

Result<ImageFile> readNrrd(std::string_view bytes, const SiblingFile& sibling) {
  if (!looksLikeNrrd(bytes)) return Error{ErrorCode::HeaderMalformed, {"NRRD"}, {}, {}};
  const Result<NrrdFields> fields = fieldsOf(bytes);
  if (!fields) return fields.error();
  const Result<NrrdImage> image = imageOf(*fields);
  if (!image) return image.error();
  if (const Status checked = checkGrid(image->grid); !checked) return checked.error();
  const std::string_view name = fields->either("data file", "datafile");
  Result<ImageFile> read = Error{};
  if (name.empty()) {
    read = readSamples(*fields, *image, bytes.substr(fields->end));
  } else {
    if (name.starts_with("LIST") || name.find('%') != std::string_view::npos)
      return nrrdUnsupported("an image in several data files");
    // Packed or text data may be larger than the samples, but hardly more than this.
    const std::size_t most = 32 * image->images * bytesOf(image->grid, image->layout) + (std::size_t{1} << 20);
    const Result<std::string> data = sibling(std::string(name), most);
    if (!data) return data.error();
    read = readSamples(*fields, *image, *data);
  }
  if (read) read->content = (*fields)["content"];
  if (read && !image->hasSpacing) read->remarks.push_back({ImageRemark::Kind::NoSpacing, {}});
  return read;
}

}  // namespace handwheel
