// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/ConvertCommand.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/MeshKind.h"
#include "text/NoteText.h"

#include <algorithm>

namespace handwheel {

namespace {

struct Conversion {
  DocumentFile file;  // the input file, with its losses on reading
  std::vector<std::string> notes;
  std::string refusal;  // the reason why nothing was written
};

// Converts a document of another kind than a mesh, or one that goes into a container.
Result<Conversion> convertDocument(const OpenedFile& opened, const std::filesystem::path& output, Progress progress) {
  const auto written = saveDocument(*opened.kind, opened.file, *opened.content, output, progress);
  if (!written) return written.error();
  Conversion done{opened.file, {}, {}};
  for (const Note& note : written->notes) done.notes.push_back(noteText(note).toStdString());
  return done;
}

bool changesByRounding(const TriangleSoup& soup, NumberType numbers) {
  return std::any_of(soup.points.begin(), soup.points.end(), [&](const Vec3& p) { return rounded(p, numbers) != p; });
}

// Converts the triangles as they are in the file.
Result<Conversion> convertMesh(const Input& input, const std::filesystem::path& output, Progress progress) {
  const Result<MeshFormat> format = formatForOutput(output);
  if (!format) return format.error();
  const NumberType numbers = numberTypeOf(*format, input.mesh->numbers);
  const Result<std::string> bytes = encodeChecked(input.mesh->soup, *format, numbers, progress.part(0.0, 0.8));
  if (!bytes) {
    Error error = bytes.error();
    error.subject = output.string();
    return error;
  }
  const Status written = writeFileAtomically(output, *bytes, progress.part(0.8, 1.0));
  if (!written) return written.error();
  Conversion done{input.opened.file, {}, {}};
  if (changesByRounding(input.mesh->soup, numbers)) {
    done.notes.push_back("The coordinates are rounded to the single precision of the format.");
  }
  return done;
}

Result<Conversion> convert(const std::filesystem::path& input, const std::filesystem::path& output, bool partial,
                           const DocumentKinds& kinds, Progress progress) {
  const ReadOptions options{.partial = partial};
  const Progress reading = progress.part(0.0, 0.4), writing = progress.part(0.4, 1.0);
  if (!isContainerName(output)) {
    const Result<Input> read = readInput(input, options, kinds, reading);
    if (!read) return read.error();
    const std::string refusal = refusalToReplace(output, read->opened.file);
    if (!refusal.empty()) return Conversion{read->opened.file, {}, refusal};
    // A document keeps coincident but separate vertices separate in the file.
    const bool isFileOfTriangles = read->mesh && !read->meshDocument();
    return isFileOfTriangles ? convertMesh(*read, output, writing) : convertDocument(read->opened, output, writing);
  }
  const Result<OpenedFile> opened = kinds.open(input, options, reading);
  if (!opened) return opened.error();
  const std::string refusal = refusalToReplace(output, opened->file);
  if (!refusal.empty()) return Conversion{opened->file, {}, refusal};
  Result<Conversion> done = convertDocument(*opened, output, writing);
  if (!done || opened->file.isContainer || opened->kind->id() != kMeshKind) return done;
  const auto turned = static_cast<const MeshSnapshot&>(*opened->content).build->reversedFaces.size();
  if (turned > 0)
    done->notes.push_back("Triangles reversed to agree with their neighbours: " + std::to_string(turned) + ".");
  return done;
}

}  // namespace

CommandSpec convertSpec() {
  return {
      "convert",
      "IN OUT",
      "Writes a document in another format, given by the extension of OUT. The triangles of a mesh stay the same, "
      "in the\n"
      "same order; nothing is repaired, but in a .handwheel equal positions are merged to one vertex, and "
      "triangles are\n"
      "reversed to agree with their neighbours. Vertices of a .handwheel that the format would weld so that edges or\n"
      "vertices become non-manifold are moved apart by its last digit.",
      {
          {"partial", 0, "", "Read the undamaged part of a damaged file"},
          {"help", 'h', "", "Show this help"},
      }};
}

std::string convertDetails(const DocumentKinds& kinds) {
  std::string lines = "Extensions by kind of document:\n";
  for (const auto& kind : kinds.all()) {
    lines += "  " + kind->id() + ":";
    for (const std::string& ending : writtenEndings(kind->formats())) lines += " " + ending;
    lines += "\n";
  }
  return lines;
}

int runConvert(const Arguments& arguments, const DocumentKinds& kinds) {
  std::optional<Result<Conversion>> result;
  runInterruptible("Converting", [&](CommandJob& job) {
    result = convert(arguments.operands[0], arguments.operands[1], arguments.has("partial"), kinds, job.progress());
  });
  if (!*result) return fail(result->error());
  const Conversion& done = result->value();
  reportLosses(done.file);
  if (!done.refusal.empty()) return refuse(done.refusal);
  for (const std::string& note : done.notes) complain(note);
  return kExitDone;
}

}  // namespace handwheel
