// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/ColladaGeometry.h"

#include "xml/XmlNumbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kMostInputs = 64;  // Limit for a primitive or vertices; numbers per corner
constexpr std::size_t kMostNotes = 100;
constexpr std::size_t kMostRead = std::size_t{256} << 20;  // bytes of sources, counted as often as they are read
constexpr std::size_t kPointBytes = 12;                    // Least memory that a point counts

// A whole number that is not negative; the fallback where there is none.
std::size_t attributeCount(const XmlElement& element, std::string_view attribute, std::size_t fallback) {
  const std::string* text = element.attribute(attribute);
  std::size_t value = fallback;
  if (text) std::from_chars(text->data(), text->data() + text->size(), value);
  return value;
}

// Every stride-th of the numbers, from the first-th on. False where one is no whole number.
bool readIndices(std::string_view text, std::size_t stride, std::size_t first, std::vector<std::uint32_t>& indices) {
  std::size_t column = 0;
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
    std::uint32_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc() || end != word.data() + word.size()) return false;
    if (column == first) indices.push_back(index);
    column = (column + 1) % stride;
  }
  return true;
}

// The points that an accessor picks out of a source's numbers: those of its first three parameters.
std::vector<Vec3> readPoints(const XmlElement& source) {
  std::vector<Vec3> points;
  const XmlElement* array = source.child("float_array");
  const XmlElement* common = source.child("technique_common");
  const XmlElement* accessor = common ? common->child("accessor") : nullptr;
  if (!array) return points;
  const std::size_t stride =
      std::clamp<std::size_t>(accessor ? attributeCount(*accessor, "stride", 1) : 3, 3, kMostInputs);
  const std::size_t offset = accessor ? attributeCount(*accessor, "offset", 0) : 0;
  std::string_view text = array->text;
  std::size_t number = 0;
  Vec3 point;
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text), ++number) {
    const std::size_t column = (number + stride - offset % stride) % stride;
    if (number < offset || column >= 3) continue;
    const Result<double> value = parseNumber(word);
    point[static_cast<Eigen::Index>(column)] = value ? *value : std::nan("");
    if (column == 2) points.push_back(point);
  }
  return points;
}

}  // namespace

const XmlElement* ColladaIds::referred(const XmlElement& from, std::string_view attribute,
                                       std::string_view name) const {
  const std::string* address = from.attribute(attribute);
  if (!address || !address->starts_with('#')) return nullptr;
  const auto found = m_elements.find(std::string_view(*address).substr(1));
  return found != m_elements.end() && found->second->name == name ? found->second : nullptr;
}

void ColladaIds::collect(const XmlElement& element) {
  if (const std::string* id = element.attribute("id")) m_elements.try_emplace(*id, &element);
  for (const XmlElement& child : element.children) collect(child);
}

ColladaGeometry::ColladaGeometry(const ColladaIds& ids, std::vector<Error>& damage, Progress progress)
    : m_ids(ids),
      m_damage(damage),
      m_progress(progress),
      m_triangulation([progress] { return !progress.cancelled(); }) {}

void ColladaGeometry::note(Error error) {
  if (m_damage.size() < kMostNotes) m_damage.push_back(std::move(error));
}

TriangleSoup ColladaGeometry::read(const XmlElement& geometry) {
  TriangleSoup soup;
  m_basePoints.clear();
  const XmlElement* mesh = geometry.child("mesh");
  if (!mesh) {
    note({ErrorCode::Unsupported, {"a geometry that is not a mesh"}, InputPosition::line(geometry.line), {}});
    return soup;
  }
  for (const XmlElement& child : mesh->children) {
    if (m_progress.cancelled()) break;
    for (std::string_view kind : {"triangles", "polylist", "polygons", "tristrips", "trifans"}) {
      if (child.name == kind) readPrimitive(child, soup);
    }
  }
  return soup;
}

