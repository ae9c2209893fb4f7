// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyImport.h"

#include "document/scene/BodyChanges.h"
#include "document/scene/BodyErrors.h"
#include "document/scene/BodyLinks.h"
#include "mesh/structure/MeshErrors.h"

namespace handwheel {

Result<ReadBody> readBody(const DocumentKinds& kinds, const std::filesystem::path& path, bool isLinked,
                          Progress progress) {
  ReadBody read;
  if (isLinked) {  // before it is read: what changes meanwhile counts as a change
    Result<BodyLink> link = linkTo(path, progress.part(0.0, 0.2));
    if (!link) return link.error();
    read.body.link = std::move(link).value();
  }
  Result<OpenedFile> opened = kinds.open(path, {}, progress.part(0.2, 0.9));
  if (!opened) return opened.error();
  read.damage = std::move(opened->file.damage);
  read.body.geometry = opened->kind->bodyGeometry(*opened->content);
  if (!read.body.geometry) return Error{MeshError::NoTriangles, {}, {}, path.string()};
  const std::string name = path.stem().string();
  read.body.name = isBodyName(name) ? name : "body";
  return read;
}

Result<ReadBody> updatedFromLink(const DocumentKinds& kinds, const Body& body, const std::filesystem::path& folder,
                                 Progress progress) {
  if (!body.link) return Error{BodyError::NotLinked, {body.name}, {}, {}};
  const std::filesystem::path path = locateLink(*body.link, folder);
  if (path.empty()) return Error{BodyError::LinkedFileGone, {body.link->path}, {}, {}};
  Result<ReadBody> read = readBody(kinds, path, true, progress);
  if (!read) return read.error();
  Body updated = body;
  updated.geometry = std::move(read->body.geometry);
  updated.link = std::move(read->body.link);
  read->body = std::move(updated);
  return read;
}

}  // namespace handwheel
