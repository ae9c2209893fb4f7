// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/threemf/ThreeMfModelReader.h"

#include "document/formats/MeshFileErrors.h"
#include "document/formats/MeshTextValues.h"
#include "document/formats/threemf/ThreeMfVocabulary.h"
#include "document/formats/threemf/XmlText.h"

#include <QBuffer>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

using namespace threemf;

constexpr std::size_t kDeepestElement = 32;  // elements within each other; the format needs seven

enum class In { File, Model, Resources, Object, Mesh, Vertices, Triangles, Components, Build, Leaf, Foreign };

struct Step {
  const char16_t* name;
  In parent;
  In child;
};
constexpr Step kSteps[] = {{u"model", In::File, In::Model},
                           {u"resources", In::Model, In::Resources},
                           {u"object", In::Resources, In::Object},
                           {u"mesh", In::Object, In::Mesh},
                           {u"vertices", In::Mesh, In::Vertices},
                           {u"vertex", In::Vertices, In::Leaf},
                           {u"triangles", In::Mesh, In::Triangles},
                           {u"triangle", In::Triangles, In::Leaf},
                           {u"components", In::Object, In::Components},
                           {u"component", In::Components, In::Leaf},
                           {u"build", In::Model, In::Build},
                           {u"item", In::Build, In::Leaf}};

