// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ReadDescription.h"
#include "document/container/ZipWriter.h"

// 3MF files for tests, composed of text.
namespace handwheel::test {

// A tetrahedron at the origin. kTetrahedron is its description.
inline const QByteArray kMesh =
    "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/>"
    "<vertex x='0' y='0' z='1'/></vertices><triangles><triangle v1='0' v2='2' v3='1'/><triangle v1='0' v2='1' v3='3'/>"
    "<triangle v1='1' v2='2' v3='3'/><triangle v1='2' v2='0' v3='3'/></triangles></mesh>";
inline const QString kTetrahedron = "0 0 0, 1 0 0, 0 1 0, 0 0 1 | 0 2 1, 0 1 3, 1 2 3, 2 0 3";

inline QByteArray relationships(const QByteArray& target) {
  return "<Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'><Relationship Id='r' "
         "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel' Target='" +
         target + "'/></Relationships>";
}

inline QByteArray package(const std::vector<std::pair<QByteArray, QByteArray>>& parts,
                          Compression compression = Compression::Fast) {
  std::vector<ZipEntry> entries;
  for (const auto& [name, text] : parts)
    entries.push_back({name.constData(), {text.constData(), static_cast<std::size_t>(text.size())}});
  return QByteArray::fromStdString(*writeZip(entries, compression));
}

inline QByteArray package(const QByteArray& model) {
  return package({{"_rels/.rels", relationships("/3D/3dmodel.model")}, {"3D/3dmodel.model", model}});
}

inline QByteArray model(const QByteArray& resources, const QByteArray& build, const QByteArray& attributes = "") {
  return "<?xml version='1.0' encoding='UTF-8'?>\n<model " + attributes +
         " xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02' "
         "xmlns:m='http://schemas.microsoft.com/3dmanufacturing/material/2015/02' "
         "xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06'>\n<resources>" +
         resources + "</resources>\n<build>" + build + "</build></model>";
}

inline QByteArray object(int id, const QByteArray& content, const QByteArray& attributes = "") {
  return "<object id='" + QByteArray::number(id) + "' " + attributes + ">" + content + "</object>\n";
}

inline QByteArray components(const std::vector<std::pair<int, QByteArray>>& list) {
  QByteArray text = "<components>";
  for (const auto& [id, attributes] : list)
    text += "<component objectid='" + QByteArray::number(id) + "' " + attributes + "/>";
  return text + "</components>";
}

inline QByteArray item(int id, const QByteArray& attributes = "") {
  return "<item objectid='" + QByteArray::number(id) + "' " + attributes + "/>";
}

inline QByteArray mesh(const QByteArray& vertices, const QByteArray& triangles) {
  return "<mesh><vertices>" + vertices + "</vertices><triangles>" + triangles + "</triangles></mesh>";
}

// A triangle. kTriangle is its description.
inline const QByteArray kTriangleMesh =
    mesh("<vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/>",
         "<triangle v1='0' v2='1' v3='2'/>");

inline QString readModel(const QByteArray& resources, const QByteArray& build, const QByteArray& attributes = "",
                         bool partial = false) {
  return describe(read(package(model(resources, build, attributes)), partial));
}

// Returns the error of reading a file; Cancelled, which reading never returns in tests, if there is no error.
inline ErrorCode codeOf(const QByteArray& bytes, bool partial = false) {
  const auto file = read(bytes, partial);
  return file ? ErrorCode::Cancelled : file.error().code;
}

}  // namespace handwheel::test
