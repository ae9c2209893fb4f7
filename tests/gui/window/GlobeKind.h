// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/NumberText.h"
#include "document/AtomicFile.h"
#include "document/Document.h"
#include "document/Edit.h"
#include "tools/Tool.h"
#include "window/documents/DocumentTab.h"
#include "window/kinds/RigidPartsUi.h"

#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>

// A kind of document that the program does not have: an octahedron of a radius, and all that it takes to be one.
namespace handwheel::test {

struct GlobeSnapshot : Snapshot {
  explicit GlobeSnapshot(double r = 10.0) : radius(r) {}
  double radius;  // mm
};

inline double radiusOf(const Snapshot& content) {
  return static_cast<const GlobeSnapshot&>(content).radius;
}

inline SnapshotPointer globe(double radius) {
  return std::make_shared<const GlobeSnapshot>(radius);
}

class GlobeDocument : public Document {
 public:
  explicit GlobeDocument(OpenedFile opened)
      : Document(*opened.kind, std::move(opened.file)), m_content(std::move(opened.content)) {}

  SnapshotPointer snapshot() const override { return m_content; }
  std::vector<Property> properties() const override {
    std::vector<Property> all{{.id = "radius",
                               .group = "Globe",
                               .label = "Radius",
                               .value = radiusOf(*m_content),
                               .quantity = Quantity::Length,
                               .least = 1.0,
                               .largest = 1000.0}};
    for (Property& common : Document::properties()) all.push_back(std::move(common));
    return all;
  }
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override {
    if (id != "radius") return Document::propertyEdit(id, value);
    if (std::get<double>(value) == radiusOf(*m_content)) return std::unique_ptr<Edit>();
    return std::unique_ptr<Edit>(std::make_unique<Change>(globe(std::get<double>(value))));
  }