class ModelReader {
 public:
  ModelReader(std::string_view text, const std::string& partName, std::uint64_t begin, MeshAssembly& assembly,
              ThreeMfPart& part)
      : m_bytes(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size()))),
        m_buffer(&m_bytes),
        m_partName(partName),
        m_begin(begin),
        m_assembly(assembly),
        m_part(part) {
    m_buffer.open(QIODevice::ReadOnly);
    m_xml.setDevice(&m_buffer);  // a device is decoded block by block, an array as a whole
  }

  bool read() {
    while (!m_xml.atEnd()) {
      m_xml.readNext();
      if (!m_assembly.advance(m_begin + static_cast<std::uint64_t>(m_buffer.pos()))) return false;
      if (m_xml.isStartDocument() && !isUtf8(m_xml.documentEncoding()))
        return m_assembly.fail({MeshFileError::TextEncoding, {asciiOf(m_xml.documentEncoding())}, {}, m_partName});
      if (m_xml.isStartElement() && !enter()) return false;
      if (m_xml.isEndElement() && !leave()) return false;
    }
    if (m_xml.hasError() && !tolerate(malformed("XML", m_xml.errorString().toStdString()))) return false;
    return endObject();  // the text is truncated
  }

 private:
  static bool isUtf8(QStringView encoding) {
    return encoding.isEmpty() || encoding.compare(u"utf-8", Qt::CaseInsensitive) == 0 ||
           encoding.compare(u"us-ascii", Qt::CaseInsensitive) == 0;
  }

  InputPosition inputPosition() const { return InputPosition::line(static_cast<std::uint64_t>(m_xml.lineNumber())); }
  Error malformed(const char* element, std::string what) const {
    return {ErrorCode::ElementMalformed, {element, std::move(what)}, inputPosition(), m_partName};
  }
  bool tolerate(Error error) {
    error.subject = m_partName;
    return m_assembly.tolerate(std::move(error));
  }

  bool enter() {
    if (m_within.size() >= kDeepestElement) return m_assembly.fail(malformed("XML", "it is nested too deeply"));
    const In parent = m_within.empty() ? In::File : m_within.back();
    const bool isCore = m_xml.namespaceUri() == kCore;
    const auto step = std::find_if(std::begin(kSteps), std::end(kSteps), [&](const Step& s) {
      return isCore && s.parent == parent && m_xml.name() == s.name;
    });
    const In child = step == std::end(kSteps) ? In::Foreign : step->child;
    m_within.push_back(child);
    if (parent == In::File && child != In::Model) return m_assembly.fail(malformed("model", "it is not the root"));
    if (child == In::Foreign && parent != In::Foreign)
      m_assembly.lose(lostWith(m_xml.namespaceUri(), m_xml.name()), asciiOf(m_xml.name()));
    return begin(child, parent);
  }

  bool begin(In element, In parent) {
    m_attributes = m_xml.attributes();
    switch (element) {
      case In::Model:
        return beginModel();
      case In::Object:
        return beginObject();
      case In::Leaf:
        break;
      default:
        return true;
    }
    if (parent == In::Vertices) return readVertex();
    if (parent == In::Triangles) return readTriangle();
    return readReference(parent == In::Build ? m_part.items : m_object.components);
  }

  bool leave() {
    const In element = m_within.back();
    m_within.pop_back();
    return element != In::Object || endObject();
  }

  bool beginModel() {
    const QStringView unit = m_attributes.value(QLatin1String("unit"));
    m_scale = unit.isEmpty() ? 1.0 : millimetresPerUnit(unit);
    if (m_scale == 0.0) {
      m_scale = 1.0;
      if (!tolerate(malformed("model", "its unit is '" + asciiOf(unit) + "'"))) return false;
    }
    const QString required = m_attributes.value(QLatin1String("requiredextensions")).toString();
    for (const QString& prefix : required.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
      if (!supports(prefix) &&
          !tolerate({ErrorCode::Unsupported, {"the 3MF extension '" + asciiOf(prefix) + "'"}, inputPosition(), {}}))
        return false;
    }
    return true;
  }

  // Returns true for extensions that do not affect the triangles, or that are read.
  bool supports(const QString& prefix) const {
    for (const QXmlStreamNamespaceDeclaration& declared : m_xml.namespaceDeclarations()) {
      const QStringView uri = declared.namespaceUri();
      if (declared.prefix() == prefix) return uri == kProduction || uri == kMaterials || uri == kTriangleSets;
    }
    return false;
  }

  bool beginObject() {
    m_object = {};
    m_unreadable = 0;
    m_object.isOther = m_attributes.value(QLatin1String("type")) == QLatin1String("other");
    if (m_attributes.hasAttribute(QLatin1String("pid"))) m_assembly.lose(LostAttribute::Materials);
    m_hasObject = readNumber32("object", "id", m_objectId);
    return m_hasObject || m_ok;
  }

  // Puts the object into the part, if there is one.
  bool endObject() {
    if (!std::exchange(m_hasObject, false)) return true;
    if (m_unreadable > 0) dropUnreadable();
    if (m_part.objects.try_emplace(m_objectId, std::move(m_object)).second) return true;
    return tolerate(malformed("object", "its number " + std::to_string(m_objectId) + " is already in use"));
  }

  bool readVertex() {
    Vec3 point;
    const QLatin1String names[] = {QLatin1String("x"), QLatin1String("y"), QLatin1String("z")};
    for (int axis = 0; axis < 3; ++axis) {
      const std::string text = asciiOf(m_attributes.value(names[axis]));
      ErrorCode why = ErrorCode::NumberMalformed;
      double value = 0.0;
      const bool isRead = parseNumber(text, value, why);
      point[axis] = rounded(value * m_scale, NumberType::Float64);
      if (isRead && std::isfinite(point[axis])) continue;
      if (!tolerate(wordError(isRead ? ErrorCode::NumberNotFinite : why, text, inputPosition()))) return false;
      ++m_unreadable;
      point.x() = std::numeric_limits<double>::quiet_NaN();
      break;
    }
    m_object.mesh.points.push_back(point);
    return true;
  }

  bool readTriangle() {
    TriangleSoup& mesh = m_object.mesh;
    Triangle triangle;
    const char* const names[] = {"v1", "v2", "v3"};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!readNumber32("triangle", names[k], triangle[k])) return m_ok;
      const std::uint32_t v = triangle[k];
      if (v >= mesh.points.size())
        return tolerate({MeshFileError::IndexOutOfRange,
                         {std::to_string(v), std::to_string(mesh.points.size())},
                         inputPosition(),
                         {}});
      if (m_unreadable > 0 && std::isnan(mesh.points[v].x()))
        return tolerate({MeshFileError::VertexUnreadable, {std::to_string(v)}, inputPosition(), {}});
    }
    if (m_attributes.size() > 3) m_assembly.lose(LostAttribute::Materials);
    mesh.triangles.push_back(triangle);
    return true;
  }

  bool readReference(std::vector<ThreeMfReference>& to) {
    ThreeMfReference reference;
    reference.position = inputPosition();
    reference.part = m_attributes.value(kProduction, QLatin1String("path")).toUtf8().toStdString();
    if (!readNumber32("item", "objectid", reference.object)) return m_ok;
    const QStringView transform = m_attributes.value(QLatin1String("transform"));
    if (!transform.isEmpty() && !parseTransform(asciiOf(transform), reference.transform))
      return tolerate(malformed("transform", "it is not twelve numbers"));
    reference.transform.translation() *= m_scale;
    to.push_back(std::move(reference));
    return true;
  }

  // Returns false if it is no such number; m_ok then tells if that is tolerated.
  bool readNumber32(const char* element, const char* attribute, std::uint32_t& number) {
    const std::string text = asciiOf(m_attributes.value(QLatin1String(attribute)));
    const auto value = parseInteger(text);
    if (value && *value >= 0 && *value < kNone) {
      number = static_cast<std::uint32_t>(*value);
      return true;
    }
    m_ok = tolerate(text.empty() ? malformed(element, std::string("it has no ") + attribute)
                                 : wordError(ErrorCode::NumberMalformed, text, inputPosition()));
    return false;
  }

  void dropUnreadable() {
    auto& [points, triangles] = m_object.mesh;
    std::vector<std::uint32_t> renumbered(points.size(), kNone);
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (std::isnan(points[i].x())) continue;
      points[kept] = points[i];
      renumbered[i] = kept++;
    }
    points.resize(kept);
    for (Triangle& triangle : triangles)
      for (std::uint32_t& corner : triangle) corner = renumbered[corner];
  }

  QByteArray m_bytes;
  QBuffer m_buffer;
  QXmlStreamReader m_xml;
  const std::string& m_partName;
  std::uint64_t m_begin;
  MeshAssembly& m_assembly;
  ThreeMfPart& m_part;
  std::vector<In> m_within;
  QXmlStreamAttributes m_attributes;  // attributes of the element that was entered last
  double m_scale = 1.0;               // millimetres per unit
  ThreeMfObject m_object;             // being read
  std::uint32_t m_objectId = 0;
  bool m_hasObject = false;
  std::size_t m_unreadable = 0;  // its points that are NaN
  bool m_ok = true;
};

}  // namespace

bool readThreeMfModel(std::string_view text, const std::string& partName, std::uint64_t begin, MeshAssembly& assembly,
                      ThreeMfPart& part) {
  return ModelReader(text, partName, begin, assembly, part).read();
}

}  // namespace handwheel
