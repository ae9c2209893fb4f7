// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ConvertCommand.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/Wording.h"
#include "document/MeshExport.h"

#include <algorithm>

namespace handwheel {

namespace {

struct Conversion {
  std::vector<Error> damage;
  std::size_t unlistedDamage = 0;
  std::vector<LostAttribute> lost;
  bool wasRounded = false;
};

bool changesByRounding(const TriangleSoup& soup, NumberType numbers) {
  return std::any_of(soup.points.begin(), soup.points.end(), [&](const Vec3& p) { return rounded(p, numbers) != p; });
}

Result<Conversion> convert(const std::filesystem::path& input, const std::filesystem::path& output, bool partial,
                           Job& job) {
  const Progress progress = job.progress();
  const Result<MeshFormat> format = formatForOutput(output);
  if (!format) return format.error();
  const Result<MeshFile> file = readMeshFile(input, {.partial = partial}, progress.part(0.0, 0.4));
  if (!file) return file.error();
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
  return Conversion{file->damage, file->unlistedDamage, file->lost, changesByRounding(file->soup, numbers)};
}

}  // namespace

CommandSpec convertSpec() {
  return {
      "convert",
      "IN OUT",
      "Writes a mesh in another format. OUT's ending names it: .stl, .ply, .obj or .off. The triangles stay the same,\n"
      "in the same order; nothing is repaired.",
      {
          {"partial", 0, "", "Read what is readable of a damaged file"},
          {"help", 'h', "", "Show this page"},
      }};
}

int runConvert(const Arguments& arguments) {
  std::optional<Result<Conversion>> result;
  runInterruptible("Converting", [&](Job& job) {
    result = convert(arguments.operands[0], arguments.operands[1], arguments.has("partial"), job);
  });
  if (!*result) return fail(result->error());
  const Conversion& done = result->value();
  for (const std::string& note : damageSentences(done.damage, done.unlistedDamage)) complain(note);
  if (!done.lost.empty()) complain("Not kept: " + listOf(done.lost) + ".");
  if (done.wasRounded) complain("The coordinates are rounded to the single precision of the format.");
  return kExitDone;
}

}  // namespace handwheel
