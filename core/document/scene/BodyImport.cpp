// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyImport.h"

#include "base/NumberText.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyErrors.h"
#include "document/scene/BodyLinks.h"
#include "mesh/structure/MeshErrors.h"

#include <QtGlobal>

namespace handwheel {

namespace {

Note sizeNote(const BodyGeometry& geometry) {
  const Vec3 size = geometry.bounds().sizes();
  return {QT_TRANSLATE_NOOP("Note", "The body measures %1 × %2 × %3 mm."),
          {shownText(size.x()), shownText(size.y()), shownText(size.z())}};
}

}  // namespace

Result<ImportedBody> readBody(const DocumentKinds& kinds, const std::filesystem::path& path, bool isLinked,
                              Progress progress) {
  ImportedBody read;
  if (isLinked) {  // before it is read: what changes meanwhile counts as a change
    Result<BodyLink> link = linkTo(path, progress.part(0.0, 0.2));
    if (!link) return link.error();
    read.body.link = std::move(link).value();
  }
  Result<OpenedFile> opened = kinds.open(path, {}, progress.part(0.2, 0.9));
  if (!opened) return opened.error();
  read.file = std::move(opened->file);
  read.body.geometry = opened->kind->bodyGeometry(*opened->content, read.file.notes);
  if (!read.body.geometry) return Error{MeshError::NoTriangles, {}, {}, path.string()};
  read.file.notes.push_back(sizeNote(*read.body.geometry));
  const std::string name = path.stem().string();
  const bool isPrivate = read.file.hasPrivateName;
  read.body.name = isBodyName(name) && !isPrivate ? name : "body";
  if (isPrivate && read.body.link) {
    read.body.link.reset();
    read.file.notes.push_back({QT_TRANSLATE_NOOP(
        "Note", "The body was copied and not linked, as the path of an image often contains the patient's name.")});
  }
  return read;
}

Result<ImportedBody> updatedFromLink(const DocumentKinds& kinds, const Body& body, const std::filesystem::path& folder,
                                     Progress progress) {
  if (!body.link) return Error{BodyError::NotLinked, {body.name}, {}, {}};
  const std::filesystem::path path = locateLink(*body.link, folder);
  if (path.empty()) return Error{BodyError::LinkedFileGone, {body.link->path}, {}, {}};
  Result<ImportedBody> read = readBody(kinds, path, true, progress);
  if (!read) return read.error();
  Body updated = body;
  updated.geometry = std::move(read->body.geometry);
  updated.link = std::move(read->body.link);
  read->body = std::move(updated);
  return read;
}

}  // namespace handwheel