 private:
  struct Change : Edit {
    explicit Change(SnapshotPointer content) : other(std::move(content)) {}
    void exchange(Document& document) override {
      std::swap(static_cast<GlobeDocument&>(document).m_content, other);
      static_cast<GlobeDocument&>(document).wasChanged();
    }
    std::size_t bytes() const override { return sizeof(GlobeSnapshot); }
    SnapshotPointer other;
  };
  SnapshotPointer m_content;
};

// The code of an error of its own.
namespace GlobeError {

inline constexpr ErrorDescription Flat{
    .id = "GlobeFlat", .sentences = {"a globe of radius %1 is flat"}, .advice = {"Blow it up."}};  // {radius}

}  // namespace GlobeError

// Its foreign format is a line: "globe 10".
class GlobeKind : public DocumentKind {
 public:
  std::string id() const override { return "globe"; }
  std::string title() const override { return "Globe"; }
  std::vector<FileFormat> formats() const override { return {{"Globe", {".globe"}}}; }
  bool recognises(std::string_view head, std::string_view) const override { return head.starts_with("globe "); }
  Result<OpenedFile> import(const std::filesystem::path& path, const ReadOptions&, Progress) const override {
    std::ifstream stream(path);
    std::string word;
    double radius = 0.0;
    stream >> word >> radius;
    if (!(radius > 0.0)) return Error{GlobeError::Flat, {shortestText(radius)}, {}, path.string()};
    OpenedFile opened;
    opened.kind = this;
    opened.content = globe(radius);
    return opened;
  }
  Result<WrittenFile> exportTo(const Snapshot& content, const std::filesystem::path& path, Progress) const override {
    const std::string line = "globe " + shortestText(radiusOf(content)) + "\n";
    const Status written = writeFileAtomically(path, line, {});
    if (!written) return written.error();
    return WrittenFile{line.size(), {}};
  }
  void save(const Snapshot& content, Container& container) const override {
    (*container.manifest)["document"]["radius"] = radiusOf(content);
  }
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>&, Progress) const override {
    return globe((*container.manifest)["document"].value("radius", 0.0));
  }
  SnapshotPointer blank() const override { return globe(10.0); }
  std::unique_ptr<Document> make(OpenedFile opened) const override {
    return std::make_unique<GlobeDocument>(std::move(opened));
  }
  nlohmann::json describe(const Snapshot& content) const override { return {{"radius", radiusOf(content)}}; }
  DisplayModel display(const Snapshot& content) const override {
    TriangleSoup soup;
    const double r = radiusOf(content);
    soup.points = {{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
    soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    DisplayPart part;
    part.name = "globe";
    part.soup = std::make_shared<const TriangleSoup>(std::move(soup));
    return {{std::move(part)}};
  }
};

// What tools of globes preview in their own terms.
struct GlobePreview : KindPreview {
  explicit GlobePreview(double r) : radius(r) {}
  double radius;
};

// Shows the globe in twice its size as long as a button is held, then makes it so.
class GrowTool : public Tool {
 public:
  explicit GrowTool(Document& document) : m_document(document) {}

  std::string id() const override { return "grow"; }
  ToolReply pointer(const PointerEvent& event) override {
    if (event.kind == PointerEvent::Kind::Press) m_radius = 2.0 * radiusOf(*m_document.snapshot());
    if (event.kind != PointerEvent::Kind::Release || !m_radius) return ToolReply::Used;
    auto edit = m_document.propertyEdit("radius", *std::exchange(m_radius, std::nullopt));
    m_document.commit("Grow", std::move(*edit));
    return ToolReply::Used;
  }
  ToolReply perform(std::string_view) override {
    return std::exchange(m_radius, std::nullopt) ? ToolReply::Used : ToolReply::Ignored;
  }
  std::vector<ToolAction> actions() const override { return {{"revert", "Esc", "leave"}}; }
  ToolPreview preview() const override {
    ToolPreview preview;
    if (!m_radius) return preview;
    preview.replaced = std::make_shared<const DisplayModel>(m_document.kind().display(*globe(*m_radius)));
    preview.ofKind = std::make_shared<const GlobePreview>(*m_radius);
    return preview;
  }

 private:
  Document& m_document;
  std::optional<double> m_radius;
};

class GlobeUi : public RigidPartsUi {
 public:
  GlobeUi(const WindowContext& parts, QString sample) : RigidPartsUi(parts, {"Globe"}), m_sample(std::move(sample)) {}

  std::vector<StartAction> startActions() const override {
    return {{"newGlobe", "New &globe", "Start with a globe", panelIcon()},
            {"openGlobe", "Open the sample g&lobe", "A globe", panelIcon(), m_sample,
             StartTile{"globeTile", panelIcon(), "Look at a globe", "It is round, nearly."}}};
  }
  QString panelTitle() const override { return "Shape of the globe"; }
  QString panelIcon() const override { return "file"; }
  QString menuTitle() const override { return "&Globe"; }
  std::vector<ToolDescriptor> tools() override {
    const auto make = [this] { return std::make_unique<GrowTool>(document()->document); };
    return {{"growTool", "Gro&w", "Make it larger", panelIcon(), {}, make, "grow", {}}, measureParts()};
  }
  void showPreview(const ToolPreview& preview) override {
    RigidPartsUi::showPreview(preview);
    const auto* own = dynamic_cast<const GlobePreview*>(preview.ofKind.get());
    previewed = own ? std::optional(own->radius) : std::nullopt;
  }
  std::optional<double> previewed;  // in its own terms

  QString statistics() const override {
    return document() ? QString::number(radiusOf(*document()->document.snapshot())) : QString();
  }
  QString openedText(const DocumentTab& opened) const override { return "Opened the globe " + opened.document.name(); }

 private:
  QString m_sample;
};

// sample: a file of it.
inline KindEntry globeEntry(const QString& sample) {
  return {std::make_unique<GlobeKind>(),
          [sample](const WindowContext& parts) { return std::make_unique<GlobeUi>(parts, sample); }};
}

}  // namespace handwheel::test
