// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/document/GlobeKind.h"

#include "base/NumberText.h"
#include "document/AtomicFile.h"
#include "document/scene/BodyBlobs.h"
#include "document/scene/BodyDescription.h"
#include "document/scene/BodyDisplay.h"
#include "globe/document/GlobeDocument.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace handwheel::test {

namespace {

constexpr double kBlankRadius = 10.0;  // mm

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
  opened.content = std::make_shared<const GlobeSnapshot>(globeBodies(*surface));
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
  WrittenFile file{text.size(), {}};
  const BodySet usual = globeBodies(surface);
  for (const BodyPointer& body : bodiesOf(content)) {
    const BodyPointer at = usual.withId(body->id);
    const bool isSame = at && at->name == body->name && at->pose.isApprox(body->pose, 0.0);
    if (!isSame) file.notes.push_back({"The name and the place of %1 are not in the file.", {body->name}, true});
  }
  return file;
}

void GlobeKind::save(const Snapshot& content, Container& container) const {
  writeBodies(bodiesOf(content), id(), container, {&kGlobeFormat, 1});
}

Result<SnapshotPointer> GlobeKind::load(const Container& container, std::vector<Error>& damage,
                                        Progress progress) const {
  Result<BodySet> read = readBodies(container, id(), damage, progress, {&kGlobeFormat, 1});
  if (!read) return read.error();
  BodySet bodies = globeBodies(GlobeSurface(kBlankRadius));
  for (const BodyPointer& usual : BodySet(bodies)) {
    const BodyPointer body = read->withId(usual->id);
    if (body && dynamic_cast<const GlobeGeometry*>(body->geometry.get()))
      bodies = bodies.with(body);
    else
      damage.push_back({ErrorCode::ElementMalformed, {usual->name, "it is missing"}, {}, {}});
  }
  return SnapshotPointer(std::make_shared<const GlobeSnapshot>(bodies));
}

SnapshotPointer GlobeKind::blank() const {
  return globe(kBlankRadius);
}

std::unique_ptr<Document> GlobeKind::make(OpenedFile opened) const {
  return std::make_unique<GlobeDocument>(std::move(opened));
}

nlohmann::json GlobeKind::describe(const Snapshot& content) const {
  return {{"radius", radiusOf(content)}, {"bodies", describeBodies(bodiesOf(content))}};
}

DisplayModel GlobeKind::display(const Snapshot& content) const {
  return {displayPartsOf(bodiesOf(content))};
}

}  // namespace handwheel::test
