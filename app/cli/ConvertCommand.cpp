// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ConvertCommand.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "document/mesh/MeshExport.h"
#include "text/NoteText.h"

#include <algorithm>

namespace handwheel {

namespace {

struct Conversion {
  std::vector<Error> damage;
  std::size_t unlistedDamage = 0;
  std::vector<LostAttribute> lost;
  bool wasRounded = false;
  std::vector<Note> notes;
};

bool changesByRounding(const TriangleSoup& soup, NumberType numbers) {
  return std::any_of(soup.points.begin(), soup.points.end(), [&](const Vec3& p) { return rounded(p, numbers) != p; });
}

// A document of another kind than a mesh, or one that goes into a container.
Result<Conversion> convertDocument(const OpenedFile& opened, const std::filesystem::path& output, Job& job) {
  job.startWriting();
  const auto written = saveDocument(*opened.kind, opened.file, *opened.content, output, job.progress().part(0.4, 1.0));
  if (!written) return written.error();
  return Conversion{opened.file.damage, opened.file.unlistedDamage, opened.file.lost, false, written->notes};
}

Result<Conversion> convert(const std::filesystem::path& input, const std::filesystem::path& output, bool partial,
                           const DocumentKinds& kinds, Job& job) {
  const Progress progress = job.progress();
  const ReadOptions options{.partial = partial};
  if (isContainerName(output)) {
    const Result<OpenedFile> opened = kinds.open(input, options, progress.part(0.0, 0.4));
    return opened ? convertDocument(*opened, output, job) : Result<Conversion>(opened.error());
  }
  const Result<Input> read = readInput(input, options, kinds, progress.part(0.0, 0.4));
  if (!read) return read.error();
  if (!read->mesh) return convertDocument(read->document, output, job);
  const Result<MeshFormat> format = formatForOutput(output);
  if (!format) return format.error();
  const MeshFile* file = &*read->mesh;
  const NumberType numbers = numberTypeOf(*format, file->numbers);
  const Result<std::string> bytes = encodeChecked(file->soup, *format, numbers, progress.part(0.4, 0.9));
  if (!bytes) {
    Error error = bytes.error();
    error.subject = output.string();
    return error;
  }
  job.startWriting();
  const Status written = writeFileAtomically(output, *bytes, progress.part(0.9, 1.0));
  if (!written) return written.error();
  return Conversion{file->damage, file->unlistedDamage, file->lost, changesByRounding(file->soup, numbers), {}};
}

}  // namespace

CommandSpec convertSpec() {
  return {
      "convert",
      "IN OUT",
      "Writes a document in another format, by OUT's ending: .handwheel for all kinds; meshes also .stl, .ply, .obj,\n"
      ".off and .3mf, workpieces .step. The triangles of a mesh stay the same, in the same order; nothing is repaired.",
      {
          {"partial", 0, "", "Read what is readable of a damaged file"},
          {"help", 'h', "", "Show this page"},
      }};
}

int runConvert(const Arguments& arguments, const DocumentKinds& kinds) {
  std::optional<Result<Conversion>> result;
  runInterruptible("Converting", [&](Job& job) {
    result = convert(arguments.operands[0], arguments.operands[1], arguments.has("partial"), kinds, job);
  });
  if (!*result) return fail(result->error());
  const Conversion& done = result->value();
  tellLosses(done.damage, done.unlistedDamage, done.lost);
  for (const Note& note : done.notes) complain(noteText(note).toStdString());
  if (done.wasRounded) complain("The coordinates are rounded to the single precision of the format.");
  return kExitDone;
}

}  // namespace handwheel
