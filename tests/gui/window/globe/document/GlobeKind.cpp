// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/document/GlobeKind.h"

#include "base/NumberText.h"
#include "document/AtomicFile.h"
#include "document/container/Blobs.h"
#include "globe/document/GlobeDocument.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace handwheel::test {

namespace {

constexpr const char* kDents = "globe/dents";
constexpr double kBlankRadius = 10.0;  // mm

bool isRadius(double radius) {
  return radius >= kLeastRadius && radius <= kLargestRadius;
}

std::optional<GlobeSurface> readGlobe(std::istream& stream) {
  std::string word;
  double radius = 0.0, dent = 0.0;
  std::size_t number = 0;
  if (!(stream >> word >> radius) || word != "globe" || !isRadius(radius)) return std::nullopt;
  GlobeSurface surface(radius);
  while (stream >> word) {
    if (word != "dent" || !(stream >> number >> dent) || number >= kGlobePoints) return std::nullopt;
    surface.setDent(number, dent);
  }
  return surface;
}

}  // namespace

bool GlobeKind::recognises(std::string_view head, std::string_view) const {
  return head.starts_with("globe ");
}

const ErrorDescription GlobeError::Flat{
    .id = "GlobeFlat", .sentences = {"what is in %1 is flat"}, .advice = {"Blow it up."}};

Result<OpenedFile> GlobeKind::import(const std::filesystem::path& path, const ReadOptions&, Progress) const {
  std::ifstream stream(path);
  const auto surface = readGlobe(stream);
  if (!surface) return Error{GlobeError::Flat, {path.filename().string()}, {}, path.string()};
  OpenedFile opened;
  opened.kind = this;
  opened.content = std::make_shared<const GlobeSnapshot>(*surface);
  return opened;
}

Result<WrittenFile> GlobeKind::exportTo(const Snapshot& content, const std::filesystem::path& path, Progress) const {
  const GlobeSurface& surface = surfaceOf(content);
  std::string text = "globe " + shortestText(surface.radius()) + "\n";
  for (std::size_t i = 0; i < kGlobePoints; ++i) {
    if (surface.dent(i) > 0.0) text += "dent " + std::to_string(i) + " " + shortestText(surface.dent(i)) + "\n";
  }
  const Status written = writeFileAtomically(path, text, {});
  if (!written) return written.error();
  return WrittenFile{text.size(), {}};
}

void GlobeKind::save(const Snapshot& content, Container& container) const {
  const GlobeSurface& surface = surfaceOf(content);
  (*container.manifest)["document"]["radius"] = surface.radius();
  if (!surface.isDented()) return;
  std::vector<double> dents(kGlobePoints);
  for (std::size_t i = 0; i < kGlobePoints; ++i) dents[i] = surface.dent(i);
  writeArray<double>(container, kDents, dents);
}

Result<SnapshotPointer> GlobeKind::load(const Container& container, std::vector<Error>& damage, Progress) const {
  const auto found = (*container.manifest)["document"].find("radius");
  const double radius = found->is_number() ? found->get<double>() : 0.0;
  if (!isRadius(radius))
    damage.push_back({ErrorCode::ElementMalformed, {"radius", "it is missing or impossible"}, {}, {}});
  GlobeSurface surface(isRadius(radius) ? radius : kBlankRadius);
  const std::vector<double> dents = readArray<double>(container, kDents, kGlobePoints).values;
  for (std::size_t i = 0; i < std::min(dents.size(), kGlobePoints); ++i) {
    if (dents[i] > 0.0) surface.setDent(i, dents[i]);
  }
  return SnapshotPointer(std::make_shared<const GlobeSnapshot>(std::move(surface)));
}

SnapshotPointer GlobeKind::blank() const {
  return globe(kBlankRadius);
}

std::unique_ptr<Document> GlobeKind::make(OpenedFile opened) const {
  return std::make_unique<GlobeDocument>(std::move(opened));
}

nlohmann::json GlobeKind::describe(const Snapshot& content) const {
  return {{"radius", radiusOf(content)}};
}

DisplayModel GlobeKind::display(const Snapshot& content) const {
  TriangleSoup soup;
  const double r = radiusOf(content);
  soup.points = {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  DisplayPart part;
  part.name = "globe";
  part.soup = std::make_shared<const TriangleSoup>(std::move(soup));
  return {{std::move(part)}};
}

}  // namespace handwheel::test
