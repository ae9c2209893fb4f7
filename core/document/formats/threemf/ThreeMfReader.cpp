// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/threemf/ThreeMfReader.h"

#include "document/Container.h"
#include "document/formats/threemf/ThreeMfBuild.h"
#include "document/formats/threemf/ThreeMfModelReader.h"
#include "document/formats/threemf/ThreeMfPackage.h"

namespace handwheel {

namespace {

constexpr std::size_t kMostParts = 10'000;

class ThreeMfParser {
 public:
  ThreeMfParser(std::string_view bytes, const ReadOptions& options, Progress progress)
      : m_assembly(options, progress, 0), m_package(bytes, m_assembly, progress), m_isPartial(options.partial) {}

  Result<MeshFile> read() {
    m_assembly.expect(m_package.modelBytes());
    std::string root;
    if (m_package.findModel(root) && readPart(root) && readReferredParts()) {
      const ThreeMfPart& part = m_parts[root];
      const bool withoutBuild = m_isPartial && part.items.empty();
      ThreeMfBuild([this](const std::string& path) { return find(path); }, m_assembly).build(part, withoutBuild);
    }
    return m_assembly.finish(NumberType::Float64, true);
  }

 private:
  bool readPart(const std::string& name) {
    std::string text;
    if (m_parts.size() >= kMostParts)
      return m_assembly.fail({ErrorCode::FileTooLarge, {"parts", "", std::to_string(kMostParts)}, {}, {}});
    ThreeMfPart& part = m_parts[name];
    if (!m_package.read(name, text) || !readThreeMfModel(text, name, m_bytesRead, m_assembly, part)) return false;
    m_bytesRead += text.size();
    for (const ThreeMfReference& item : part.items) m_paths.push_back(item.part);
    for (const auto& [id, object] : part.objects)
      for (const ThreeMfReference& component : object.components) m_paths.push_back(component.part);
    return true;
  }

  // Reads the parts that are referred to. The build reports missing ones.
  bool readReferredParts() {
    while (!m_paths.empty()) {
      const std::string name = m_package.entryFor(m_paths.back());
      m_paths.pop_back();
      if (!name.empty() && !m_parts.contains(name) && !readPart(name)) return false;
    }
    return true;
  }

  const ThreeMfPart* find(const std::string& path) const {
    const auto found = m_parts.find(m_package.entryFor(path));
    return found == m_parts.end() ? nullptr : &found->second;
  }

  MeshAssembly m_assembly;
  ThreeMfPackage m_package;
  bool m_isPartial;
  std::uint64_t m_bytesRead = 0;
  std::map<std::string, ThreeMfPart> m_parts;
  std::vector<std::string> m_paths;  // paths of parts that may still be unread
};

}  // namespace

Result<MeshFile> readThreeMf(std::string_view bytes, const ReadOptions& options, Progress progress) {
  return ThreeMfParser(bytes, options, progress).read();
}

bool looksLikeThreeMf(std::string_view bytes) {
  return bytes.starts_with(std::string_view("PK\3\4", 4)) && !looksLikeContainer(bytes);
}

}  // namespace handwheel
