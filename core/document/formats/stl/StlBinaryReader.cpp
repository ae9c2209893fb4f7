// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/stl/StlBinaryReader.h"

#include "base/ByteOrder.h"
#include "document/formats/MeshAssembly.h"
#include "document/formats/stl/StlReader.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kCountAt = 80;
constexpr std::size_t kFacetsAt = 84;
constexpr std::size_t kFacetSize = 50;    // normal, three corners, attribute
constexpr std::size_t kCornersAt = 12;    // within a facet
constexpr std::size_t kAttributeAt = 48;  // within a facet
constexpr std::size_t kMostFacets = (kNone - 1) / 3;

std::uint32_t announcedFacets(std::string_view bytes) {
  return loadNumber<std::uint32_t>(bytes.data() + kCountAt, std::endian::little);
}

std::array<double, 9> cornersOf(const char* facet) {
  std::array<double, 9> v;
  for (std::size_t i = 0; i < v.size(); ++i)
    v[i] = static_cast<double>(loadNumber<float>(facet + kCornersAt + 4 * i, std::endian::little));
  return v;
}

const double* firstNotFinite(const std::array<double, 9>& v) {
  const auto* found = std::find_if(v.begin(), v.end(), [](double x) { return !std::isfinite(x); });
  return found == v.end() ? nullptr : found;
}

class BinaryStlParser {
 public:
  BinaryStlParser(std::string_view bytes, const ReadOptions& options, Progress progress)
      : m_bytes(bytes), m_assembly(options, progress, bytes.size()) {}

  Result<MeshFile> read() {
    if (m_bytes.size() < kFacetsAt)
      m_assembly.fail({ErrorCode::DataTruncated,
                       {"bytes", std::to_string(kFacetsAt), std::to_string(m_bytes.size())},
                       InputPosition::byte(m_bytes.size()),
                       {}});
    else if (agreeOnCount())
      readFacets();
    if (m_bytes.substr(0, kCountAt).find("COLOR=") != std::string_view::npos) m_assembly.lose(LostAttribute::Colour);
    return m_assembly.finish(NumberType::Float32);
  }

 private:
  // Determines the number of facets to read from the announced count and the size.
  bool agreeOnCount() {
    const std::size_t announced = announcedFacets(m_bytes), room = m_bytes.size() - kFacetsAt;
    if (findFacetsWithAttributes(announced)) return true;
    const std::size_t whole = room / kFacetSize, excess = room % kFacetSize;
    m_count = std::min(announced, whole);
    if (announced > whole)
      return m_assembly.tolerate({ErrorCode::DataTruncated,
                                  {"facets", std::to_string(announced), std::to_string(whole)},
                                  InputPosition::byte(kFacetsAt + kFacetSize * whole),
                                  {}});
    if (whole > announced && (announced == 0 || excess == 0) && restIsFacets(announced, whole)) m_count = whole;
    if (m_count > announced)
      m_assembly.mend({ErrorCode::CountMismatch,
                       {"facets", std::to_string(announced), std::to_string(m_count)},
                       InputPosition::byte(kCountAt),
                       {}});
    const std::size_t end = kFacetsAt + kFacetSize * m_count;
    if (end < m_bytes.size()) m_assembly.noteExcess(end, InputPosition::byte(end));
    return true;
  }

  // Finds the facets if each is followed by as many bytes as its attribute says, and the file ends with the last one.
  // Normally the attribute is a colour, and nothing follows.
  bool findFacetsWithAttributes(std::size_t announced) {
    if (announced == 0 || m_bytes.size() - kFacetsAt <= kFacetSize * static_cast<std::uint64_t>(announced))
      return false;
    std::vector<std::size_t> found;
    std::size_t at = kFacetsAt;
    for (std::size_t i = 0; i < announced; ++i) {
      if (!m_assembly.step() || m_bytes.size() - at < kFacetSize) return false;
      const std::size_t size =
          kFacetSize + loadNumber<std::uint16_t>(m_bytes.data() + at + kAttributeAt, std::endian::little);
      if (m_bytes.size() - at < size) return false;
      found.push_back(at);
      at += size;
    }
    if (at != m_bytes.size()) return false;
    m_found = std::move(found);
    m_count = announced;
    return true;
  }

  // Returns false for padding or data of another program after the facets, which is not geometry.
  bool restIsFacets(std::size_t first, std::size_t last) {
    bool anything = false;
    for (std::size_t i = first; i < last && m_assembly.step(); ++i) {
      const auto corners = cornersOf(facet(i));
      if (firstNotFinite(corners)) return false;
      anything |= std::any_of(corners.begin(), corners.end(), [](double x) { return x != 0.0; });
    }
    return anything;
  }

  void readFacets() {
    if (m_count > kMostFacets) {
      m_assembly.fail(
          {ErrorCode::FileTooLarge, {"facets", std::to_string(m_count), std::to_string(kMostFacets)}, {}, {}});
      return;
    }
    auto& [points, triangles] = m_assembly.soup();
    points.resize(3 * m_count);
    triangles.resize(m_count);
    std::uint32_t kept = 0;
    unsigned attributes = 0;
    for (std::size_t i = 0; i < m_count; ++i) {
      if (!m_assembly.advance(kFacetsAt + kFacetSize * i)) break;
      const auto corners = cornersOf(facet(i));
      if (const double* bad = firstNotFinite(corners)) {
        if (!refuse(i, static_cast<std::size_t>(bad - corners.data()), *bad)) break;
        continue;
      }
      for (std::uint32_t k = 0; k < 9; ++k) points[3 * kept + k / 3][k % 3] = corners[k] + 0.0;  // -0 becomes 0
      triangles[kept] = {3 * kept, 3 * kept + 1, 3 * kept + 2};
      ++kept;
      attributes |= loadNumber<std::uint16_t>(facet(i) + kAttributeAt, std::endian::little);
    }
    points.resize(3 * std::size_t{kept});
    triangles.resize(kept);
    if (attributes != 0) m_assembly.lose(m_found.empty() ? LostAttribute::Colour : LostAttribute::Other, "attributes");
  }

  bool refuse(std::size_t index, std::size_t coordinate, double value) {
    const auto at = static_cast<std::uint64_t>(facet(index) - m_bytes.data()) + kCornersAt + 4 * coordinate;
    return m_assembly.tolerate(
        {ErrorCode::NumberNotFinite, {std::isnan(value) ? "nan" : "inf"}, InputPosition::byte(at), {}});
  }

  const char* facet(std::size_t i) const {
    return m_bytes.data() + (m_found.empty() ? kFacetsAt + kFacetSize * i : m_found[i]);
  }

  std::string_view m_bytes;
  MeshAssembly m_assembly;
  std::size_t m_count = 0;
  std::vector<std::size_t> m_found;  // offsets of the facets; empty: they follow each other without a gap
};

}  // namespace

bool isWholeBinaryStl(std::string_view bytes) {
  return bytes.size() >= kFacetsAt &&
         bytes.size() - kFacetsAt == kFacetSize * static_cast<std::uint64_t>(announcedFacets(bytes));
}

Result<MeshFile> readBinaryStl(std::string_view bytes, const ReadOptions& options, Progress progress) {
  return BinaryStlParser(bytes, options, progress).read();
}

}  // namespace handwheel
