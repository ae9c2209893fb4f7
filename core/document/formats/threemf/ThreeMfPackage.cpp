// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/threemf/ThreeMfPackage.h"

#include "document/container/ArchiveErrors.h"
#include "document/formats/threemf/XmlText.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr UnpackLimits kPackageLimits{.largest = std::uint64_t{3} << 30, .allowance = std::uint64_t{256} << 20};
constexpr std::size_t kLongestRelationships = 16 << 20;

constexpr const char* kRelationshipsEntry = "_rels/.rels";
constexpr const char* kUsualModel = "3D/3dmodel.model";
const QString kModelType = QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel");

std::string lowerCase(std::string_view name) {
  std::string lower(name);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

bool isModel(const std::string& name) {
  return lowerCase(name).ends_with(".model");
}

// Returns the target of the first relationship of the model's type; empty if there is none.
std::string modelTarget(std::string_view text) {
  QXmlStreamReader xml(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size())));
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement || xml.name() != QLatin1String("Relationship")) continue;
    const QXmlStreamAttributes attributes = xml.attributes();
    if (attributes.value(QLatin1String("Type")) != kModelType) continue;
    const QByteArray target = attributes.value(QLatin1String("Target")).toUtf8();
    return QByteArray::fromPercentEncoding(target).toStdString();
  }
  return {};
}

}  // namespace

ThreeMfPackage::ThreeMfPackage(std::string_view archive, MeshAssembly& assembly, Progress progress)
    : m_zip(archive, kPackageLimits, progress), m_assembly(assembly), m_progress(progress) {
  for (const std::string& name : m_zip.names()) m_names.emplace(lowerCase(name), name);
}

std::uint64_t ThreeMfPackage::modelBytes() const {
  std::uint64_t bytes = 0;
  for (const std::string& name : m_zip.names())
    if (isModel(name)) bytes += m_zip.announcedSize(name);
  return bytes;
}

std::string ThreeMfPackage::entryFor(std::string_view reference) const {
  while (reference.starts_with('/')) reference.remove_prefix(1);
  const auto found = m_names.find(lowerCase(reference));
  return found == m_names.end() ? std::string() : found->second;
}

bool ThreeMfPackage::readBytes(const std::string& name, std::string& bytes) {
  Result<std::string> read = m_zip.read(name);
  if (read) {
    bytes = std::move(read.value());
    return true;
  }
  const ErrorCode code = read.error().code;
  if (code != ArchiveError::EntryDamaged && code != ArchiveError::EntryMissing) return m_assembly.fail(read.error());
  if (!m_assembly.tolerate(read.error())) return false;
  bytes = m_zip.readDamaged(name);
  return true;
}

bool ThreeMfPackage::read(const std::string& name, std::string& text) {
  if (!readBytes(name, text)) return false;
  auto objection = objectionToXml(text, m_progress);
  if (!objection) {
    blankXmlDeclaration(text);
    return true;
  }
  objection->subject = name;
  return m_assembly.fail(*objection);
}

bool ThreeMfPackage::findModel(std::string& name) {
  if (!m_zip.directoryProblem().empty() &&
      !m_assembly.tolerate({ArchiveError::Malformed, {m_zip.directoryProblem()}, {}, {}}))
    return false;
  std::string relationships;
  const std::string entry = entryFor(kRelationshipsEntry);
  if (!read(entry.empty() ? kRelationshipsEntry : entry, relationships)) return false;
  if (relationships.size() <= kLongestRelationships) name = entryFor(modelTarget(relationships));
  if (!name.empty()) return true;
  if (!m_assembly.tolerate({ErrorCode::ReferenceMissing, {"the 3D model", kRelationshipsEntry}, {}, {}})) return false;
  name = entryFor(kUsualModel);
  const auto model = std::find_if(m_zip.names().begin(), m_zip.names().end(), isModel);
  if (name.empty() && model != m_zip.names().end()) name = *model;
  return !name.empty() || m_assembly.fail({ArchiveError::EntryMissing, {kUsualModel}, {}, {}});
}

}  // namespace handwheel