std::optional<ColladaGeometry::Layout> ColladaGeometry::layoutOf(const XmlElement& primitive) const {
  Layout layout;
  const auto first = [](const XmlElement& element) {
    return std::span(element.children).first(std::min(element.children.size(), kMostInputs));
  };
  for (const XmlElement& input : first(primitive)) {
    if (input.name != "input") continue;
    const std::size_t offset = attributeCount(input, "offset", 0);
    if (offset >= kMostInputs) return {};
    layout.stride = std::max(layout.stride, offset + 1);
    const std::string* semantic = input.attribute("semantic");
    if (!semantic || *semantic != "VERTEX") continue;
    layout.vertex = offset;
    const XmlElement* vertices = m_ids.referred(input, "source", "vertices");
    if (!vertices) return {};
    for (const XmlElement& inner : first(*vertices)) {
      const std::string* meaning = inner.name == "input" ? inner.attribute("semantic") : nullptr;
      if (meaning && *meaning == "POSITION") layout.positions = m_ids.referred(inner, "source", "source");
    }
  }
  if (!layout.positions) return {};
  return layout;
}

std::optional<std::uint32_t> ColladaGeometry::basePointOf(const XmlElement& source, TriangleSoup& soup) {
  const auto known = m_basePoints.find(&source);
  if (known != m_basePoints.end()) return known->second;
  if (m_read > kMostRead) return {};
  const std::vector<Vec3> points = readPoints(source);
  const XmlElement* array = source.child("float_array");
  m_read += std::max(array ? array->text.size() : 0, kPointBytes * points.size());
  const auto base = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), points.begin(), points.end());
  return m_basePoints[&source] = base;
}

void ColladaGeometry::readPrimitive(const XmlElement& primitive, TriangleSoup& soup) {
  const std::optional<Layout> layout = layoutOf(primitive);
  if (!layout) return note(malformed(primitive, "its vertices have no positions"));
  const std::optional<std::uint32_t> base = basePointOf(*layout->positions, soup);
  if (!base)
    return note(
        {ErrorCode::FileTooLarge, {"bytes", "", std::to_string(kMostRead)}, InputPosition::line(primitive.line), {}});
  const XmlElement* vcount = primitive.child("vcount");
  std::string_view counts = vcount ? std::string_view(vcount->text) : std::string_view();
  m_dropped = 0;
  std::vector<std::uint32_t> corners;
  for (const XmlElement& list : primitive.children) {
    if (m_progress.cancelled()) return;
    if (list.name == "ph") ++m_dropped;  // a polygon with holes
    if (list.name != "p") continue;
    corners.clear();
    if (!readIndices(list.text, layout->stride, layout->vertex, corners))
      note(malformed(list, "one of its indices is not a number"));
    for (std::uint32_t& corner : corners) corner = corner < kNone - *base ? corner + *base : kNone;
    addList(primitive, counts, corners, soup);
  }
  if (m_dropped > 0) note(malformed(primitive, std::to_string(m_dropped) + " of its polygons cannot be read"));
}

// counts: of the corners of polygons in a "polylist"; those that are used are taken away.
void ColladaGeometry::addList(const XmlElement& primitive, std::string_view& counts,
                              const std::vector<std::uint32_t>& corners, TriangleSoup& soup) {
  if (primitive.name == "tristrips" || primitive.name == "trifans") return addStrip(primitive.name, corners, soup);
  if (primitive.name == "polygons") return addPolygon(corners, soup);
  const std::span<const std::uint32_t> all(corners);
  for (std::size_t at = 0; at < all.size();) {
    std::uint32_t count = 3;
    if (primitive.name == "polylist") {
      const std::string_view word = takeWord(counts);
      const auto read = std::from_chars(word.data(), word.data() + word.size(), count);
      if (read.ec != std::errc() || count == 0) count = kNone;
    }
    if (count > all.size() - at) {
      ++m_dropped;
      return;
    }
    addPolygon(all.subspan(at, count), soup);
    at += count;
  }
}

void ColladaGeometry::addStrip(std::string_view kind, const std::vector<std::uint32_t>& corners, TriangleSoup& soup) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const bool isFan = kind == "trifans", turned = !isFan && i % 2 == 1;
    const std::array triangle{corners[isFan ? 0 : i - 2], corners[turned ? i : i - 1], corners[turned ? i - 1 : i]};
    addPolygon(triangle, soup);
  }
}

void ColladaGeometry::addPolygon(std::span<const std::uint32_t> corners, TriangleSoup& soup) {
  const bool isReadable = corners.size() >= 3 && std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) {
                            return c < soup.points.size() && soup.points[c].allFinite();
                          });
  if (isReadable)
    m_triangulation.cut(soup.points, corners, soup.triangles);
  else
    ++m_dropped;
}

}  // namespace handwheel
