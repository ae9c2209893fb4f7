// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshExport.h"

#include "document/DocumentErrors.h"
#include "document/formats/MeshFormatTable.h"
#include "document/formats/RoundingCollisions.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/Weld.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleIntersection.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {

namespace {

Error cancelledExport() {
  return {ErrorCode::Cancelled, {}, {}, {}};
}

// Compares the corners. Also true if cancelled.
bool sameCorners(const TriangleSoup& meant, NumberType numbers, const TriangleSoup& found, Progress progress) {
  if (meant.triangles.size() != found.triangles.size()) return false;
  for (std::size_t i = 0; i < meant.triangles.size(); ++i) {
    if (!pollProgress(i, meant.triangles.size(), progress)) break;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 expected = rounded(meant.points[meant.triangles[i][k]], numbers);
      if (found.points[found.triangles[i][k]] != expected) return false;
    }
  }
  return true;
}

std::size_t countDegenerate(const TriangleSoup& soup) {
  return static_cast<std::size_t>(std::count_if(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
    return isDegenerate({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]});
  }));
}

// Describes the mesh as another program will find it in the file.
std::vector<Note> stateOf(const MeshReport& report) {
  std::vector<Note> notes{{QT_TRANSLATE_NOOP("Note", "The file: %1."), {}, false, report}};
  if (report.boundaryEdges + report.nonManifoldEdges + report.inconsistentEdges + report.nonManifoldVertices == 0)
    return notes;
  notes.push_back({QT_TRANSLATE_NOOP("Note",
                                     "It has %1 open edges, %2 edges with more than two triangles, %3 edges with "
                                     "inconsistent orientation and %4 non-manifold vertices."),
                   {std::to_string(report.boundaryEdges), std::to_string(report.nonManifoldEdges),
                    std::to_string(report.inconsistentEdges), std::to_string(report.nonManifoldVertices)}});
  return notes;
}

}  // namespace

std::vector<FileFormat> meshFileFormats() {
  return meshFormatTable().fileFormats();
}

std::vector<Note> notesOn(const ExportReport& report) {
  std::vector<Note> notes = stateOf(report.inFile);
  if (report.roundingPairs > 0) {
    notes.push_back({QT_TRANSLATE_NOOP("Note",
                                       "Rounded to the numbers of this format, %1 more pairs of triangles intersect. "
                                       "3MF, PLY, OBJ and OFF keep all digits."),
                     {std::to_string(report.roundingPairs)},
                     true});
  }
  if (report.roundingDegenerate > 0) {
    notes.push_back({QT_TRANSLATE_NOOP("Note",
                                       "Rounded to the numbers of this format, %1 more triangles have no area. "
                                       "3MF, PLY, OBJ and OFF keep all digits; or move the part to the origin."),
                     {std::to_string(report.roundingDegenerate)},
                     true});
  }
  if (!report.parted.empty()) {
    notes.push_back(
        {QT_TRANSLATE_NOOP("Note",
                           "Vertices moved apart in the last digits that the file can hold, so that it does not "
                           "weld them: %1."),
         {std::to_string(report.parted.size())}});
  }
  return notes;
}

Result<MeshFormat> formatForOutput(const std::filesystem::path& path) {
  const auto format = formatForName(path.filename().string());
  if (format && meshFormatTable().row(*format).write) return *format;
  return unknownEnding(path, writtenEndings(meshFileFormats()));
}

Result<std::string> encodeChecked(const TriangleSoup& soup, MeshFormat format, NumberType numbers, Progress progress) {
  std::string bytes = writeMesh(soup, format, numbers, progress.part(0.0, 0.4));
  if (progress.cancelled()) return cancelledExport();
  const Result<MeshFile> back = readMesh(bytes, {}, {}, progress.part(0.4, 0.9));
  if (progress.cancelled()) return cancelledExport();
  if (!back && back.error().code == ErrorCode::OutOfMemory) return back.error();
  if (!back) return Error{DocumentError::CheckFailed, {"it cannot be opened"}, back.error().position, {}};
  const bool isSame = sameCorners(soup, numbers, back->soup, progress.part(0.9, 1.0));
  if (progress.cancelled()) return cancelledExport();
  if (!isSame) return Error{DocumentError::CheckFailed, {"its triangles differ"}, {}, {}};
  progress.set(1.0);
  return bytes;
}

Result<EncodedMesh> encodeMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                               Progress progress) {
  const Result<MeshFormat> format = formatForOutput(path);
  if (!format) return format.error();
  const NumberType numbers = numberTypeOf(*format, documentNumbers);

  HalfEdgeMesh::Compact compact = mesh.compact();
  if (progress.cancelled()) return cancelledExport();
  EncodedMesh encoded;
  TriangleSoup forFile = compact.soup;
  roundPoints(forFile, numbers);
  for (std::size_t i = 0; i < forFile.points.size(); ++i)
    encoded.report.roundingMove =
        std::max(encoded.report.roundingMove, (forFile.points[i] - compact.soup.points[i]).norm());
  progress.set(0.1);
  if (progress.cancelled()) return cancelledExport();
  for (std::uint32_t v : separateRoundedVertices(compact.soup, forFile, progress.part(0.1, 0.2)))
    encoded.report.parted.push_back(compact.vertexOf[v]);
  progress.set(0.2);
  if (progress.cancelled()) return cancelledExport();

  Result<std::string> bytes = encodeChecked(forFile, *format, numbers, progress.part(0.2, 0.8));
  if (!bytes) {
    Error error = bytes.error();
    error.subject = path.string();
    return error;
  }
  encoded.report.inFile = reportOn(forFile, SelfIntersections::Count, progress.part(0.8, 0.95));
  const std::size_t pairs = encoded.report.inFile.selfIntersectingPairs.value_or(0);
  if (pairs > 0 && encoded.report.roundingMove > 0.0) {  // thin parts may lose their thickness
    const auto before = selfIntersections(compact.soup.points, compact.soup.triangles, progress.part(0.95, 1.0));
    if (before && before->size() < pairs) encoded.report.roundingPairs = pairs - before->size();
  }
  if (encoded.report.inFile.degenerateFaces > 0 && encoded.report.roundingMove > 0.0) {
    const std::size_t before = countDegenerate(compact.soup), now = encoded.report.inFile.degenerateFaces;
    encoded.report.roundingDegenerate = now - std::min(before, now);
  }
  if (progress.cancelled()) return cancelledExport();
  encoded.report.bytes = bytes->size();
  encoded.bytes = std::move(bytes.value());
  return encoded;
}

Result<ExportReport> exportMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                                Progress progress) {
  Result<EncodedMesh> encoded = encodeMesh(mesh, documentNumbers, path, progress.part(0.0, 0.9));
  if (!encoded) return encoded.error();
  const Status written = writeFileAtomically(path, encoded->bytes, progress.part(0.9, 1.0));
  if (!written) return written.error();
  return std::move(encoded->report);
}

}  // namespace handwheel
