// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/threemf/ThreeMfWriter.h"

#include "document/container/ZipWriter.h"
#include "mesh/structure/CancelPolling.h"

#include <array>
#include <charconv>

namespace handwheel {

namespace {

constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr std::string_view kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

template <class Number>
void appendAttribute(std::string& to, std::string_view name, Number value) {
  char digits[32];  // the longest shortest double has 24
  to += name;
  to.append(digits, std::to_chars(std::begin(digits), std::end(digits), value).ptr);
  to += '"';
}

const char* wordFor(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Centimetre:
      return "centimeter";
    case LengthUnit::Metre:
      return "meter";
    case LengthUnit::Inch:
      return "inch";
    case LengthUnit::Millimetre:
      break;
  }
  return "millimeter";
}

// Returns the text of the model, or its beginning if cancelled.
std::string modelText(const TriangleSoup& soup, NumberType numbers, LengthUnit unit, Progress progress) {
  std::string text = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit=")" + std::string(wordFor(unit)) +
                     R"(" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<resources><object id="1" type="model"><mesh><vertices>
)";
  const std::size_t points = soup.points.size(), triangles = soup.triangles.size();
  for (std::size_t i = 0; i < points; ++i) {
    if (!pollProgress(i, points, progress.part(0.0, 0.5))) return text;
    const Vec3& point = soup.points[i];
    const Vec3 p = rounded(point, numbers);
    appendAttribute(text, "<vertex x=\"", p.x());
    appendAttribute(text, " y=\"", p.y());
    appendAttribute(text, " z=\"", p.z());
    text += "/>\n";
  }
  text += "</vertices><triangles>\n";
  for (std::size_t i = 0; i < triangles; ++i) {
    if (!pollProgress(i, triangles, progress.part(0.5, 1.0))) return text;
    const Triangle& t = soup.triangles[i];
    appendAttribute(text, "<triangle v1=\"", t[0]);
    appendAttribute(text, " v2=\"", t[1]);
    appendAttribute(text, " v3=\"", t[2]);
    text += "/>\n";
  }
  text += "</triangles></mesh></object></resources>\n<build><item objectid=\"1\"/></build>\n</model>\n";
  return text;
}

}  // namespace

std::string writeThreeMf(const TriangleSoup& soup, NumberType numbers, Progress progress) {
  return writeThreeMf(soup, numbers, LengthUnit::Millimetre, progress);
}

std::string writeThreeMf(const TriangleSoup& soup, NumberType numbers, LengthUnit unit, Progress progress) {
  const std::string model = modelText(soup, numbers, unit, progress.part(0.0, 0.3));
  if (progress.cancelled()) return {};
  const std::array<ZipEntry, 3> entries = {
      {{"[Content_Types].xml", kContentTypes}, {"_rels/.rels", kRelationships}, {"3D/3dmodel.model", model}}};
  Result<std::string> archive = writeZip(entries, Compression::Fast, progress.part(0.3, 1.0));
  return archive ? std::move(archive.value()) : std::string();
}

}  // namespace handwheel
